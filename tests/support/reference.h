// The reference for a step: the same cloth, moved by the classical Runge-Kutta method of order 4
// with steps so short that its error is negligible. And the measured order of a step.
#pragma once
#include <cmath>
#include <functional>
#include <vector>

#include "math/cloth.h"

// One step of length h on a state.
using Stepper = std::function<void(double h, State&)>;

// A step as the lessons write it, time_step(cloth, h, state, system), on this cloth. All three are
// held by reference.
template <class TimeStep, class System>
Stepper stepper(const Cloth& cloth, const TimeStep& time_step, System& system) {
  return [&](double h, State& state) { time_step(cloth, h, state, system); };
}

inline State simulate(const Stepper& step, State state, double end, long steps) {
  for (long n = 0; n < steps; ++n) step(end / double(steps), state);
  return state;
}

// y' = φ(y) for y = (x, v) and φ = (v, M⁻¹ f(x, v)):
//   φ1 = φ(y)   φ2 = φ(y + h/2 φ1)   φ3 = φ(y + h/2 φ2)   φ4 = φ(y + h φ3)
//   y += h/6 (φ1 + 2 φ2 + 2 φ3 + φ4)
// Pins have an inverse mass of zero, and so they stay where they are if they start at rest.
template <class Forces, class System>
Stepper rk4(const Cloth& cloth, const Forces& forces, System& system) {
  return [&](double h, State& y) {
    const auto slope = [&](const State& at) {
      forces(cloth, at, system);
      return State{at.v, cloth.inverse_mass.cwiseProduct(system.f)};
    };
    const auto along = [&](double t, const State& s) {
      return State{y.x + t * s.x, y.v + t * s.v};
    };
    const State s1 = slope(y), s2 = slope(along(h / 2, s1)), s3 = slope(along(h / 2, s2)),
                s4 = slope(along(h, s3));
    y.x += h / 6 * (s1.x + 2 * s2.x + 2 * s3.x + s4.x);
    y.v += h / 6 * (s1.v + 2 * s2.v + 2 * s3.v + s4.v);
  };
}

// The root of the mean squared distance, m, over the vertices that move.
inline double rms_distance(const Cloth& cloth, const VecX& x, const VecX& y) {
  const double moving = double((cloth.inverse_mass.array() > 0).count()) / 3;
  return (x - y).norm() / std::sqrt(moving);
}

// The errors of runs with `steps`, 2 `steps`, 4 `steps`, …, and the order
// over the last halving of h.
struct Convergence {
  std::vector<double> errors;  // m

  double last_order() const { return std::log2(errors[errors.size() - 2] / errors.back()); }
};

inline Convergence converge(const Cloth& cloth, const Stepper& step, const State& start, double end,
                            long steps, int halvings, const VecX& exact) {
  Convergence c;
  for (int i = 0; i <= halvings; ++i)
    c.errors.push_back(rms_distance(cloth, simulate(step, start, end, steps << i).x, exact));
  return c;
}
