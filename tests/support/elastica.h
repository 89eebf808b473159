// The heavy elastica: a thread of length 1 that cannot stretch, clamped horizontally at one end,
// and bent by its own weight. With θ, the angle below the horizontal at s from the clamp,
//
//   θ'' = −Γ (1 − s) cos θ,   θ(0) = 0,   θ'(1) = 0,   Γ = ρ g L³/B
//
// Γ, the weight relative to the stiffness, is the only parameter. Seen from the free end, with
// t = 1 − s and u = π/2 − θ, the angle to the vertical, this is an initial value problem:
//
//   u'' = Γ t sin u,   u(0) = ε,   u'(0) = 0,   where ε is such that u(1) = π/2
#pragma once
#include <array>
#include <cmath>
#include <numbers>

struct Elastica {
  double W, H;    // how far the free end is from the clamp, sideways and down
  double tip;     // θ at the free end
  double beyond;  // u(1) − π/2: zero where the clamp is horizontal

  double droop() const { return H / W; }
};

// Integrates from the free end, at the angle ε to the vertical, to the clamp: Runge-Kutta, order 4.
inline Elastica shoot(double Gamma, double epsilon, int steps) {
  using Y = std::array<double, 4>;  // u, u', W, H
  const auto slope = [&](double t, const Y& y) -> Y {
    return {y[1], Gamma * t * std::sin(y[0]), std::sin(y[0]), std::cos(y[0])};
  };
  const auto along = [](Y y, double dt, const Y& s) {
    for (int i = 0; i < 4; ++i) y[i] += dt * s[i];
    return y;
  };
  Y y = {epsilon, 0, 0, 0};
  const double dt = 1.0 / steps;
  for (int n = 0; n < steps; ++n) {
    const double t = n * dt;
    const Y s1 = slope(t, y), s2 = slope(t + dt / 2, along(y, dt / 2, s1)),
            s3 = slope(t + dt / 2, along(y, dt / 2, s2)), s4 = slope(t + dt, along(y, dt, s3));
    for (int i = 0; i < 4; ++i) y[i] += dt / 6 * (s1[i] + 2 * s2[i] + 2 * s3[i] + s4[i]);
  }
  const double quarter = std::numbers::pi / 2;
  return {y[2], y[3], quarter - epsilon, y[0] - quarter};
}

// For a large Γ, ε is too small to guess, so the search is for its logarithm. Several ε make the
// clamp horizontal. The larger ones give shapes with loops, into which no thread falls by itself.
// The smallest ε is the real one.
inline Elastica elastica(double Gamma, int steps = 2000) {
  double high = -2 - std::sqrt(Gamma);  // too small: u grows by about exp(2/3 √Γ)
  while (shoot(Gamma, std::exp(high), steps).beyond < 0) high += 0.3;
  double low = high - 0.3;
  for (int i = 0; i < 50; ++i) {
    const double middle = (low + high) / 2;
    (shoot(Gamma, std::exp(middle), steps).beyond < 0 ? low : high) = middle;
  }
  return shoot(Gamma, std::exp(low), steps);
}

// The Γ of the elastica with this droop, by the secant method from a guess.
inline double gamma_of_droop(double droop, double guess) {
  const auto too_much = [&](double Gamma) { return elastica(Gamma, 500).droop() - droop; };
  double before = guess, Gamma = 1.1 * guess, error = too_much(before);
  for (int i = 0; i < 20 && std::abs(Gamma - before) > 1e-10 * Gamma; ++i) {
    const double next = too_much(Gamma), step = next * (Gamma - before) / (next - error);
    before = Gamma;
    error = next;
    Gamma -= step;
  }
  return Gamma;
}
