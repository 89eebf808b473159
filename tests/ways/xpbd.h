// XPBD: extended position-based dynamics (Macklin, Müller & Chentanez 2016).
//
// Every condition has a multiplier λ = −h² k C, so that h² f = λ ∂C/∂x. A sweep visits one condition after
// the other. It moves the vertices of the condition along M⁻¹ ∇Cᵀ, so far that λ is right where they arrive:
//
//   Δλ = −(C + α̃ λ + γ ∇C (x − x0)) / ((1 + γ) ∇C M⁻¹ ∇Cᵀ + α̃),   α̃ = 1/(k h²),  γ = kd/(k h)
//   x += M⁻¹ ∇Cᵀ Δλ
//
// No matrix is needed, and a soft condition costs as much as a stiff one. But x − x̃ is a sum of M⁻¹ ∇Cᵀ Δλ
// with every ∇C as it was when its Δλ was found. Where ∇C turns in a step, the sweeps end near the minimum of
// Φ, and not there.
#pragma once
#include "ways/sweeps.h"

namespace xpbd {

struct System {
  System(const Cloth& cloth, int sweeps_) : sweeps(sweeps_), S(free_directions(cloth)) {}

  int sweeps;                  // per step
  std::vector<Mat3> S;         // what pins leave free
  std::vector<double> lambda;  // of every condition, in the order of the sweep
  State start;
  Reads reads;
};

// One condition, with both sides of Δλ times k h²: so k may be zero.
template <class Element, class Condition>
void project(const Cloth& cloth, double h, const Element& element, const Term& term,
             const Condition& c, System& system, double& lambda, VecX& x) {
  Vecs<Element::N> step;    // M⁻¹ ∇Cᵀ
  double w = 0, moved = 0;  // ∇C M⁻¹ ∇Cᵀ and ∇C (x − x0)
  for (int i = 0; i < Element::N; ++i) {
    const int at = element.vertices[i];
    const Vec3 dCdx = gradient(element, c, i);
    step[i] = cloth.inverse_mass[3 * at] * (system.S[at] * dCdx);
    w += dCdx.dot(step[i]);
    moved += dCdx.dot(x.segment<3>(3 * at) - system.start.x.segment<3>(3 * at));
  }
  const double k = h * h * term.k, kd = h * term.kd;
  const double dlambda = -(k * c.C + kd * moved + lambda) / ((k + kd) * w + 1);
  lambda += dlambda;
  for (int i = 0; i < Element::N; ++i) x.segment<3>(3 * element.vertices[i]) += dlambda * step[i];
}

// Gauss–Seidel: each condition of an element sees where the one before has moved the vertices.
inline void sweep(const Cloth& cloth, double h, System& system, VecX& x) {
  size_t next = 0;
  for_each_family(cloth, [&](const auto& family) {
    for (const auto& element : family.elements)
      for (int which = 0, conditions = 1; which < conditions; ++which) {
        conditions = 0;
        ++system.reads.forces;
        family.conditions(element, gather(element, x), [&](const Term& term, const auto& c) {
          if (conditions++ != which) return;
          if (next == system.lambda.size()) system.lambda.push_back(0);
          project(cloth, h, element, term, c, system, system.lambda[next++], x);
        });
      }
  });
}

inline void time_step(Cloth& cloth, double h, State& state, System& system) {
  system.start = state;
  follow(cloth.hinges.elements, state.x);
  fly(cloth, h, system.start, state.x);
  std::fill(system.lambda.begin(), system.lambda.end(), 0);
  for (int n = 0; n < system.sweeps; ++n) sweep(cloth, h, system, state.x);
  state.v = (state.x - system.start.x) / h;
}

}  // namespace xpbd
