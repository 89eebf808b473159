// Membranes against the formulas of the literature: the energy ψ and the stress P = ∂ψ/∂F, per area at rest,
// with F = (w_u w_v), 3 × 2.
#include <gtest/gtest.h>

#include "support/decompositions.h"
#include "support/membranes.h"
#include "support/poses.h"

namespace membrane_test {

using Mat2 = Eigen::Matrix2d;
using Mat32 = Eigen::Matrix<double, 3, 2>;

struct Stress {
  double psi;
  Mat32 P;
};

const Mat2 I = Mat2::Identity();

// F = R S with S = √(FᵀF).
struct Polar {
  explicit Polar(const Mat32& F) {
    const auto [values, vectors] = eigenpairs(F.transpose() * F);
    S = vectors * values.cwiseSqrt().asDiagonal() * vectors.transpose();
    R = F * S.inverse();
  }
  Mat32 R;
  Mat2 S;
};

double double_dot(const Mat2& a, const Mat2& b) {
  return a.cwiseProduct(b).sum();
}

// ψ = μ E:E + λ/2 tr² E,   P = F (2 μ E + λ tr E I),   E = (FᵀF − I)/2
Stress stvk(const Mat32& F, const Moduli& m) {
  const Mat2 E = (F.transpose() * F - I) / 2;
  return {m.mu * double_dot(E, E) + m.lambda / 2 * std::pow(E.trace(), 2),
          F * (2 * m.mu * E + m.lambda * E.trace() * I)};
}

// ψ = μ |F − R|² + λ/2 tr² (S − I),   P = 2 μ (F − R) + λ tr (S − I) R
Stress corotated(const Mat32& F, const Moduli& m) {
  const Polar polar(F);
  const Mat32& R = polar.R;
  const Mat2& S = polar.S;
  const double trace = (S - I).trace();
  return {m.mu * (F - R).squaredNorm() + m.lambda / 2 * trace * trace,
          2 * m.mu * (F - R) + m.lambda * trace * R};
}

// ψ = μ/2 |F|² + κ/2 (J − γ)² − ψ(I),   P = μ F + κ (J − γ) ∂J/∂F,   γ = 1 + μ/κ,   ∂J/∂F = J F (FᵀF)⁻¹
Stress neo_hookean(const Mat32& F, const Moduli& m) {
  const Mat2 metric = F.transpose() * F;
  const double J = F.col(0).head<3>().cross(F.col(1).head<3>()).norm();
  const double kappa = m.kappa(), gamma = 1 + m.mu / kappa;
  const double at_rest = m.mu + m.mu * m.mu / (2 * kappa);
  return {m.mu / 2 * F.squaredNorm() + kappa / 2 * std::pow(J - gamma, 2) - at_rest,
          m.mu * F + kappa * (J - gamma) * J * F * metric.inverse()};
}

// ψ = μ/2 (|F|² − 2 − 2 ln J) + λ/2 ln² J,   P = μ (F − F⁻ᵀ) + λ ln J F⁻ᵀ,   F⁻ᵀ = F (FᵀF)⁻¹
Stress barrier(const Mat32& F, const Moduli& m) {
  const Mat2 metric = F.transpose() * F;
  const Mat32 F_inverse_T = F * metric.inverse();
  const double q = std::log(F.col(0).head<3>().cross(F.col(1).head<3>()).norm());
  return {m.mu / 2 * (F.squaredNorm() - 2 - 2 * q) + m.lambda / 2 * q * q,
          m.mu * (F - F_inverse_T) + m.lambda * q * F_inverse_T};
}

// ψ = μ ε:ε + λ/2 tr² ε,   P = Q (2 μ ε + λ tr ε I),   ε = (QᵀF + FᵀQ)/2 − I
Stress linear(const Mat32& F, const Moduli& m, const Mat32& Q) {
  const Mat2 strain = (Q.transpose() * F + F.transpose() * Q) / 2 - I;
  return {m.mu * double_dot(strain, strain) + m.lambda / 2 * std::pow(strain.trace(), 2),
          Q * (2 * m.mu * strain + m.lambda * strain.trace() * I)};
}

Mat32 matrix(const Vecs<2>& w) {
  Mat32 F;
  F << w[0], w[1];
  return F;
}

Stress usual(const std::string& name, const Mat32& F, const Moduli& m, const Mat32& Q) {
  if (name == "stvk") return stvk(F, m);
  if (name == "linear") return linear(F, m, Q);
  if (name == "neo-hookean") return neo_hookean(F, m);
  if (name == "neo-hookean-barrier") return barrier(F, m);
  return corotated(F, m);
}

// ψ and P of the conditions of a triangle:  a ψ = Σ k/2 C²,  a P = Σ k C ∂C/∂w
Stress of_conditions(const Model& model, const Triangle& t, const Vecs<2>& w) {
  Stress stress{0, Mat32::Zero()};
  model.triangles.conditions(t, w, [&](const Term& term, const auto& c) {
    stress.psi += 0.5 * term.k * c.C * c.C / t.area;
    for (int m = 0; m < c.M; ++m) stress.P.col(c.first + m) += term.k * c.C * c.dCdy[m] / t.area;
  });
  return stress;
}

class MembraneTest : public testing::TestWithParam<std::string> {
 protected:
  // λ < 0 is a cloth that widens when it is pulled. The barrier needs λ ≥ 0, arap has λ = 0.
  Moduli random_moduli(Random& random) const {
    const double mu = random.between(1, 10);
    if (GetParam() == "arap") return {mu, 0};
    const bool barrier = GetParam() == "neo-hookean-barrier";
    return {mu, random.between(barrier ? 0 : -0.9 * mu, 20)};
  }
  Model model(const Moduli& moduli) const { return with_membrane(GetParam(), moduli); }
};

TEST_P(MembraneTest, HasTheEnergyAndTheStressOfTheLiterature) {
  Random random(81);
  int poses = 0;
  for (const Pose pose : all_poses)
    for (int i = 0; i < 200; ++i) {
      const Vecs<2> w = pose_w(pose, random);
      if (w[0].cross(w[1]).norm() < 0.02) continue;
      const Triangle t = make_triangle(random_rest(random));
      const Moduli moduli = random_moduli(random);
      Model model = this->model(moduli);
      const Mat32 Q = matrix(axes_of({random.direction(), random.direction()}));
      if (auto& term = model.term<LinearMembrane>()) term->axes = {{Q.col(0), Q.col(1)}};
      const Stress ours = of_conditions(model, t, w),
                   theirs = usual(GetParam(), matrix(w), moduli, Q);
      const double scale = moduli.mu + std::abs(moduli.lambda) + theirs.P.norm();
      EXPECT_LT((ours.P - theirs.P).norm(), 1e-12 * scale) << name(pose);
      EXPECT_NEAR(ours.psi, theirs.psi, 1e-12 * (scale + theirs.psi)) << name(pose);
      ++poses;
    }
  EXPECT_GT(poses, 500);
}

// All are content at rest, however the cloth lies in space, and have there the same stiffness: the second
// derivative of ψ, for a change dF of F, is that of μ e:e + λ/2 tr² e with the strain e = (QᵀdF + dFᵀQ)/2.
TEST_P(MembraneTest, IsTheSameSheetNearRest) {
  Random random(82);
  for (int i = 0; i < 50; ++i) {
    const Mat32 Q = matrix(axes_of({random.direction(), random.direction()}));
    const Vecs<2> rest = {Q.col(0), Q.col(1)};
    const Triangle t = make_triangle(random_rest(random));
    const Moduli moduli = random_moduli(random);
    Model model = this->model(moduli);
    if (auto& term = model.term<LinearMembrane>()) term->axes = {rest};
    EXPECT_LT(of_conditions(model, t, rest).P.norm(), 1e-14 * moduli.kappa() + 1e-14 * moduli.mu);

    const Vecs<2> dw = {random.vector(3, 1), random.vector(3, 1)};
    constexpr double small = 1e-4;
    const auto psi = [&](double step) {
      return of_conditions(model, t, {rest[0] + step * dw[0], rest[1] + step * dw[1]}).psi;
    };
    const Mat2 QdF = Q.transpose() * matrix(dw), e = (QdF + QdF.transpose()) / 2;
    const double expected =
        moduli.mu * double_dot(e, e) + moduli.lambda / 2 * e.trace() * e.trace();
    EXPECT_NEAR((psi(small) + psi(-small)) / (2 * small * small), expected,
                1e-5 * (moduli.mu + std::abs(moduli.lambda)));
  }
}

INSTANTIATE_TEST_SUITE_P(Models, MembraneTest, testing::ValuesIn(membrane_names()),
                         [](const auto& model) {
                           std::string name = model.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

// S = √(FᵀF) has the trace √(A + D + 2J).
TEST(Metric, KnowsTheTraceOfTheStretch) {
  Random random(83);
  for (int i = 0; i < 100; ++i) {
    const Vecs<2> w = {random.vector(3, 2), random.vector(3, 2)};
    const Metric<double> m = metric(w);
    const Polar polar(matrix(w));
    EXPECT_NEAR(std::sqrt(m.A + m.D + 2 * m.J), polar.S.trace(), 1e-13);
    EXPECT_NEAR(m.J, polar.S.determinant(), 1e-12);
    EXPECT_LT((matrix(axes_of(w)) - polar.R).norm(), 1e-12 / m.J) << "the axes of linear are R";
  }
}

// The series and the closed form of φ(q) = 2 (e^q − 1 − q)/q² meet.
TEST(Metric, TheBarrierIsSmoothThroughRest) {
  const auto expect_slope = [](double (*f)(double), double (*slope)(double)) {
    for (double q = -6; q < 3; q += 0.0099) {
      constexpr double step = 1e-3;
      const double difference =
          (8 * (f(q + step) - f(q - step)) - (f(q + 2 * step) - f(q - 2 * step))) / (12 * step);
      EXPECT_NEAR(difference, slope(q), 1e-11 * (1 + std::abs(slope(q)))) << "q = " << q;
    }
  };
  expect_slope(phi<0>, phi<1>);
  expect_slope(phi<1>, phi<2>);
  EXPECT_DOUBLE_EQ(phi<0>(0), 1);
  EXPECT_NEAR(phi<0>(0.5), 8 * (std::expm1(0.5) - 0.5), 1e-15);
}

}  // namespace membrane_test
