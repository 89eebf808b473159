// Small cloths for the tests of XPBD and VBD, and how far a step is from backward Euler.
#pragma once
#include "support/membranes.h"
#include "support/scenes.h"
#include "ways/simulator.h"
#include "ways/sweeps.h"

namespace ways_test {

inline Model threads(double kd = 0) {
  return Model().add(StretchTerm(100, kd)).add(ShearTerm(50, kd));
}

// A sheet of 4 × 4 cells with this model, disturbed by up to 2 cm, with velocities of up to 0.5 m/s.
inline TestScene disturbed_sheet(Model model, Held held) {
  const Mesh mesh = make_grid({1, 1}, {4, 4}, Diagonals::same);
  model.density = density;
  model.gravity = Vec3(0, -g, 0);
  if (held == Held::by_two_corners) model.pins = {20, 24};
  TestScene scene = at_rest(mesh, model);
  start_terms(scene.cloth, scene.start.x);
  Random random(3);
  scene.start.x += random.vector(int(mesh.x.size()), 0.02);
  scene.start.v = random.vector(int(mesh.x.size()), 0.5);
  for (const Pin& pin : model.pins) scene.start.v.segment<3>(3 * pin.vertex).setZero();
  return scene;
}

inline State after(const TestScene& scene, const Configuration& configuration, double h,
                   int steps = 1) {
  Cloth cloth = scene.cloth;
  State state = scene.start;
  const auto simulator = make_simulator(configuration, cloth);
  for (int n = 0; n < steps; ++n) simulator->step(h, state);
  return state;
}

// |h² M⁻¹ Φ'(x)|, m: how far a step of an undamped cloth is from solving backward Euler.
inline double residual(const TestScene& scene, double h, const State& end) {
  const VecX& w = scene.cloth.inverse_mass;
  VecX f;
  forces(scene.cloth, {end.x, VecX::Zero(end.x.size())}, f);
  VecX sum = h * h * w.cwiseProduct(f) - (end.x - scene.start.x - h * scene.start.v);
  for (const Pin& pin : scene.cloth.pins) sum.segment<3>(3 * pin.vertex).setZero();
  return sum.norm();
}

// Backward Euler to rounding where the printed matrix is definite.
inline const Configuration newton{5,
                                  {.jacobian = Jacobian::bw98, .newton = 50, .tolerance = 1e-13}};

}  // namespace ways_test
