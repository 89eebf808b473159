// The numbers and claims of the mass-spring note (notes 003 in the bibliography), computed again: the spring,
// the implicit step as a minimum, Newton's method, and where a spring system has one solution.
//
// Tests elsewhere show the rest of this note: Locking, HingeTopology, BendSprings, Bridson, Quadratic.
#include <gtest/gtest.h>

#include "step03_implicit/time_step.h"
#include "support/dense.h"
#include "support/differences.h"
#include "support/energy.h"
#include "support/folds.h"

namespace springs_test {

VecX pair_of(const Vec3& x0, const Vec3& x1) {
  return (VecX(6) << x0, x1).finished();
}
VecX one_number(double value) {
  return VecX::Constant(1, value);
}

// The spring -------------------------------------------------------------------------------------

// The note: E = ½ (|x| − L)², and f = −k (|x| − L) x/|x|. The force is right. The energy lacks k: its slope
// is f/k.
TEST(Notes003, PrintedEnergyLacksTheStiffness) {
  const double k = 7;
  const Cloth cloth = one_spring(make_spring(0, 1, 0.8), k);
  const VecX x = pair_of({0.1, 0.2, 0.3}, {1, -0.4, 0.6});
  const VecX f = forces(cloth, x);
  const auto printed = [](const VecX& at) {
    return one_number(0.5 * std::pow((at.head<3>() - at.tail<3>()).norm() - 0.8, 2));
  };
  const auto ours = [&](const VecX& at) { return one_number(energy(cloth.springs, at)); };
  EXPECT_TRUE(is_slope(
      ours, [&](const VecX&) -> MatX { return -f.transpose(); }, x, 1));
  EXPECT_TRUE(is_slope(
      printed, [&](const VecX&) -> MatX { return -f.transpose() / k; }, x, 1));

  const Vec3 y = x.head<3>() - x.tail<3>();
  const Vec3 printed_force = -k * (y.norm() - 0.8) * y / y.norm();
  EXPECT_LT((f - pair_of(printed_force, -printed_force)).norm(), 1e-14);
}

// The note: a force is the slope of the energy by time. It is that by position. By time the energy has one
// number for a slope, minus the power of the force: dE/dt = −f·v.
TEST(Notes003, ForceIsTheSlopeByPositionNotByTime) {
  const Cloth cloth = one_spring(make_spring(0, 1, 0.8), 7);
  const VecX x = pair_of({0.1, 0.2, 0.3}, {1, -0.4, 0.6}), v = pair_of({1, 2, -1}, {0.5, 0, 3});
  const auto energy_at = [&](const VecX& t) {
    return one_number(energy(cloth.springs, x + t[0] * v));
  };
  const double power = forces(cloth, x).dot(v);
  EXPECT_GT(std::abs(power), 1);
  EXPECT_TRUE(is_slope(
      energy_at, [&](const VecX&) -> MatX { return one_number(-power); }, VecX::Zero(1), 0.1));
}

// The second derivative --------------------------------------------------------------------------

MatX K_of(const Cloth& cloth, const VecX& x) {
  return evaluate(cloth, {x, VecX::Zero(x.size())}, Jacobian::bw98).K;
}

// H_e of the note's last line.
Mat3 printed_hessian(const Vec3& x, double k, double L) {
  const Mat3 nnT = x * x.transpose() / x.squaredNorm();
  return k * nnT + k * (1 - L / x.norm()) * (Mat3::Identity() - nnT);
}

// The note: H_e = k n nᵀ + k (1 − L/|x|) (I − n nᵀ), and (H_e −H_e; −H_e H_e) for the two ends. Right, with
// H = −∂f/∂x; the note also writes H = ∇f. Its line before has the number xᵀx for the matrix xxᵀ: then the
// second part is zero, and with it the tension.
TEST(Notes003, HessianOfASpringIsThatOfTheLastLine) {
  const double k = 7, L = 0.8;
  const Cloth cloth = one_spring(make_spring(0, 1, L), k);
  for (const double length : {0.5, 0.8, 1.3}) {
    const Vec3 x = length * Vec3(2, -1, 2) / 3;
    const Mat3 H = printed_hessian(x, k, L);
    MatX both(6, 6);
    both << H, -H, -H, H;
    EXPECT_LT((K_of(cloth, pair_of(x, Vec3::Zero())) + both).norm(), 1e-8) << length;

    const double r = x.norm(), xTx = x.dot(x);
    const Mat3 before = k * x * x.transpose() / xTx +
                        k * (r - L) * (Mat3::Identity() * r - xTx / r * Mat3::Identity()) / (r * r);
    EXPECT_NEAR((before - H).norm(), k * std::abs(1 - L / r) * std::sqrt(2), 1e-13);
  }
}

// The note: H_e is positive definite, but perhaps not if |x| < L. It has the eigenvalue k once, and
// k (1 − L/|x|) two times. So it is indefinite whenever |x| < L, and at |x| = L only semidefinite. The 6 × 6
// matrix of both ends is never definite: moving both costs nothing.
TEST(Notes003, HessianOfASpringIsDefiniteOnlyIfItIsStretched) {
  const double L = 1;
  const Vec3 direction = Vec3(1, 2, 2) / 3;
  for (const auto& [length, across] : {std::pair{0.8, -0.25}, {1.0, 0.0}, {1.25, 0.2}}) {
    const VecX values = eigenvalues(printed_hessian(length * direction, 1, L));
    EXPECT_LT((values - VecX(Vec3(across, across, 1))).norm(), 1e-14) << length;

    const Cloth cloth = one_spring(make_spring(0, 1, L), 1);
    const VecX both = eigenvalues(-K_of(cloth, pair_of(length * direction, Vec3::Zero())));
    EXPECT_EQ((both.array().abs() < 1e-12).count(), length == L ? 5 : 3) << length;
  }
}

// What has to be definite is M/h² + H. For one spring between two masses m it is so exactly if
// |x|/L > 1/(1 + m/(2 h² k)), 0.889 here: mass makes up for some pressure, the more the shorter h is.
TEST(Notes003, MassMakesUpForSomePressure) {
  const double m = 0.01, h = 0.02, k = 100, limit = 1 / (1 + m / (2 * h * h * k));
  EXPECT_NEAR(limit, 0.889, 5e-4);
  const Cloth cloth = one_spring(make_spring(0, 1, 1), k);
  const auto lowest = [&](double length) {
    MatX A = -K_of(cloth, pair_of({length, 0, 0}, Vec3::Zero()));
    A.diagonal().array() += m / (h * h);
    return eigenvalues(A)[0];
  };
  EXPECT_NEAR(lowest(1.01 * limit), 2.2, 0.05);
  EXPECT_NEAR(lowest(limit), 0, 1e-6);
  EXPECT_NEAR(lowest(0.99 * limit), -2.3, 0.05);
}

// The implicit step ------------------------------------------------------------------------------

// A tetrahedron of six springs with four masses, in motion, and its implicit step by the formulas of the
// note:
//
//   Φ(x) = |x − y|²_M/(2h²) + E(x),  y = x0 + h v0,   ∇Φ = M (x − y)/h² − f,   ∇²Φ = M/h² + H
struct Tetrahedron {
  explicit Tetrahedron(double h_) : h(h_) {
    cloth = bare_cloth(4);
    cloth.mass << 0.01, 0.01, 0.01, 0.02, 0.02, 0.02, 0.03, 0.03, 0.03, 0.04, 0.04, 0.04;
    cloth.inverse_mass = cloth.mass.cwiseInverse();
    cloth.term<SpringTerm>() = SpringTerm(100);
    start.x = (VecX(12) << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1).finished();
    start.v = (VecX(12) << 1, 0, 0, 0, 0.5, 0, 0, 0, -1, 0.2, 0.3, 0).finished();
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < i; ++j) {
        const Vec3 edge = start.x.segment<3>(3 * i) - start.x.segment<3>(3 * j);
        cloth.springs.elements.push_back(make_spring(i, j, 0.9 * edge.norm()));
      }
  }

