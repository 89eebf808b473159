// The numbers and claims of the Baraff–Witkin note (notes 000 in the bibliography), computed again.
// Each test says what the note prints and what is right.
//
// The note takes α = 1 as the weight of its conditions; ours is √a. So on its unit triangle,
// a = 1/2, its C is ours / √½ and its forces are ours with twice the k.
#include <gtest/gtest.h>

#include "scene/make_cloth.h"
#include "support/differences.h"
#include "support/energy.h"

namespace baraff_witkin_test {

using Positions = std::array<Vec3, 3>;
using Rest = std::array<Vec2, 3>;

const Rest unit_rest = {Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)};
const double root_half = std::sqrt(0.5);

Triangle triangle(const Rest& rest) {
  return make_triangle({0, 1, 2}, rest[0], rest[1], rest[2]);
}

VecX stacked(const Positions& p) {
  VecX x(9);
  x << p[0], p[1], p[2];
  return x;
}

// The three conditions without our weight: |w_u| − 1, |w_v| − 1, w_u·w_v.
Vec3 conditions(const Rest& rest, const Positions& p) {
  const Triangle t = triangle(rest);
  const Vecs<2> w = gather(t, stacked(p));
  return Vec3(Stretch(t, w, 0).C, Stretch(t, w, 1).C, Shear(t, w).C) / t.sqrt_area;
}

double area(const Positions& p) {
  return 0.5 * (p[1] - p[0]).cross(p[2] - p[0]).norm();
}

Eigen::Matrix2d edges(const Vec2& a, const Vec2& b, const Vec2& c) {
  Eigen::Matrix2d D;
  D << b - a, c - a;
  return D;
}

Eigen::Matrix2d matrix(double a, double b, double c, double d) {
  Eigen::Matrix2d m;
  m << a, b, c, d;
  return m;
}

// The plane part of F as we compute it: the columns w_u, w_v.
Eigen::Matrix2d our_F(const Rest& rest, const Rest& now) {
  Positions p;
  for (size_t i = 0; i < 3; ++i) p[i] = Vec3(now[i].x(), now[i].y(), 0);
  const Vecs<2> w = gather(triangle(rest), stacked(p));
  return matrix(w[0].x(), w[1].x(), w[0].y(), w[1].y());
}

void expect_close(const Eigen::MatrixXd& actual, const Eigen::MatrixXd& expected,
                  double tolerance = 1e-14) {
  EXPECT_LT((actual - expected).norm(), tolerance) << "got\n" << actual << "\nnot\n" << expected;
}

// Worked numbers ----------------------------------------------------------------------------------

// The note's first program: F = [[1, 0], [1, 2]]. This is right, because Dm = I hides
// the order of the factors.
TEST(Notes000, FirstDeformationGradientIsRight) {
  const Rest now = {Vec2(0, 0), Vec2(1, 1), Vec2(0, 2)};
  expect_close(our_F(unit_rest, now), matrix(1, 0, 1, 2));
}

// The note multiplies Dm⁻¹ Ds. Right is Ds Dm⁻¹: only this product gives the
// rotation of a rotated triangle.
TEST(Notes000, DeformationGradientIsDsTimesInverseDmInThisOrder) {
  const Eigen::Matrix2d R = matrix(0, -1, 1, 0);  // 90°
  const Rest rest = {Vec2(0, 0), Vec2(2, 0), Vec2(1, 1)};
  const Rest now = {R * rest[0], R * rest[1], R * rest[2]};
  expect_close(our_F(rest, now), R);

  const Eigen::Matrix2d Dm = edges(rest[0], rest[1], rest[2]), Ds = edges(now[0], now[1], now[2]);
  const Eigen::Matrix2d printed = Dm.inverse() * Ds;
  expect_close(printed, matrix(-1, -1, 2, 1));
  expect_close(printed.transpose() * printed, matrix(5, 3, 3, 2));  // not I: a deformation
}

