// The properties of every model, for all terms of the lists (math/cloth.h): derivatives, forces, momentum,
// rigid motion, the definite matrix, damping.
#include "math/energy.h"
#include "support/assembly.h"
#include "support/differences.h"
#include "support/every_term.h"

namespace every_model_test {

VecX one_number(double value) {
  return VecX::Constant(1, value);
}

double lowest_over_highest(const MatX& symmetric) {
  const VecX values = eigenvalues(symmetric);
  return values.minCoeff() / std::max(values.cwiseAbs().maxCoeff(), 1e-300);
}

// Positions have 16 digits. The rounding error of a force, N, …
double rounding(const TermSample& s) {
  return 1e-14 * (s.x.norm() + 2) * Assembly(s.cloth, Jacobian::bw98).K(s.x).norm();
}
// … and the relative one of a gradient.
double relative_rounding(const TermSample& s) {
  return 1e-14 * (s.x.norm() + 2) / std::min(s.length, 1.0);
}

Vec3 sum(const VecX& f) {
  return f.reshaped(3, f.size() / 3).rowwise().sum();
}
Vec3 torque(const VecX& x, const VecX& f) {
  Vec3 about_the_first = Vec3::Zero();
  for (int i = 3; i < f.size(); i += 3)
    about_the_first += Vec3(x.segment<3>(i) - x.head<3>()).cross(f.segment<3>(i));
  return about_the_first;
}

class EveryModel : public testing::TestWithParam<ListedTerm> {
 protected:
  template <class Test>
  void for_each_sample(unsigned seed, int each, const Test& test) const {
    for (const TermSample& sample : GetParam().samples(seed, each)) {
      SCOPED_TRACE(sample.pose);
      test(sample);
    }
  }
  Rotation rotation() const { return GetParam().info.rotation; }
};

// Derivatives ------------------------------------------------------------------------------------

TEST_P(EveryModel, GradientIsTheSlopeOfC) {
  for_each_sample(1, 10, [](const TermSample& s) {
    const size_t conditions = dense_conditions(s.cloth, s.x).size();
    for (size_t i = 0; i < conditions; ++i)
      EXPECT_TRUE(is_slope(
          [&](const VecX& x) { return one_number(dense_conditions(s.cloth, x)[i].C); },
          [&](const VecX& x) -> MatX { return dense_conditions(s.cloth, x)[i].g.transpose(); }, s.x,
          s.length))
          << "condition " << i;
  });
}

TEST_P(EveryModel, SecondDerivativeIsTheSlopeOfTheGradient) {
  for_each_sample(2, 10, [](const TermSample& s) {
    const size_t conditions = dense_conditions(s.cloth, s.x).size();
    for (size_t i = 0; i < conditions; ++i)
      EXPECT_TRUE(is_slope([&](const VecX& x) { return dense_conditions(s.cloth, x)[i].g; },
                           [&](const VecX& x) { return dense_conditions(s.cloth, x)[i].H; }, s.x,
                           s.length))
          << "condition " << i;
  });
}

TEST_P(EveryModel, SecondDerivativeIsSymmetric) {
  for_each_sample(3, 20, [](const TermSample& s) {
    for (const DenseCondition& c : dense_conditions(s.cloth, s.x))
      EXPECT_LE((c.H - c.H.transpose()).norm(), 1e-13 / std::min(s.length, 1.0) * c.H.norm());
  });
}

TEST_P(EveryModel, ForceIsTheFallingSlopeOfTheEnergy) {
  for_each_sample(4, 10, [](const TermSample& s) {
    Assembly steps(s.cloth);
    EXPECT_TRUE(is_slope([&](const VecX& x) { return one_number(potential_energy(s.cloth, x)); },
                         [&](const VecX& x) -> MatX { return -steps.f(x).transpose(); }, s.x,
                         s.length));
  });
}

TEST_P(EveryModel, KIsTheSlopeOfTheForce) {
  for_each_sample(5, 10, [](const TermSample& s) {
    Assembly steps(s.cloth, Jacobian::bw98);
    EXPECT_TRUE(is_slope([&](const VecX& x) { return steps.f(x); },
                         [&](const VecX& x) { return steps.K(x); }, s.x, s.length));
  });
}

// Momentum and rigid motion ----------------------------------------------------------------------

TEST_P(EveryModel, ForcesAddUpToNothing) {
  double largest = 0;
  for_each_sample(6, 20, [&](const TermSample& s) {
    const VecX f = Assembly(s.cloth).f(s.x);
    EXPECT_LE(sum(f).norm(), 1e-14 * f.norm() + rounding(s));
    largest = std::max(largest, f.norm());
  });
  EXPECT_GT(largest, 0.1) << "no force to judge";
}

TEST_P(EveryModel, AMoveChangesNothing) {
  Random random(7);
  for_each_sample(8, 20, [&](const TermSample& s) {
    Assembly steps(s.cloth);
    const VecX there = moved(s.x, Mat3::Identity(), random.vector(3, 1)), f = steps.f(s.x);
    const double E = potential_energy(s.cloth, s.x), slack = 1e-13 * f.norm() + rounding(s);
    EXPECT_NEAR(potential_energy(s.cloth, there), E, 1e-13 * E + slack * (s.x.norm() + 2));
    EXPECT_LE((steps.f(there) - f).norm(), slack);
  });
}

// TermInfo names the models for which it is not so, and has to be right for every model.
TEST_P(EveryModel, ARotationChangesNoEnergyAndTurnsTheForces) {
  Random random(9);
  bool energy = false, forces = false, torques = false;
  for_each_sample(10, 20, [&](const TermSample& s) {
    Assembly steps(s.cloth);
    const Mat3 R = random.rotation();
    const VecX there = moved(s.x, R, Vec3::Zero()), f = steps.f(s.x);
    const double E = potential_energy(s.cloth, s.x), slack = 1e-13 * f.norm() + rounding(s);
    const double arm = s.x.norm() + 2;
    energy |= std::abs(potential_energy(s.cloth, there) - E) > 1e-13 * E + slack * arm;
    forces |= (steps.f(there) - moved(f, R, Vec3::Zero())).norm() > slack;
    torques |= torque(s.x, f).norm() > slack * arm;
  });
  EXPECT_EQ(energy, rotation() == Rotation::stored);
  EXPECT_EQ(forces, rotation() == Rotation::stored);
  EXPECT_EQ(torques, rotation() == Rotation::stored);
}

// The definite matrix ----------------------------------------------------------------------------

// k ∂C ∂Cᵀ and the tension, found from the second derivatives with eigenvectors. (A degenerate triangle has
// no normal.)
TEST_P(EveryModel, TheDefiniteMatrixKeepsTheTension) {
  bool kept = false;
  for_each_sample(21, 20, [&](const TermSample& s) {
    if (s.length < 1e-2) return;
    MatX K = dense_tension(s.cloth, s.x);
    kept = kept || !K.isZero(0);
    for (const DenseCondition& c : dense_conditions(s.cloth, s.x))
      K += c.term.k * c.g * c.g.transpose();
    EXPECT_LT(relative(-Assembly(s.cloth).K(s.x), K), 1e-9);
  });
  const bool has_tension = GetParam().info.units.k == newton_per_metre.k;
  EXPECT_EQ(kept, has_tension && rotation() != Rotation::stored)
      << "of bending and of a linear model nothing is kept";
}

TEST_P(EveryModel, TheDefiniteMatrixHasNoNegativeEigenvalue) {
  for_each_sample(9, 500, [](const TermSample& s) {
    Assembly steps(s.cloth);
    EXPECT_GE(lowest_over_highest(-steps.K(s.x)), -1e-12);
    EXPECT_GE(lowest_over_highest(-steps.D(s.x)), -1e-12);
  });
}

// The test above can fail: where a second derivative is not zero, the matrix as printed is indefinite in
// some pose.
TEST_P(EveryModel, TheMatrixOfBaraffAndWitkinIsIndefiniteSomewhere) {
  bool curved = false;
  double lowest = 0;
  for_each_sample(10, 20, [&](const TermSample& s) {
    for (const DenseCondition& c : dense_conditions(s.cloth, s.x))
      curved = curved || !c.H.isZero(0);
    lowest = std::min(lowest, lowest_over_highest(-Assembly(s.cloth, Jacobian::bw98).K(s.x)));
  });
  EXPECT_EQ(curved, lowest < -1e-6) << "lowest eigenvalue over highest: " << lowest;
}

// Damping ----------------------------------------------------------------------------------------

// d·v = −Σ kd Ċ²
TEST_P(EveryModel, DampingTakesThePowerThatTheRatesSay) {
  Random random(11);
  for_each_sample(12, 20, [&](const TermSample& s) {
    Assembly steps(s.cloth);
    const VecX v = random.vector(int(s.x.size()), 2), d = steps.damping(s.x, v);
    double power = 0, scale = 0;
    for (const DenseCondition& c : dense_conditions(s.cloth, s.x)) {
      power -= c.term.kd * std::pow(c.g.dot(v), 2);
      scale += c.term.kd * c.g.squaredNorm() * v.squaredNorm();
    }
    EXPECT_LT(d.dot(v), 0);
    EXPECT_NEAR(d.dot(v), power, 1e-12 * scale + 1e-15 * steps.f(s.x).norm() * v.norm());
  });
}

TEST_P(EveryModel, DampingAddsUpToNothingAndResistsNoMove) {
  Random random(13);
  for_each_sample(14, 20, [&](const TermSample& s) {
    Assembly steps(s.cloth);
    const VecX v = random.vector(int(s.x.size()), 2), f = steps.f(s.x);
    const VecX drift = Vec3(random.vector(3, 2)).replicate(s.x.size() / 3, 1);
    const double slack = relative_rounding(s) * steps.D(s.x).norm() * v.norm() + 1e-14 * f.norm();
    EXPECT_LE(sum(steps.damping(s.x, v)).norm(), slack);
    EXPECT_LE((steps.f(s.x, v + drift) - steps.f(s.x, v)).norm(), slack);
  });
}

// TermInfo names the models for which it is not so, and has to be right for every model.
TEST_P(EveryModel, DampingHasNoTorqueAndResistsNoRotation) {
  Random random(15);
  bool torques = false, resists = false;
  for_each_sample(16, 20, [&](const TermSample& s) {
    Assembly steps(s.cloth);
    const Vec3 spin = random.vector(3, 2);
    const VecX v = random.vector(int(s.x.size()), 2), f = steps.f(s.x);
    VecX turning(v.size());
    for (int i = 0; i < v.size(); i += 3)
      turning.segment<3>(i) = spin.cross(Vec3(s.x.segment<3>(i)));
    const double slack =
        relative_rounding(s) * steps.D(s.x).norm() * (v.norm() + turning.norm()) + 1e-14 * f.norm();
    torques |= torque(s.x, steps.damping(s.x, v)).norm() > slack * (s.x.norm() + 2);
    resists |= steps.damping(s.x, turning).norm() > slack;
  });
  EXPECT_EQ(torques, rotation() != Rotation::free);
  EXPECT_EQ(resists, rotation() != Rotation::free);
}

TEST_P(EveryModel, DIsTheSlopeOfTheDampingForce) {
  Random random(17);
  for_each_sample(18, 10, [&](const TermSample& s) {
    Assembly steps(s.cloth);
    const VecX v = random.vector(int(s.x.size()), 2), f = steps.f(s.x), d = steps.damping(s.x, v);
    const MatX D = steps.D(s.x);
    EXPECT_LE((d - D * v).norm(), relative_rounding(s) * D.norm() * v.norm() + 1e-14 * f.norm());
  });
}

// A point ----------------------------------------------------------------------------------------

// All vertices in one place: there is no direction, so the force is zero, and everything is finite. A linear
// model has the directions of its axes.
TEST_P(EveryModel, AtAPointThereIsNoForceAndAllIsFinite) {
  for_each_sample(19, 2, [&](const TermSample& s) {
    const VecX x = Vec3(3, -2, 5).replicate(s.x.size() / 3, 1);
    EXPECT_TRUE(std::isfinite(potential_energy(s.cloth, x)));
    EXPECT_EQ(Assembly(s.cloth).f(x).isZero(0), rotation() != Rotation::stored);
    EXPECT_TRUE(Assembly(s.cloth).f(x).allFinite());
    EXPECT_TRUE(Assembly(s.cloth).K(x).allFinite());
    EXPECT_TRUE(Assembly(s.cloth, Jacobian::bw98).K(x).allFinite());
    EXPECT_TRUE(Assembly(s.cloth).D(x).allFinite());
    EXPECT_GE(lowest_over_highest(-Assembly(s.cloth).K(x)), -1e-12);
  });
}

INSTANTIATE_TEST_SUITE_P(Terms, EveryModel, testing::ValuesIn(every_term()),
                         [](const auto& term) { return term.param.name; });

// A test of is_slope: a right slope has order 2, and an error of one part in a million is found.
TEST(Differences, HaveOrderTwoAndFindASmallWrongTerm) {
  const Function f = [](const VecX& x) -> VecX { return x.array().exp(); };
  const Slope right = [](const VecX& x) -> MatX { return x.array().exp().matrix().asDiagonal(); };
  const Slope wrong = [&](const VecX& x) -> MatX { return right(x) * (1 + 1e-6); };
  const VecX x = VecX::Constant(2, 0.3);
  EXPECT_NEAR(order(f, right, x, 1e-2), 2, 0.01);
  EXPECT_TRUE(is_slope(f, right, x, 1));
  EXPECT_FALSE(is_slope(f, wrong, x, 1));
  EXPECT_FALSE(is_slope(
      f, [&](const VecX& at) -> MatX { return -right(at); }, x, 1));
  EXPECT_FALSE(is_slope(
      f, [&](const VecX& at) -> MatX { return right(at) * std::nan(""); }, x, 1));
}

}  // namespace every_model_test
