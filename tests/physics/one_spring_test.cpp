// One mass on one spring, whose motion is known exactly. With the elongation x and ω² = k/m,
//
//   v += −h ω² x,   x += h v       has       x_{n+1} − 2 x_n + x_{n−1} = −h² ω² x_n,
//
// so each step turns the phase by 2 asin(h ω/2), for ever, and keeps an energy, though not the true one.
#include <gtest/gtest.h>

#include "math/stable_step.h"
#include "step01_explicit/time_step.h"
#include "support/reference.h"
#include "support/scenes.h"

namespace one_spring_test {

constexpr double k = 30, m = 0.7;  // N/m, kg
const double omega = std::sqrt(k / m);

// Vertex 1 on a spring along x that is 0.5 m long at rest; vertex 0 is pinned or of mass m as well.
Cloth mass_on_a_spring(bool pinned) {
  Cloth cloth;
  cloth.mass = VecX::Constant(6, m);
  cloth.inverse_mass = cloth.mass.cwiseInverse();
  if (pinned) {
    cloth.pins = {0};
    cloth.inverse_mass.head<3>().setZero();
  }
  cloth.springs.elements = {make_spring(0, 1, 0.5)};
  cloth.term<SpringTerm>() = SpringTerm(k);
  return cloth;
}

State pulled(double elongation) {
  State state{VecX::Zero(6), VecX::Zero(6)};
  state.x[3] = 0.5 + elongation;
  return state;
}

double elongation(const State& state) {
  return state.x[3] - 0.5;
}

// From rest, x_0 = A and x_1 = (1 − h² ω²) A: the solution of the recurrence is
// x_n = A cos((n + 1/2) θ)/cos(θ/2) with θ = 2 asin(h ω/2).
TEST(OneSpring, TurnsByTwiceTheArcsineOfHalfHOmega) {
  const Cloth cloth = mass_on_a_spring(true);
  step01::System system(cloth);
  for (const double h_omega : {0.01, 0.5, 1.0, 1.9}) {
    State state = pulled(0.1);
    const double theta = 2 * std::asin(h_omega / 2);
    for (int n = 1; n <= 1000; ++n) {
      step01::time_step(cloth, h_omega / omega, state, system);
      const double exact = 0.1 * std::cos((n + 0.5) * theta) / std::cos(theta / 2);
      ASSERT_NEAR(elongation(state), exact, 1e-10) << "step " << n << ", h ω = " << h_omega;
    }
  }
}

// m v²/2 + k x²/2 − h k x v/2 is constant: insert the step, and the terms in h cancel.
TEST(OneSpring, KeepsAnEnergyOfItsOwn) {
  const Cloth cloth = mass_on_a_spring(true);
  step01::System system(cloth);
  const double h = 1.5 / omega;
  const auto kept = [&](const State& s) {
    const double x = elongation(s), v = s.v[3];
    return m * v * v / 2 + k * x * x / 2 - h * k * x * v / 2;
  };
  State state = pulled(0.1);
  const double before = kept(state);
  for (int n = 1; n <= 1000; ++n) {
    step01::time_step(cloth, h, state, system);
    ASSERT_NEAR(kept(state), before, 1e-12 * before) << "step " << n;
  }
}

TEST(OneSpring, HasTheCriticalStepTwoOverOmega) {
  const Cloth cloth = mass_on_a_spring(true);
  step01::System system(cloth);
  EXPECT_NEAR(critical_step(cloth, pulled(0), step01::forces, system), 2 * std::sqrt(m / k), 1e-8);
}

// Two masses swing against each other. Each has half of the spring, and half a spring is twice as stiff.
TEST(OneSpring, BetweenTwoMassesHasARootTwoShorterCriticalStep) {
  const Cloth cloth = mass_on_a_spring(false);
  step01::System system(cloth);
  EXPECT_NEAR(critical_step(cloth, pulled(0), step01::forces, system), 2 * std::sqrt(m / (2 * k)),
              1e-8);
}

// With the damping force −2 ζ m ω v the limit is h ω = 2 (√(1 + ζ²) − ζ): damping lowers it.
TEST(OneSpring, HasALowerCriticalStepWhereDampingIsExplicit) {
  const Cloth cloth = mass_on_a_spring(true);
  step01::System system(cloth);
  for (const double zeta : {0.01, 0.1, 0.5, 1.0, 2.0}) {
    const auto damped = [&](const Cloth& c, const State& state, step01::System& s) {
      step01::forces(c, state, s);
      s.f[3] -= 2 * zeta * m * omega * state.v[3];
    };
    EXPECT_NEAR(critical_step(cloth, pulled(0), damped, system) * omega,
                2 * (std::sqrt(1 + zeta * zeta) - zeta), 1e-7)
        << "ζ = " << zeta;
  }
}

TEST(OneSpring, HasNoCriticalStepWhereItIsAbsent) {
  Cloth cloth = mass_on_a_spring(true);
  cloth.springs.elements.clear();
  cloth.gravity = Vec3(0, -g, 0);
  step01::System system(cloth);
  EXPECT_EQ(critical_step(cloth, pulled(0), step01::forces, system),
            std::numeric_limits<double>::infinity());
}

}  // namespace one_spring_test
