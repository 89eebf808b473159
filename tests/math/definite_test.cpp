// The definite matrix: whatever the cloth does, no element can make A = M − h D − h² K indefinite. What
// an element adds to A is positive semidefinite, and a sum of such, plus M, is positive definite.
#include <gtest/gtest.h>

#include "support/dense.h"

namespace definite_test {

constexpr int poses = 20000;

// −(h D + h² K) of one element, and its lowest eigenvalue relative to its highest.
double lowest_eigenvalue(const Cloth& cloth, const State& state, double h, Jacobian jacobian) {
  const Evaluated e = evaluate(cloth, state, jacobian);
  const MatX A = -(h * e.D + h * h * e.K);
  const VecX values = eigenvalues(A);
  return values.minCoeff() / std::max(values.cwiseAbs().maxCoeff(), 1e-300);
}

struct Sample {
  Cloth cloth;
  State state;
  double h;
};

Sample random_triangle(Random& random, int n) {
  const Rest rest = random_rest(random);
  Sample s;
  s.cloth.mass = s.cloth.inverse_mass = VecX::Ones(9);
  s.cloth.triangles.elements = {make_triangle(rest)};
  const auto decade = [&](double low, double high) {
    return std::pow(10, random.between(low, high));
  };
  s.cloth.term<StretchTerm>() = StretchTerm(decade(0, 8), decade(-3, 3));
  s.cloth.term<ShearTerm>() = ShearTerm(decade(0, 8), decade(-3, 3));
  const Pose pose = all_poses[size_t(n) % all_poses.size()];
  s.state.x = positions(rest, pose_w(pose, random), random.vector(3, 1));
  if (n % 50 == 4) s.state.x.setZero();  // all in one point
  s.state.v = random.vector(9, 10);
  s.h = decade(-4, 1);
  return s;
}

TEST(Definite, NoTriangleMakesAIndefinite) {
  Random random(91);
  for (int n = 0; n < poses; ++n) {
    const Sample s = random_triangle(random, n);
    ASSERT_GE(lowest_eigenvalue(s.cloth, s.state, s.h, Jacobian::definite), -1e-12)
        << "pose " << n << ": " << name(all_poses[size_t(n) % all_poses.size()]);
  }
}

// The test above can fail: the matrix as printed is indefinite in most of these poses.
TEST(Definite, TheMatrixOfBaraffAndWitkinIsNot) {
  Random random(91);
  std::array<int, all_poses.size()> indefinite = {};
  for (int n = 0; n < poses; ++n) {
    const Sample s = random_triangle(random, n);
    if (lowest_eigenvalue(s.cloth, s.state, s.h, Jacobian::bw98) < -1e-6)
      ++indefinite[size_t(n) % all_poses.size()];
  }
  for (size_t i = 0; i < all_poses.size(); ++i) {
    std::printf("%s: indefinite in %d of %d\n", name(all_poses[i]), indefinite[i],
                poses / int(all_poses.size()));
    EXPECT_GT(indefinite[i], poses / int(all_poses.size()) / 10) << name(all_poses[i]);
  }
}

// The definite matrix is the full matrix of a stretched thread, and only k ∂C ∂Cᵀ of a compressed one.
TEST(Definite, KeepsAllOfAStretchedThreadAndNothingOfACompressedOne) {
  Cloth cloth;
  cloth.mass = cloth.inverse_mass = VecX::Ones(6);
  cloth.term<SpringTerm>() = SpringTerm(100);
  cloth.springs.elements = {make_spring(0, 1, 1)};
  State state{VecX::Zero(6), VecX::Zero(6)};
  for (const double length : {0.5, 1.5}) {
    state.x[3] = length;
    const MatX K = evaluate(cloth, state, Jacobian::definite).K;
    EXPECT_NEAR(K(0, 0), -100, 1e-12);
    EXPECT_NEAR(K(1, 1), length > 1 ? -100 * 0.5 / 1.5 : 0, 1e-12) << "length " << length;
    EXPECT_NEAR(evaluate(cloth, state, Jacobian::bw98).K(1, 1), -100 * (length - 1) / length,
                1e-12);
  }
}

// A spring is one thread: −K = k ∂C/∂y ∂C/∂yᵀ + max(k C, 0) ∂²C/∂y², to the last bit.
TEST(Definite, KeepsOfASpringItsOwnTension) {
  Random random(92);
  for (int n = 0; n < 500; ++n) {
    const double rest_length = n % 5 == 0 ? 0 : random.between(0.5, 2);
    const Spring s = make_spring(0, 1, rest_length, random.between(0.1, 3));
    Cloth cloth;
    cloth.mass = cloth.inverse_mass = VecX::Ones(6);
    cloth.term<SpringTerm>() = SpringTerm(random.between(1, 1e4));
    cloth.springs.elements = {s};
    const State state{random.vector(6, 1), VecX::Zero(6)};
    const double k = cloth.term<SpringTerm>()->k;
    const Elongation c(s, state.x.head<3>() - state.x.tail<3>());
    const Mat3 ggT = c.dCdy[0] * c.dCdy[0].transpose();
    const Mat3 expected = -(k * ggT + std::max(k * c.C, 0.0) * c.second()[0][0]);
    const MatX K = evaluate(cloth, state, Jacobian::definite).K;
    EXPECT_EQ(K.topLeftCorner(3, 3), expected) << "spring " << n;
  }
}

// The tension of a triangle is its second Piola–Kirchhoff stress S = F⁻¹ P, times its area. P comes from
// the forces on w_u and w_v, [f_u f_v] = −a P, so T = −(FᵀF)⁻¹ Fᵀ [f_u f_v]: no second derivative.
TEST(Tension, OfATriangleIsItsSecondPiolaKirchhoffStressTimesItsArea) {
  Random random(95);
  for (int n = 0; n < 500; ++n) {
    const Rest rest = random_rest(random);
    const Triangle t = make_triangle(rest);
    const Vecs<2> w = {random.vector(3, 1), random.vector(3, 1)};
    if (w[0].cross(w[1]).norm() < 0.02) continue;
    Tension<2> tension;
    MatX F(3, 2), f = MatX::Zero(3, 2);
    F << w[0], w[1];
    Triangles family;
    family.term<StretchTerm>() = StretchTerm(100);
    family.term<ShearTerm>() = ShearTerm(40);
    family.conditions(t, w, [&](const Term& term, const auto& c) {
      tension.add(term.k * c.C, c);
      for (int m = 0; m < c.M; ++m) f.col(c.first + m) -= term.k * c.C * c.dCdy[m];
    });
    const MatX expected = -product({inverse(product({F.transpose(), F})), F.transpose(), f});
    EXPECT_LT(relative(tension.T, expected), 1e-9);
  }
}

// A whole sheet, crumpled at random: all eigenvalues of A are positive.
TEST(Definite, ACrumpledSheetHasAPositiveDefiniteMatrix) {
  Random random(93);
  const Mesh mesh = small_grid();
  const Cloth cloth = rich_cloth(mesh);
  for (int n = 0; n < 200; ++n) {
    const State state = disturbed(mesh, 2, random);
    const Evaluated e = evaluate(cloth, state, Jacobian::definite);
    MatX A = -(0.1 * e.D + 0.01 * e.K);
    A.diagonal() += cloth.mass;
    const VecX values = eigenvalues(A);
    EXPECT_GE(values.minCoeff(), cloth.mass.minCoeff() * (1 - 1e-9)) << "state " << n;
  }
}

}  // namespace definite_test
