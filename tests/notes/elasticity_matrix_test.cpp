// The implicit part of the elasticity note (notes 004 in the bibliography), which ends where K has to be
// filled: the table ∂D_s/∂x, and from it column by column
//
//   dF = dD_s Dm⁻¹,   dP(F; dF),   dH = −a dP Dm⁻ᵀ,   K(:, c) = (−dH1 − dH2, dH1, dH2)
//
// The steps never form P. They fill K from the conditions of a triangle: with --jacobian bw98 both are the
// same.
#include <gtest/gtest.h>

#include "plane.h"
#include "support/assembly.h"
#include "support/differences.h"

namespace elasticity_matrix_test {

using namespace plane;

const Moduli moduli = {2, 3};

// ∂D_s/∂x_c: coordinate c is axis c mod D of vertex c / D.
template <int D>
Eigen::Matrix<double, D, 2> dDs(int c) {
  Eigen::Matrix<double, D, 2> d = Eigen::Matrix<double, D, 2>::Zero();
  const int vertex = c / D, axis = c % D;
  if (vertex == 0)
    d.row(axis).setConstant(-1);
  else
    d(axis, vertex - 1) = 1;
  return d;
}

// K from dP, column by column: 6 × 6 in the plane, 9 × 9 in space.
template <int D, class Change>
MatX filled(const Rest& rest, const Change& dP) {
  MatX K(3 * D, 3 * D);
  const Mat2 to_F = rest_edges(rest).inverse();
  for (int c = 0; c < 3 * D; ++c) {
    const Eigen::Matrix<double, D, 2> dF = dDs<D>(c) * to_F;
    K.col(c) = nodal_forces(rest, dP(dF)).reshaped();
  }
  return K;
}
MatX filled(const Rest& rest, const Material& material, const Mat2& F) {
  return filled<2>(rest, [&](const Mat2& dF) { return material.dP(moduli, F, dF); });
}

// K of the cloth as the steps assemble it, and its part in the plane.
MatX assembled(const Rest& rest, const std::string& membrane, const VecX& x) {
  return Assembly(cloth(rest, membrane, moduli), Jacobian::bw98).K(x);
}
MatX in_plane(const MatX& K) {
  const std::array<int, 6> kept = {0, 1, 3, 4, 6, 7};
  return K(kept, kept);
}

struct Case {
  Rest rest;
  Mat2 F;
};
std::vector<Case> cases(unsigned seed) {
  Random random(seed);
  std::vector<Case> all;
  for (int n = 0; n < 10; ++n) {
    const Rest rest = random_rest(random);
    all.push_back({rest, random.vector(4, 1.5).reshaped(2, 2)});
  }
  return all;
}

// The note: six matrices ∂D_s/∂x_c. All are right: D_s is linear, and Σ x_c ∂D_s/∂x_c is D_s itself.
TEST(Notes004, TableOfDsIsRight) {
  const std::array<Mat2, 6> printed = {matrix(-1, -1, 0, 0), matrix(0, 0, -1, -1),
                                       matrix(1, 0, 0, 0),   matrix(0, 0, 1, 0),
                                       matrix(0, 1, 0, 0),   matrix(0, 0, 0, 1)};
  const std::array<double, 6> x = {0.3, -0.2, 1.7, 0.4, 0.1, 2.2};
  Mat2 sum = Mat2::Zero();
  for (int c = 0; c < 6; ++c) {
    EXPECT_EQ(dDs<2>(c), printed[size_t(c)]);
    sum += x[size_t(c)] * printed[size_t(c)];
  }
  const Mat2 Ds = matrix(x[2] - x[0], x[4] - x[0], x[3] - x[1], x[5] - x[1]);
  EXPECT_LT((sum - Ds).norm(), 1e-15);
}

// dP of linear, μ (dF + dFᵀ) + λ tr(dF) I, and of StVK, dF S + F (2μ dE + λ tr(dE) I) with
// dE = (dFᵀF + FᵀdF)/2: for each of the four entries of F.
TEST(Notes004, ChangeOfStressIsItsSlope) {
  for (const Material& material : {linear, stvk})
    for (const Case& c : cases(82)) {
      const auto P = [&](const VecX& F) -> VecX {
        return material.P(moduli, F.reshaped(2, 2)).reshaped();
      };
      const auto slope = [&](const VecX& F) {
        MatX columns(4, 4);
        for (int i = 0; i < 4; ++i) {
          const Mat2 dF = VecX::Unit(4, i).reshaped(2, 2);
          columns.col(i) = material.dP(moduli, F.reshaped(2, 2), dF).reshaped();
        }
        return columns;
      };
      EXPECT_TRUE(is_slope(P, slope, c.F.reshaped(), 1)) << material.name;
    }
}

// The 36 numbers of K, column by column, are the slope of the six nodal forces.
TEST(Notes004, FilledStiffnessIsTheSlopeOfTheNodalForces) {
  for (const Material& material : {linear, stvk})
    for (const Case& c : cases(83)) {
      const Mat2 to_F = rest_edges(c.rest).inverse();
      const auto F_at = [&](const VecX& x) -> Mat2 {
        const Nodal<2> p = x.reshaped(2, 3);
        return (Mat2() << p.col(1) - p.col(0), p.col(2) - p.col(0)).finished() * to_F;
      };
      const auto f = [&](const VecX& x) -> VecX {
        return nodal_forces(c.rest, material.P(moduli, F_at(x))).reshaped();
      };
      const auto K = [&](const VecX& x) { return filled(c.rest, material, F_at(x)); };
      const Nodal<2> rest = (Nodal<2>() << c.rest[0], c.rest[1], c.rest[2]).finished();
      EXPECT_TRUE(is_slope(f, K, (c.F * rest).reshaped(), 0.5)) << material.name;
    }
}

// The note's K and the chain rule of the conditions, −Σ k (g gᵀ + C H): the same nine blocks.
TEST(Notes004, FilledStiffnessIsThatOfTheConditionsBlockByBlock) {
  for (const Material& material : {linear, stvk})
    for (const Case& c : cases(84)) {
      const MatX note = filled(c.rest, material, c.F);
      const MatX ours = in_plane(assembled(c.rest, material.name, plane::positions(c.rest, c.F)));
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
          const Mat2 block = ours.block<2, 2>(2 * i, 2 * j);
          EXPECT_LT((note.block<2, 2>(2 * i, 2 * j) - block).norm(), 1e-13 * note.norm())
              << material.name << ", block (" << i << ", " << j << ")";
        }
    }
}

