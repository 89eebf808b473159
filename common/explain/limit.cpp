#include "explain/limit.h"

#include "math/stable_step.h"

namespace {

struct Forces {
  VecX f;  // N
};

double h_crit_of(const Cloth& cloth, const State& start, const Simulate& simulate,
                 const Method& method) {
  const Simulation simulation = simulate(cloth, method);
  Forces system;
  const auto forces = [&](const Cloth&, const State& state, Forces& sum) {
    sum.f = simulation.forces(state);
  };
  return critical_step(cloth, start, forces, system);
}

// f −= k C ∂C/∂y, carried to the vertices.
template <class Family>
void add_elastic_forces(const Family& family, const VecX& x, VecX& f) {
  for (const auto& element : family.elements) {
    Vecs<Family::Y> f_y = zero_vectors<Family::Y>();
    family.conditions(element, gather(element, x),
                      [&](const Term& term, const auto& c, const auto&) {
                        for (size_t m = 0; m < c.dCdy.size(); ++m)
                          f_y[size_t(c.first) + m] -= term.k * c.C * c.dCdy[m];
                      });
    scatter(element, f_y, f);
  }
}

void elastic_forces(const Cloth& cloth, const State& state, Forces& system) {
  system.f.setZero(state.x.size());
  for_each_family(cloth,
                  [&](const auto& family) { add_elastic_forces(family, state.x, system.f); });
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
  Forces system;
  return 2 / critical_step(scene.cloth, scene.start, elastic_forces, system);
}
