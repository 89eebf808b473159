// The frequency of a strip that is clamped at one end and driven back by its bending stiffness alone:
//
//   ω = 1.875104² √(B/ρ)/L²    where cos β cosh β = −1 for β = 1.875104
//
// Rows are locked and the clamp is half a cell before the second row, as in cantilever.h.
#include <gtest/gtest.h>

#include "cantilever.h"
#include "support/decompositions.h"

namespace bend_vibration_test {

// The lowest frequency of the flat strip, in √(B/ρ)/L².
double lowest_frequency(const Cantilever& c) {
  const HeldStrip strip(c);
  const Sparse P = strip.freedom();
  Statics statics(strip.cloth);
  statics.evaluate(strip.mesh.x);
  const MatX K = P.transpose() * statics.K * P;
  const VecX mass = P.transpose() * strip.cloth.mass;  // a coordinate moves with one unknown
  const VecX root = mass.cwiseSqrt().cwiseInverse();
  const VecX squares = eigenvalues(root.asDiagonal() * K * root.asDiagonal());
  return std::sqrt(squares[0] * density / c.B) * c.L * c.L;
}

// The smallest root of cos β cosh β + 1, by Newton's method.
double exact_frequency() {
  double beta = 1.9;
  for (int i = 0; i < 20; ++i)
    beta -= (std::cos(beta) * std::cosh(beta) + 1) /
            (std::cos(beta) * std::sinh(beta) - std::sin(beta) * std::cosh(beta));
  return beta * beta;
}

TEST(BendVibration, IsThatOfABeamToSecondOrder) {
  EXPECT_NEAR(exact_frequency(), 3.516015, 1e-6);
  struct Case {
    int N;
    double independent;  // as another program found it
  };
  double before = 0;
  for (const Case& known :
       {Case{8, 3.508230}, Case{16, 3.513969}, Case{32, 3.515489}, Case{64, 3.515882}}) {
    Cantilever c;
    c.N = known.N;
    const double omega = lowest_frequency(c), error = 1 - omega / exact_frequency();
    const double order = std::log2(before / error);
    std::printf("N = %2d: %.6f, error %.1e%s", c.N, omega, error, before > 0 ? "" : "\n");
    if (before > 0) std::printf(", order %.2f\n", order);
    EXPECT_NEAR(omega, known.independent, 2e-6);
    if (before > 0) {
      EXPECT_NEAR(order, 2, 0.1);
    }
    before = error;
  }
}

// All models with the same B, and any diagonals: the flat cloth is the same plate.
TEST(BendVibration, IsTheSameForAllModelsAndGrids) {
  Cantilever first;
  first.N = 16;
  const double omega = lowest_frequency(first);
  for (const BendModel bend_model :
       {BendModel::dihedral, BendModel::bridson, BendModel::quadratic}) {
    Cantilever c;
    c.N = 16;
    c.bend_model = bend_model;
    c.diagonals = Diagonals::alternating;
    c.across = 3;
    EXPECT_NEAR(lowest_frequency(c) / omega, 1, 1e-6) << "model " << int(bend_model);
  }
}

}  // namespace bend_vibration_test