// The note: the triangle at rest has w_u = (1, 0, 0), w_v = (0, 1, 0) and no force. Right.
TEST(Notes000, TriangleAtRestHasUnitThreadsAndNoForce) {
  const Positions p = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
  const Vecs<2> w = gather(triangle(unit_rest), stacked(p));
  expect_close(w[0], Vec3::UnitX());
  expect_close(w[1], Vec3::UnitY());
  expect_close(conditions(unit_rest, p), Vec3::Zero());
  expect_close(forces(one_triangle(triangle(unit_rest), 1, 1), stacked(p)), VecX::Zero(9));
}

// The note: no force when moved, none when rotated by 90°. Right, but not
// for its reason (see below).
TEST(Notes000, MovedOrRotatedTriangleHasNoForce) {
  const Positions moved = {Vec3(1, 1, 0), Vec3(2, 1, 0), Vec3(1, 2, 0)};
  const Positions rotated = {Vec3(0, 0, 0), Vec3(0, 1, 0), Vec3(-1, 0, 0)};
  for (const Positions& p : {moved, rotated}) {
    expect_close(conditions(unit_rest, p), Vec3::Zero());
    expect_close(forces(one_triangle(triangle(unit_rest), 1, 1), stacked(p)), VecX::Zero(9));
  }
}

// The note: C_stretch = (1, 0). Right for α = 1. With α = √a it is (√½, 0),
// and the force is (½, 0, 0).
TEST(Notes000, StretchedTriangle) {
  const Positions p = {Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(0, 1, 0)};
  expect_close(conditions(unit_rest, p), Vec3(1, 0, 0));
  const Triangle t = triangle(unit_rest);
  EXPECT_NEAR(Stretch(t, gather(t, stacked(p)), 0).C, root_half, 1e-15);

  const VecX of_the_note = stacked({Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 0, 0)});
  expect_close(forces(one_triangle(t, 2, 0), stacked(p)), of_the_note);
  expect_close(forces(one_triangle(t, 1, 0), stacked(p)), 0.5 * of_the_note);
}

// The note: C_shear = 1. Right for α = 1. The note calls this a pure shear without change of area.
// But the area falls to 0.75, and both threads are 11.8 % too long.
TEST(Notes000, ShearedTriangleIsStretchedAndSmallerAsWell) {
  const Positions p = {Vec3(0, 0, 0), Vec3(1, 0.5, 0), Vec3(0.5, 1, 0)};
  const double longer = std::sqrt(1.25) - 1;
  EXPECT_NEAR(longer, 0.118, 5e-4);
  expect_close(conditions(unit_rest, p), Vec3(longer, longer, 1));
  EXPECT_NEAR(area(p) / 0.5, 0.75, 1e-15);

  const VecX of_the_note = stacked({Vec3(1.5, 1.5, 0), Vec3(-0.5, -1, 0), Vec3(-1, -0.5, 0)});
  expect_close(forces(one_triangle(triangle(unit_rest), 0, 2), stacked(p)), of_the_note);
}

// The note: moving p0 by b lowers its height by 0.2828, "the length of b". The value is
// right, but it is m·b, the part of b along the unit vector m from p0 to the opposite
// edge. The length of b is 0.4.
TEST(Notes000, HeightFallsByThePartOfTheMotionTowardsTheEdge) {
  const Vec2 p0(0, 0), p1(2, 0), p2(0, 2), b(0.4, 0);
  const Vec2 edge = (p2 - p1).normalized();
  const auto to_edge = [&](const Vec2& p) -> Vec2 { return (p1 - p) - edge * edge.dot(p1 - p); };
  const Vec2 m = to_edge(p0).normalized();
  const double fall = to_edge(p0).norm() - to_edge(p0 + b).norm();
  EXPECT_NEAR(fall, 0.2828, 5e-5);
  EXPECT_NEAR(fall, m.dot(b), 1e-15);
  EXPECT_NEAR(b.norm(), 0.4, 1e-15);
}

// Claims ------------------------------------------------------------------------------------------

