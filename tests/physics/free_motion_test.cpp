// A cloth without pins: it falls like a stone, and keeps its momenta while it spins.
#include <gtest/gtest.h>

#include "step01_explicit/time_step.h"
#include "support/momenta.h"
#include "support/reference.h"

namespace free_motion_test {

// Symplectic Euler from rest: v_n = −g n h, and so y_N = −g h² (1 + 2 + … + N). A difference would be an
// internal force, which a flat sheet does not have. The sheet is soft, so that 0.01 s is below its critical
// step, 0.016 s, and rounding errors do not grow.
TEST(FreeFall, OfAFlatSheetIsTheSumOfTheSteps) {
  TestScene scene = sheet(5, Held::free, 10, 5, Gravity::on);
  step01::System system(scene.cloth);
  const double h = 0.01;
  const int N = 100;
  const State end =
      simulate(stepper(scene.cloth, step01::time_step, system), scene.start, N * h, N);
  const double y = -g * h * h * N * (N + 1) / 2;  // −4.95405 m
  for (int i = 0; i < scene.cloth.vertices(); ++i) {
    const Vec3 exact = scene.start.x.segment<3>(3 * i) + Vec3(0, y, 0);
    EXPECT_LT((end.x.segment<3>(3 * i) - exact).norm(), 1e-12 * std::abs(y)) << "vertex " << i;
  }
}

// The forces come in pairs, so Σ m v stays. Their torques cancel, so Σ m x × v stays as well: v_{n+1} moves
// x along itself, and v × v = 0. Other methods, such as backward Euler, lose angular momentum.
TEST(FreeSpin, KeepsLinearAndAngularMomentum) {
  const TestScene scene = thrown_sheet();
  step01::System system(scene.cloth);
  const Stepper step = stepper(scene.cloth, step01::time_step, system);
  const Momenta before = momenta(scene.cloth, scene.start);
  State state = scene.start;
  for (int n = 1; n <= 150; ++n) {
    step(scene.end / 150, state);
    const Momenta now = momenta(scene.cloth, state);
    ASSERT_LT((now.linear - before.linear).norm(), 1e-12 * before.linear_scale) << "step " << n;
    ASSERT_LT((now.angular - before.angular).norm(), 1e-12 * before.angular_scale) << "step " << n;
  }
  // The cloth did stretch; otherwise the test would test nothing.
  step01::forces(scene.cloth, state, system);
  EXPECT_GT(system.f.cwiseAbs().maxCoeff(), 0.1);
}

}  // namespace free_motion_test
