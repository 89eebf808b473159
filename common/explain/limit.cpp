#include "explain/limit.h"

#include "math/energy.h"
#include "math/stable_step.h"

namespace {

double h_crit_of(const Cloth& cloth, const State& start, const Simulate& simulate,
                 const Method& method) {
  return critical_step(cloth, start, simulate(cloth, method).forces);
}

}  // namespace

Limit explicit_limit(const Scene& scene, const std::vector<Part>& parts, const Simulate& simulate,
                     const Method& method) {
  Limit limit = {h_crit_of(scene.cloth, scene.start, simulate, method), {}};
  for (const Part& part : parts)
    limit.without.push_back(h_crit_of(part.cloth, scene.start, simulate, method));
  return limit;
}

double largest_frequency(const Scene& scene) {
  VecX f;
  const auto forces = [&](const State& state) -> const VecX& {
    f.setZero(state.x.size());
    for_each_family(scene.cloth,
                    [&](const auto& family) { add_elastic_forces(family, state.x, f); });
    return f;
  };
  return 2 / critical_step(scene.cloth, scene.start, forces);
}
