// Damping takes energy from a moving cloth, and leaves its momentum.
#include <gtest/gtest.h>

#include "math/stable_step.h"
#include "program/diagnostics.h"
#include "step01_explicit/time_step.h"
#include "step02_damping/time_step.h"
#include "support/momenta.h"
#include "support/poses.h"
#include "support/reference.h"

namespace damping_motion_test {

void damp(Cloth& cloth, double kd_stretch, double kd_shear) {
  cloth.term<StretchTerm>()->kd = kd_stretch;
  if (cloth.term<ShearTerm>()) cloth.term<ShearTerm>()->kd = kd_shear;
}

// Internal forces come in pairs, damping forces too: momentum stays and energy falls.
TEST(DampedSpin, KeepsLinearAndAngularMomentumAndLosesEnergy) {
  TestScene scene = thrown_sheet();
  damp(scene.cloth, 0.05, 0.05);
  scene.start.v += Random(61).vector(int(scene.start.v.size()), 1);
  step02::System system(scene.cloth);
  const Momenta before = momenta(scene.cloth, scene.start);
  State state = scene.start, undamped = scene.start;
  step01::System system01(scene.cloth);
  for (int n = 1; n <= 3000; ++n) {
    step02::time_step(scene.cloth, 1e-4, state, system);
    step01::time_step(scene.cloth, 1e-4, undamped, system01);
    const Momenta now = momenta(scene.cloth, state);
    ASSERT_LT((now.linear - before.linear).norm(), 1e-12 * before.linear_scale) << "step " << n;
    ASSERT_LT((now.angular - before.angular).norm(), 1e-12 * before.angular_scale) << "step " << n;
  }
  EXPECT_LT(energies(scene.cloth, state).total(), 0.95 * energies(scene.cloth, undamped).total());
}

// Damping is no drag: the cloth as a whole falls as without damping.
TEST(DampedFall, IsTheFallOfAStone) {
  TestScene scene = sheet(5, Held::free, 10, 5, Gravity::on);
  damp(scene.cloth, 0.01, 0.01);
  step02::System system(scene.cloth);
  const double h = 2e-3;
  const int N = 500;
  const State end =
      simulate(stepper(scene.cloth, step02::time_step, system), scene.start, N * h, N);
  const double y = -g * h * h * N * (N + 1) / 2;
  for (int i = 0; i < scene.cloth.vertices(); ++i) {
    const Vec3 exact = scene.start.x.segment<3>(3 * i) + Vec3(0, y, 0);
    EXPECT_LT((end.x.segment<3>(3 * i) - exact).norm(), 1e-12 * std::abs(y)) << "vertex " << i;
  }
}

// A sheet in its rest shape; every vertex begins with a random velocity. h is well below the limit; 20 frames
// of 50 ms.
TEST(DampedSheet, LosesEnergyAndNeverShowsMuchMoreThanItHad) {
  for (const unsigned seed : {1u, 2u, 3u, 4u})
    for (const double share : {0.1, 0.3}) {
      TestScene scene = sheet(6, Held::free, 1e3, 500, Gravity::off);
      damp(scene.cloth, 0.05, 0.025);
      Random random(seed);
      scene.start.v = random.vector(int(scene.start.x.size()), 1);
      step02::System system(scene.cloth);
      const double h = share * critical_step(scene.cloth, scene.start, step02::forces, system);
      const double before = energies(scene.cloth, scene.start).total();
      State state = scene.start;
      const int steps = int(0.05 / h);
      for (int frame = 1; frame <= 20; ++frame) {
        for (int n = 0; n < steps; ++n) step02::time_step(scene.cloth, h, state, system);
        ASSERT_LT(energies(scene.cloth, state).total(), 1.1 * before)
            << "frame " << frame << ", seed " << seed << ", h = " << share << " h_crit";
      }
      EXPECT_LT(energies(scene.cloth, state).total(), before);
    }
}

// The strip of hanging_test.cpp begins with its unstretched length and bounces until damping has stopped the
// bouncing. A coarse strip is not symmetric, and sways for longer.
double elongation_after_bouncing(int rows, double k) {
  TestScene scene = strip(0.25, {rows / 4, rows}, k, k / 2, Gravity::on);
  damp(scene.cloth, 0.02 * k, 0.04 * k);
  step02::System system(scene.cloth);
  const double h = 0.8 * critical_step(scene.cloth, scene.start, step02::forces, system);
  const double seconds = 480.0 / rows;
  State state = scene.start;
  for (int n = 0; n < seconds / h; ++n) step02::time_step(scene.cloth, h, state, system);
  double lowest = 0, speed = 0;
  for (int i = 0; i <= rows / 4; ++i) {
    lowest += state.x[3 * i + 1] / (rows / 4 + 1);
    speed += state.v[3 * i + 1] / (rows / 4 + 1);
  }
  EXPECT_LT(std::abs(speed), 1e-5) << "not at rest";
  return -lowest - 1;
}

TEST(DampedStrip, ComesToTheExactHangingLength) {
  const double k = 10, exact = density * g / (2 * k);
  double error = 0;
  for (const int rows : {4, 8, 16, 32}) {
    const double before = error;
    error = std::abs(elongation_after_bouncing(rows, k) - exact);
    std::printf("%2d rows: longer by the exact %.6f m to %.2e m", rows, exact, error);
    if (rows > 4) {
      std::printf(", order %.2f", std::log2(before / error));
      EXPECT_GE(std::log2(before / error), 2);
    }
    std::printf("\n");
    EXPECT_LT(error, 2e-3 * exact);
  }
}

}  // namespace damping_motion_test