  VecX y() const { return start.x + h * start.v; }
  VecX slope(const VecX& x) const {
    return cloth.mass.cwiseProduct(x - y()) / (h * h) - forces(cloth, x);
  }
  VecX newton(const VecX& x) const {  // x_k + Δx
    MatX A = -K_of(cloth, x);
    A.diagonal() += cloth.mass / (h * h);
    return x + solve(A, -slope(x));
  }
  VecX minimum() const {
    VecX x = start.x;
    for (int i = 0; i < 20; ++i) x = newton(x);
    return x;
  }

  double h;
  Cloth cloth;
  State start;
};

// The note: x1 = x0 + h v0 + h² M⁻¹ f(x1) is a linear system. It is not: between two points its residual does
// not change evenly. It is linear only for springs without length.
TEST(Notes003, EquationOfTheImplicitStepIsNotLinear) {
  Tetrahedron t(0.02);
  const auto curvature = [&] {
    const VecX a = t.start.x, b = t.start.x + VecX::LinSpaced(12, -0.4, 0.5);
    return (t.slope((a + b) / 2) - (t.slope(a) + t.slope(b)) / 2).norm();
  };
  EXPECT_GT(curvature(), 1);
  for (Spring& s : t.cloth.springs.elements) s.rest_length = 0;
  EXPECT_LT(curvature(), 1e-12);
}