// The note: Dm⁻¹ Ds. This order is wrong for every rest triangle but right-angled ones with equal
// legs: it finds a deformation, FᵀF ≠ I, where there is only a rotation.
TEST(Notes000, WrongOrderTakesRotationsForDeformations) {
  const Rest rest = {Vec2(0.2, 0.1), Vec2(1.3, 0.4), Vec2(0.5, 2.0)};
  const Eigen::Matrix2d Dm = edges(rest[0], rest[1], rest[2]);
  for (const double angle : {0.3, 1.0, 2.5}) {
    const Eigen::Matrix2d R = Eigen::Rotation2Dd(angle).toRotationMatrix();
    const Rest now = {R * rest[0], R * rest[1], R * rest[2]};
    expect_close(our_F(rest, now), R);
    const Eigen::Matrix2d printed = Dm.inverse() * (R * Dm);
    EXPECT_GT((printed.transpose() * printed - Eigen::Matrix2d::Identity()).norm(), 0.1)
        << "at " << angle << " rad";
  }
}

// The note: the area is unchanged, so there is no deformation. Wrong: a simple shear keeps the area
// and has C_shear = 0.5 and a thread 11.8 % too long. No deformation means FᵀF = I.
TEST(Notes000, EqualAreaIsNotNoDeformation) {
  const Positions p = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0.5, 1, 0)};
  EXPECT_NEAR(area(p), 0.5, 1e-15);
  expect_close(conditions(unit_rest, p), Vec3(0, std::sqrt(1.25) - 1, 0.5));
  EXPECT_GT(forces(one_triangle(triangle(unit_rest), 1, 1), stacked(p)).norm(), 0.3);
}

// The note's pure shear is a deformation without a rotation: F is symmetric, with positive eigenvalues, 0.5
// and 1.5. A simple shear is turned as well, by atan ¼.
TEST(Notes000, NoRotationMeansASymmetricF) {
  const auto turn = [](const Vec3& wu, const Vec3& wv) {
    const Vec3 u = axes_of({wu, wv})[0];
    return std::atan2(u.y(), u.x());
  };
  EXPECT_NEAR(turn({1, 0.5, 0}, {0.5, 1, 0}), 0, 1e-15);
  EXPECT_NEAR(turn({1, 0, 0}, {0.5, 1, 0}), -std::atan(0.25), 1e-15);
  const Eigen::Matrix2d F = matrix(1, 0.5, 0.5, 1);
  expect_close(F * Vec2(1, 1), 1.5 * Vec2(1, 1));
  expect_close(F * Vec2(1, -1), 0.5 * Vec2(1, -1));
}

// The note quotes a program that takes U and V of F = U Σ Vᵀ for "rotations", with three question marks. The
// rotation of F is their product R = U Vᵀ; one of them alone also turns to the axes of the stretch. R is the
// rotation that is nearest to F. The Q of a QR decomposition is another one, which depends on the order of
// the columns. The conditions of the note need no rotation: |w| and w_u·w_v do not see it.
TEST(Notes000, RotationOfFIsUTimesVTransposed) {
  const auto rotation = [](double a) -> Eigen::Matrix2d {
    return Eigen::Rotation2Dd(a).toRotationMatrix();
  };
  const Eigen::Matrix2d U = rotation(0.9), V = rotation(0.3), R = U * V.transpose();
  const Eigen::Matrix2d F = U * matrix(1.6, 0, 0, 0.5) * V.transpose();
  const Axes axes = axes_of({Vec3(F(0, 0), F(1, 0), 0), Vec3(F(0, 1), F(1, 1), 0)});
  expect_close(matrix(axes[0].x(), axes[1].x(), axes[0].y(), axes[1].y()), R);
  const double a = F(0, 0) + F(1, 1), b = F(1, 0) - F(0, 1);
  expect_close(matrix(a, -b, b, a) / std::hypot(a, b), R);

  const double from_R = (F - R).norm();
  EXPECT_NEAR(from_R, std::hypot(0.6, 0.5), 1e-14);
  for (const double other : {0.59, 0.61}) EXPECT_GT((F - rotation(other)).norm(), from_R);
  const double of_first = std::atan2(F(1, 0), F(0, 0)), of_second = std::atan2(-F(0, 1), F(1, 1));
  EXPECT_GT((F - rotation(of_first)).norm(), from_R + 0.01);
  EXPECT_GT((F - rotation(of_second)).norm(), from_R + 0.01);
  EXPECT_GT(std::abs(of_first - of_second), 0.1);
}