// In space F is 3 × 2 and D_s has nine coordinates. The same recipe gives K of a cloth, in every pose.
TEST(Notes004, TheSameRecipeInSpaceGivesTheNineByNineStiffnessOfACloth) {
  using Gradient = Eigen::Matrix<double, 3, 2>;
  Random random(85);
  for (const Pose pose : all_poses) {
    const Rest rest = random_rest(random);
    const Vecs<2> w = pose_w(pose, random);
    const Gradient F = (Gradient() << w[0], w[1]).finished();
    const MatX note = filled<3>(rest, [&](const Gradient& dF) { return stvk_dP(moduli, F, dF); });
    const MatX ours = assembled(rest, "stvk", ::positions(rest, w, random.vector(3, 1)));
    EXPECT_LT(relative(note, ours), 1e-12) << name(pose);
  }
}

// K is symmetric, moving all three vertices costs nothing, and at rest neither does turning them.
TEST(Notes004, FilledStiffnessHasThreeFreeMotionsAtRest) {
  for (const Material& material : {linear, stvk})
    for (const Case& c : cases(86)) {
      const MatX K = filled(c.rest, material, c.F);
      EXPECT_LT((K - K.transpose()).norm(), 1e-14 * K.norm());
      const MatX moved = K.leftCols(2) + K.middleCols(2, 2) + K.rightCols(2);
      EXPECT_LT(moved.norm(), 1e-14 * K.norm());

      const VecX values = eigenvalues(-filled(c.rest, material, Mat2::Identity()));
      EXPECT_LT(values.head(3).cwiseAbs().maxCoeff(), 1e-13 * values[5]);
      EXPECT_GT(values[3], 1e-3 * values[5]);
    }
}

// Pressed to half its size StVK has a negative stiffness against turning: xᵀ(−K)x = a dF:dP = −¾ κ a |dF|²
// for x = Ω X, dF = Ω. The triangle gives way by turning, as a pressed column does. The K of the linear model
// is the same everywhere, and −K never negative.
TEST(Notes004, PressedStvkIsIndefiniteAndLinearNever) {
  const Rest unit = {Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)};
  const Mat2 half = 0.5 * Mat2::Identity(), quarter_turn = rotation(pi / 2);
  const Nodal<2> X = (Nodal<2>() << unit[0], unit[1], unit[2]).finished();
  const VecX turned = (quarter_turn * X).reshaped();
  const MatX K = filled(unit, stvk, half);
  EXPECT_NEAR(-turned.dot(K * turned), -0.75 * moduli.kappa() * 0.5 * 2, 1e-14);
  EXPECT_LT(eigenvalues(-K)[0], -1);

  const MatX everywhere = filled(unit, linear, half);
  EXPECT_EQ(everywhere, filled(unit, linear, Mat2::Identity()));
  EXPECT_GT(eigenvalues(-everywhere)[0], -1e-14);
}

}  // namespace elasticity_matrix_test