// The note: ∇Φ = 0 says x1 − x0 − h v0 − h² f(x1) = 0. That lacks M⁻¹.
TEST(Notes003, StationaryPointNeedsTheInverseMass) {
  const Tetrahedron t(0.02);
  const VecX x = t.minimum(), f = forces(t.cloth, x);
  EXPECT_LT(t.slope(x).norm(), 1e-11);
  const VecX right = x - t.y() - t.h * t.h * t.cloth.inverse_mass.cwiseProduct(f);
  const VecX printed = x - t.y() - t.h * t.h * f;
  EXPECT_LT(right.norm(), 1e-14);
  EXPECT_GT(printed.norm(), 1e-3);
}

// The note: Δx = −(∇²Φ)⁻¹ ∇Φ, x_{k+1} = x_k + Δx. Right, and the number of right digits doubles. (The line
// before has −Φ''(x − x_k) = Φ'' Δx, with a sign too many: that Δx would go the other way.)
TEST(Notes003, NewtonsMethodDoublesTheDigits) {
  const Tetrahedron t(0.05);
  const VecX end = t.minimum();
  VecX x = t.start.x;
  std::vector<double> errors;
  for (int i = 0; i < 8 && (errors.empty() || errors.back() > 1e-7); ++i) {
    errors.push_back((x - end).norm());
    x = t.newton(x);
  }
  ASSERT_GE(errors.size(), 3u);
  const double last = errors.back(), before = errors[errors.size() - 2];
  EXPECT_LT(last, 3 * before * before);
  const VecX other_way = t.start.x - (t.newton(t.start.x) - t.start.x);
  EXPECT_GT((other_way - end).norm(), errors[0]);
}

// One iteration from x0 is the step of Baraff & Witkin, to the last digits. (With v1 = (x1 − x0)/h, as the
// note has it.)
TEST(Notes003, OneNewtonIterationIsTheStepOfBaraffAndWitkin) {
  const Tetrahedron t(0.02);
  State state = t.start;
  step03::System system(t.cloth, {.jacobian = Jacobian::bw98, .guard = false});
  step03::time_step(t.cloth, t.h, state, system);
  const VecX x = t.newton(t.start.x);
  EXPECT_LT((state.x - x).norm(), 1e-14);
  EXPECT_LT((state.v - (x - t.start.x) / t.h).norm(), 1e-12);
  EXPECT_GT((state.x - t.minimum()).norm(), 1e-6) << "which is not yet backward Euler";
}

// One solution? ----------------------------------------------------------------------------------