// What that program computes, 2 μ (F − R) Fᵀ + λ J (J − 1) I, is P Fᵀ with P = ∂ψ/∂F of
// ψ = μ |F − R|² + λ/2 (J − 1)².
TEST(Notes000, QuotedStressIsThatOfTheFixedCorotatedModel) {
  const double mu = 3, lambda = 4;
  const auto R = [](const Eigen::Matrix2d& F) -> Eigen::Matrix2d {
    return Eigen::Rotation2Dd(std::atan2(F(1, 0) - F(0, 1), F(0, 0) + F(1, 1))).toRotationMatrix();
  };
  const auto psi = [&](const VecX& f) {
    const Eigen::Matrix2d F = f.reshaped(2, 2);
    const double volume = F.determinant() - 1;
    return VecX::Constant(1, mu * (F - R(F)).squaredNorm() + lambda / 2 * volume * volume);
  };
  const auto P = [&](const VecX& f) -> MatX {
    const Eigen::Matrix2d F = f.reshaped(2, 2), I = Eigen::Matrix2d::Identity();
    const double J = F.determinant();
    const Eigen::Matrix2d quoted = 2 * mu * (F - R(F)) * F.transpose() + lambda * J * (J - 1) * I;
    return (quoted * F.transpose().inverse()).reshaped().transpose();
  };
  const VecX F = matrix(1.2, 0.3, -0.4, 0.8).reshaped();
  EXPECT_TRUE(is_slope(psi, P, F, 1));
}

// The note's variable det is 1/det Dm. With it the weights that it prints are those of our triangle. (The
// quoted comment says that (du2, dv2) points from B to A. It points from A to C.)
TEST(Notes000, PrintedWeightsAreOursWithTheInverseOfTheDeterminant) {
  const Rest rest = {Vec2(0.2, 0.1), Vec2(1.3, 0.4), Vec2(0.5, 2.0)};
  const Vec2 duv10 = rest[1] - rest[0], duv20 = rest[2] - rest[0];
  const double det = 1 / (duv10(0) * duv20(1) - duv10(1) * duv20(0));
  Eigen::Matrix<double, 2, 3> printed;
  printed << duv10(1) - duv20(1), duv20(1), -duv10(1), duv20(0) - duv10(0), -duv20(0), duv10(0);
  expect_close(det * printed, triangle(rest).weight);
}

// The note: α is "a constant", and the paper's α is the area a. Neither describes a material: a
// refinement quarters a, and so multiplies the energy of α = 1 by 4 and that of α = a by ¼. Only
// α = √a is right: it leaves the energy unchanged.
TEST(Notes000, OnlyTheRootOfTheAreaIsAMaterial) {
  const double strain = 0.05;
  for (const int n : {4, 8, 16, 32}) {
    const Mesh mesh = make_grid({1, 1}, {n, n}, Diagonals::same);
    Model model;
    model.add(StretchTerm(1));
    const Cloth cloth = make_cloth(mesh, model);
    VecX x = mesh.x;
    for (int i = 0; i < mesh.vertices(); ++i) x[3 * i] *= 1 + strain;

    // Our energy is E = Σ a/2 (…)². Another α changes the a of each triangle to α².
    const double ours = potential_energy(cloth, x);
    const double a = 0.5 / (n * n);
    EXPECT_NEAR(ours, 1.25e-3, 1e-15) << "α = √a, " << n << " cells";

    double constant = 0, power = 0, of_area = 0;
    for (const Triangle& t : cloth.triangles.elements)
      for (const Vec3& w : gather(t, x)) {
        const double C = w.norm() - 1;
        constant += 0.5 * C * C;
        power += 0.5 * std::pow(std::pow(t.area, 0.75) * C, 2);
        of_area += 0.5 * std::pow(t.area * C, 2);
      }
    EXPECT_NEAR(constant, 1.25e-3 / a, 1e-11) << "α = 1, " << n << " cells";
    EXPECT_NEAR(power, 1.25e-3 * std::sqrt(a), 1e-15) << "α = a^¾, " << n << " cells";
    EXPECT_NEAR(of_area, 1.25e-3 * a, 1e-15) << "α = a, " << n << " cells";
  }
}

}  // namespace baraff_witkin_test
