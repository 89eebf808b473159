// Explicit damping lowers the stable step. If kd/k is the same for stretch and shear, damping does not mix
// the modes of the cloth, and symplectic Euler is stable for
//
//   h ω ≤ 2 (√(1 + ζ²) − ζ),   ζ = kd ω/(2k)
//
// in each mode. The highest ω sets the limit.
#include <gtest/gtest.h>

#include "math/stable_step.h"
#include "step02_damping/time_step.h"
#include "support/modes.h"
#include "support/scenes.h"

namespace damping_limit_test {

constexpr double k = 1000;

TestScene damped_sheet(double kd_over_k) {
  TestScene scene = sheet(4, Held::by_two_corners, k, k, Gravity::off);
  scene.cloth.term<StretchTerm>()->kd = scene.cloth.term<ShearTerm>()->kd = kd_over_k * k;
  return scene;
}

double highest_frequency() {
  const TestScene scene = damped_sheet(0);
  step02::System system(scene.cloth);
  const MatX K = stiffness_matrix(scene.cloth, scene.start, step02::forces, system, 1e-6);
  return modes(scene.cloth, K).omega.maxCoeff();
}

// A perturbation of a nanometre in the plane of the sheet, for 20000 steps.
bool grows(const TestScene& scene, double h) {
  step02::System system(scene.cloth);
  State state = scene.start;
  for (int i = 0; i < state.x.size(); ++i)
    if (i % 3 != 1 && scene.cloth.inverse_mass[i] > 0)
      state.v[i] = 1e-6 * std::sin(i * (1 + i % 5));
  for (int n = 0; n < 20000; ++n) {
    step02::time_step(scene.cloth, h, state, system);
    if (!((state.x - scene.start.x).cwiseAbs().maxCoeff() < 1e-6)) return true;
  }
  return false;
}

double stable_step_by_bisection(const TestScene& scene, double low, double high) {
  EXPECT_FALSE(grows(scene, low));
  EXPECT_TRUE(grows(scene, high));
  while (high - low > 2e-4 * low) {
    const double middle = (low + high) / 2;
    (grows(scene, middle) ? high : low) = middle;
  }
  return low;
}

TEST(DampedCriticalStep, FollowsTheTheoryOfOneMode) {
  const double omega = highest_frequency();
  double before = 1e9;
  for (const double zeta : {0.0, 0.01, 0.1, 0.5, 1.0, 2.0}) {
    const TestScene scene = damped_sheet(2 * zeta / omega);
    const double theory = 2 * (std::sqrt(1 + zeta * zeta) - zeta) / omega;
    const double measured = stable_step_by_bisection(scene, 0.95 * theory, 1.05 * theory);
    step02::System system(scene.cloth);
    const double predicted = critical_step(scene.cloth, scene.start, step02::forces, system);
    std::printf("zeta %.2f: h omega = %.5f, by bisection %.5f, by critical_step %.5f\n", zeta,
                theory * omega, measured * omega, predicted * omega);
    EXPECT_NEAR(measured / theory, 1, 1e-3) << "zeta = " << zeta;
    EXPECT_NEAR(predicted / theory, 1, 1e-3) << "zeta = " << zeta;
    EXPECT_LT(measured, before) << "more damping did not lower the limit";
    before = measured;
  }
}

// If stretch and shear are damped differently, there is no formula. critical_step still predicts the runs.
TEST(DampedCriticalStep, IsPredictedWhereModesMixAsWell) {
  TestScene scene = damped_sheet(0);
  scene.cloth.term<StretchTerm>()->kd = 1;
  scene.cloth.term<ShearTerm>()->kd = 0.1;
  step02::System system(scene.cloth);
  const double predicted = critical_step(scene.cloth, scene.start, step02::forces, system);
  const double measured = stable_step_by_bisection(scene, 0.9 * predicted, 1.1 * predicted);
  EXPECT_NEAR(measured / predicted, 1, 2e-3);
}

}  // namespace damping_limit_test