// The note: if H_e is positive definite, as in a stretched spring, the solution is unique. Not so: definite
// at one solution says nothing of others. A mass on a line, held by a spring of L = 1 at the origin, with
// m/h² = 1, k = 10 and y = 1.5, has two: one with the spring stretched, one with it pressed. At both Φ'' is
// 11. In space the second one is a saddle, from which the mass can swing aside.
TEST(Notes003, AStretchedSolutionNeedNotBeTheOnlyOne) {
  const Cloth cloth = one_spring(make_spring(0, 1, 1), 10);
  const Vec3 y(1.5, 0, 0);
  const auto slope = [&](double x) {
    return Vec3(Vec3(x, 0, 0) - y - forces(cloth, pair_of({x, 0, 0}, Vec3::Zero())).head<3>());
  };
  const auto second = [&](double x) {
    const MatX K = K_of(cloth, pair_of({x, 0, 0}, Vec3::Zero()));
    return MatX(MatX::Identity(3, 3) - K.topLeftCorner(3, 3));
  };
  const double stretched = 11.5 / 11, pressed = -8.5 / 11;
  EXPECT_NEAR(stretched, 1.0455, 5e-5);
  EXPECT_NEAR(pressed, -0.7727, 5e-5);
  for (const double x : {stretched, pressed}) {
    EXPECT_LT(slope(x).norm(), 1e-14) << x;
    EXPECT_NEAR(second(x)(0, 0), 11, 1e-13) << x;
  }
  EXPECT_GT(eigenvalues(second(stretched))[0], 0);
  EXPECT_LT(eigenvalues(second(pressed))[0], 0);
}

// The note: solve the system by Jacobi's method. It converges only if the spectral radius of I − D⁻¹A, D the
// diagonal of A = M/h² + H, is below 1. With long steps, for which one takes the implicit step, it is not:
// with four masses and six springs it is 0.02 at h = 0.1 √(m/k), and 2.2 at 5 √(m/k).
TEST(Notes003, JacobisMethodDivergesAtLongSteps) {
  Cloth cloth = bare_cloth(4);
  cloth.term<SpringTerm>() = SpringTerm(1);
  const VecX x = (VecX(12) << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1).finished();
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < i; ++j)
      cloth.springs.elements.push_back(
          make_spring(i, j, (x.segment<3>(3 * i) - x.segment<3>(3 * j)).norm()));
  const auto radius = [&](double h) {
    MatX A = -K_of(cloth, x);
    A.diagonal().array() += 1 / (h * h);
    const VecX scale = A.diagonal().cwiseSqrt().cwiseInverse();
    const MatX symmetric = product({scale.asDiagonal(), A, scale.asDiagonal()});
    return (1 - eigenvalues(symmetric).array()).abs().maxCoeff();
  };
  EXPECT_NEAR(radius(0.1), 0.024, 5e-4);
  EXPECT_NEAR(radius(1), 1.081, 5e-4);
  EXPECT_NEAR(radius(5), 2.169, 5e-4);
}

// Bending ----------------------------------------------------------------------------------------

// The note finds u3 and u4, on the edge, from three properties: along the edge they add up to nothing, they
// lie in the plane of the normals, and all four add up to nothing. These do not suffice: exchanged, they have
// them, too. Only the torque tells them apart: it is zero.
TEST(Notes003, NetForceAloneDoesNotFixTheForcesOnTheEdge) {
  const FlatHinge hinge = {0.8, 0.4, 0.6, 0.7};
  const Vecs<4> p = hinge.folded(0.6);
  const auto [edge, N0, N1] = Normals(p);
  const Vec3 aside = N0.cross(N1).normalized();
  Vecs<4> u = angle_gradient(make_fold(p));
  const auto torque = [&] {
    Vec3 sum = Vec3::Zero();
    for (int i = 0; i < 4; ++i) sum += p[i].cross(u[i]);
    return sum.norm();
  };
  for (const bool exchanged : {false, true}) {
    EXPECT_LT((u[0] + u[1] + u[2] + u[3]).norm(), 1e-14);
    EXPECT_LT(std::abs((u[1] - u[2]).dot(edge)), 1e-14);
    EXPECT_LT(std::abs(u[1].dot(aside)) + std::abs(u[2].dot(aside)), 1e-14);
    EXPECT_EQ(torque() < 1e-13, !exchanged);
    std::swap(u[1], u[2]);
  }
}

}  // namespace springs_test
