#include "support/outcome.h"

#include "ways/simulator.h"

namespace extremes {

Outcome watch(const TestScene& scene, double h, int steps, const Method& method) {
  Cloth cloth = scene.cloth;
  const auto simulator = make_simulator({3, method}, cloth);
  struct {
    Counts counts;
  } system;
  return watch(scene, h, steps, system, [&](Cloth&, double dt, State& state, auto& now) {
    simulator->step(dt, state);
    now.counts = simulator->counts();
  });
}

State hanging(const TestScene& scene) {
  Cloth cloth = scene.cloth;
  const auto simulator = make_simulator({3, {Jacobian::definite, 50}}, cloth);
  State state = scene.start;
  double moved = 1;
  for (int i = 0; i < 20 && moved > 1e-6; ++i) {
    const VecX before = state.x;
    state.v.setZero();
    simulator->step(10, state);
    moved = (state.x - before).lpNorm<Eigen::Infinity>();
  }
  state.v.setZero();
  return state;
}

double static_stretch(const TestScene& scene) {
  return max_stretch(scene.mesh, hanging(scene).x);
}

}  // namespace extremes
