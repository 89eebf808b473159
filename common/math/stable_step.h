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
#include <functional>

#include "math/cloth.h"

// Power iteration on M⁻¹ (h² K̂ + 2 h D̂). In every iteration h solves h² κ + 2 h δ = 4 with the Rayleigh
// quotients κ, δ of the current vector p. It ends when h has changed by less than 1e-4 of itself over 20
// iterations, or after 2000 iterations: then the last h is returned. Products with K̂ and D̂ are central
// differences of forces(state), N. Infinite where nothing pulls back.
double critical_step(const Cloth&, const State&,
                     const std::function<const VecX&(const State&)>& forces);

// The same for the forces(cloth, state, system) of a step, which leaves f in system.f.
template <class Forces, class System>
double critical_step(const Cloth& cloth, const State& state, const Forces& forces, System& system) {
  return critical_step(cloth, state, [&](const State& at) -> const VecX& {
    forces(cloth, at, system);
    return system.f;
  });
}
