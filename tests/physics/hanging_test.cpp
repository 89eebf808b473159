// A strip hangs by its top row, under its own weight. The thread at the depth s carries the weight below it,
// and stretch is linear in |w| at any strain:
//
//   ρ g (L − s) = k (λ(s) − 1)       so the strip is longer by ρ g L²/(2k)
#include <gtest/gtest.h>

#include "step01_explicit/time_step.h"
#include "support/modes.h"
#include "support/scenes.h"

namespace hanging_test {

constexpr double L = 1, width = 0.25;

TestScene hanging_strip(int rows, double k) {
  TestScene scene = strip(width, {rows / 4, rows}, k, k / 2, Gravity::on);
  for (int i = 0; i < scene.cloth.vertices(); ++i)
    scene.start.x[3 * i + 1] = -hanging_depth(-scene.start.x[3 * i + 1], L, k);
  return scene;
}

// Vertices on the exact curve are in balance. A cell stretches by the mean of λ over the cell, so it carries
// the weight below its middle, which is the weight of the lumped masses below it. Only the lower corners are
// not in balance: a corner has the mass of one triangle or of two, and half a column needs 3/2. So it is
// pulled up, or down, by ρ g h²/12.
TEST(HangingStrip, IsInBalanceOnTheExactCurve) {
  for (const double k : {100.0, 10.0})
    for (const int rows : {4, 8, 16}) {
      const TestScene scene = hanging_strip(rows, k);
      step01::System system(scene.cloth);
      step01::forces(scene.cloth, scene.start, system);
      for (const Pin& pin : scene.cloth.pins) system.f.segment<3>(3 * pin.vertex).setZero();
      const double h = L / rows;
      system.f[3 * 0 + 1] -= density * g * h * h / 12;
      system.f[3 * (rows / 4) + 1] += density * g * h * h / 12;
      Eigen::Index coordinate;
      EXPECT_LT(system.f.cwiseAbs().maxCoeff(&coordinate), 1e-12 * k)
          << "vertex " << coordinate / 3 << ", k = " << k << ", rows = " << rows;
    }
}

// The mean height at which the lowest row of the strip comes to rest: by Newton's method in the plane of the
// strip, begun at the exact curve.
double elongation_at_rest(int rows, double k) {
  TestScene scene = hanging_strip(rows, k);
  step01::System system(scene.cloth);
  std::vector<int> free;
  for (int i = 0; i < scene.start.x.size(); ++i)
    if (scene.cloth.inverse_mass[i] > 0 && i % 3 < 2) free.push_back(i);
  for (int iteration = 0; iteration < 6; ++iteration) {
    const MatX K = stiffness_matrix(scene.cloth, scene.start, step01::forces, system, 1e-6);
    step01::forces(scene.cloth, scene.start, system);
    const VecX f = system.f(free);
    scene.start.x(free) += solve(K(free, free), f);
  }
  step01::forces(scene.cloth, scene.start, system);
  const VecX f = system.f(free);
  EXPECT_LT(f.cwiseAbs().maxCoeff(), 1e-12 * k) << "not at rest";
  double lowest = 0;
  for (int i = 0; i <= rows / 4; ++i) lowest += scene.start.x[3 * i + 1] / (rows / 4 + 1);
  return -lowest - L;
}

// The expected values come from an independent program on the same meshes.
TEST(HangingStrip, IsLongerByItsWeightOverTwiceItsStiffness) {
  struct Case {
    double k;
    std::array<double, 3> at_4_8_16_rows;  // m
  };
  for (const auto& [k, expected] : {Case{100, {0.00980727, 0.00980876, 0.00980978}},
                                    Case{10, {0.09800553, 0.09807873, 0.09809710}}}) {
    const double exact = density * g * L * L / (2 * k);
    double error = 0;
    for (const int i : {0, 1, 2}) {
      const int rows = 4 << i;
      const double measured = elongation_at_rest(rows, k);
      EXPECT_NEAR(measured, expected[i], 6e-9) << "k = " << k << ", rows = " << rows;
      const double before = error;
      error = exact - measured;
      EXPECT_NEAR(error, 0, 1e-3 * exact) << "k = " << k << ", rows = " << rows;
      if (i < 2) continue;
      EXPECT_GT(before / error, 3.9) << "k = " << k << ", rows = " << rows;
    }
  }
}

}  // namespace hanging_test
