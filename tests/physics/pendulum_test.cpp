// One triangle, hung by two vertices, is a pendulum whose period is known at any amplitude:
//
//   T/T0 = 2 K(sin²(α/2))/π,   T0 = 2π √(l/g)      K: the complete elliptic integral of m = sin²
//
// A thread is a spring, so the pendulum is a little too long: by the pull m g (3 cos φ − 2 cos α) divided by
// the stiffness. This error, and not that of h, limits the accuracy of an explicit step. The error of h is
// (h ω_0)²/24, where ω_0² = g/l. The thread stretches by about m g/k_spring = g/ω², and a stable h has
// h ω < 2: so g/(l ω²) is always the larger error.
#include <gtest/gtest.h>

#include "step01_explicit/time_step.h"
#include "support/reference.h"
#include "support/scenes.h"

namespace pendulum_test {

// K(sin²(α/2)) = π / (2 AGM(1, cos(α/2)))                                                     Gauss
double period_ratio(double amplitude) {
  double a = 1, b = std::cos(amplitude / 2);
  while (a - b > 1e-15) {
    const double mean = (a + b) / 2;
    b = std::sqrt(a * b);
    a = mean;
  }
  return 1 / a;
}

// T/T0 of a triangle with a thread of stiffness k. T is the time from its first pass through the lowest point
// to the third; both are interpolated linearly between two steps.
double measured_ratio(double amplitude, double k, double h) {
  const TestScene scene = pendulum(amplitude, k, k / 2);
  step01::System system(scene.cloth);
  const auto angle = [](const State& s) { return std::atan2(s.x[8], -s.x[7]); };
  State state = scene.start;
  std::vector<double> passes;  // s
  const int patience = int(10 / h);
  for (int n = 0; n < patience && passes.size() < 3; ++n) {
    const double before = angle(state);
    step01::time_step(scene.cloth, h, state, system);
    const double after = angle(state);
    if (before * after < 0) passes.push_back(h * (n + before / (before - after)));
  }
  if (passes.size() < 3) return 0;
  return (passes[2] - passes[0]) / (2 * pi * std::sqrt(1 / g));
}

struct Swing {
  double degrees, ratio;  // ratio: K from tables, rounded to 8 digits

  double amplitude() const { return degrees * pi / 180; }
};
constexpr std::array<Swing, 4> swings = {
    {{30, 1.0174088}, {60, 1.0731820}, {90, 1.1803406}, {120, 1.3728805}}};

// Measured: 5.5e-5, 9.3e-5, 1.4e-4 and 1.7e-4 of the period, always too long.
TEST(Pendulum, HasThePeriodOfItsAmplitude) {
  for (const Swing& swing : swings) {
    const double exact = period_ratio(swing.amplitude());
    EXPECT_NEAR(exact, swing.ratio, 6e-8) << swing.degrees << " degrees";
    const double measured = measured_ratio(swing.amplitude(), 8000, 1e-3);
    EXPECT_NEAR(measured / exact, 1, 3e-4) << swing.degrees << " degrees";
  }
}

// Half the step allows four times the stiffness at the same h/h_crit, and that gives a quarter of the error.
TEST(Pendulum, ComesFourTimesCloserAsTheStepHalves) {
  for (const Swing& swing : swings) {
    const double exact = period_ratio(swing.amplitude());
    double error = 0;
    for (const auto& [h, k] : {std::pair{2e-3, 2e3}, {1e-3, 8e3}, {5e-4, 3.2e4}}) {
      const double before = error;
      error = measured_ratio(swing.amplitude(), k, h) / exact - 1;
      EXPECT_LT(std::abs(error), 2e-3) << swing.degrees << " degrees, h = " << h;
      if (before == 0) continue;
      EXPECT_NEAR(before / error, 4, 0.3) << swing.degrees << " degrees, h = " << h;
    }
  }
}

}  // namespace pendulum_test
