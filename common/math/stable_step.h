// The longest step that symplectic Euler survives.
//
// A motion that flips its sign every step, x_n = (−1)ⁿ p, is where the method turns unstable. Put
// into v += h M⁻¹ (−K̂ x − D̂ v), x += h v it gives
//
//   (h² K̂ + 2 h D̂) p = 4 M p ,      K̂ = −∂f/∂x,  D̂ = −∂f/∂v
//
// so h_crit is the h at which the largest eigenvalue of M⁻¹ (h² K̂ + 2 h D̂) is 4. Without damping
// that is 2/ω_max, and for one mode with ζ = D̂ ω/(2 K̂) it is h ω = 2 (√(1 + ζ²) − ζ).
#pragma once
#include <cmath>
#include <limits>

#include "math/cloth.h"

// Power iteration on M⁻¹ (h² K̂ + 2 h D̂), where h follows the Rayleigh quotients of the vector p so
// far: h² κ + 2 h δ = 4. Until h changes by less than 1e-4 of itself over 20 iterations. Products
// with K̂ and D̂ are central differences of forces(cloth, state, system), which leaves f in system.f.
// Infinite where nothing pulls back.
template <class Forces, class System>
double critical_step(const Cloth& cloth, const State& state, const Forces& forces, System& system) {
  const auto difference = [&](const VecX& dx, const VecX& dv) -> VecX {  // −(f(+) − f(−))/2
    forces(cloth, State{state.x - dx, state.v - dv}, system);
    const VecX before = system.f;
    forces(cloth, State{state.x + dx, state.v + dv}, system);
    return 0.5 * (before - system.f);
  };
  const VecX zero = VecX::Zero(state.x.size());
  const VecX free = (cloth.inverse_mass.array() > 0).cast<double>();

  // A start that no mode is orthogonal to: irregular, and the same on every machine.
  VecX p(state.x.size());
  for (int i = 0; i < p.size(); ++i) p[i] = free[i] * std::sin(1.0 + 12.9898 * i * (1 + i % 7));

  const double reach = 1e-7;  // m, of a difference
  double h = std::numeric_limits<double>::infinity(), h_before = h;
  for (int iteration = 0; iteration < 2000; ++iteration) {
    const double step = reach / p.cwiseAbs().maxCoeff();
    const VecX Kp = free.cwiseProduct(difference(step * p, zero)) / step;
    const VecX Dp = free.cwiseProduct(difference(zero, step * p)) / step;
    const double pMp = p.cwiseAbs2().dot(cloth.mass);
    const double kappa = std::abs(p.dot(Kp)) / pMp, delta = std::max(0.0, p.dot(Dp) / pMp);
    if (!(kappa + delta > 0)) return std::numeric_limits<double>::infinity();
    h = 4 / (delta + std::sqrt(delta * delta + 4 * kappa));
    p = cloth.inverse_mass.cwiseProduct(h * h * Kp + 2 * h * Dp);
    p /= p.norm();
    if (iteration % 20 == 19) {
      if (std::abs(h - h_before) < 1e-4 * h) return h;
      h_before = h;
    }
  }
  return h;
}
