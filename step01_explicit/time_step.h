// Step 1: explicit stretch and shear.
//
//   M dv/dt = f(x),  dx/dt = v      the equation of motion
//   v += h M⁻¹ f,    x += h v       symplectic Euler: the new v moves x
#pragma once
#include "math/cloth.h"

namespace step01 {

// What a step computes; it lives from step to step, so that none allocates.
struct System {
  explicit System(const Cloth& cloth) : f(cloth.mass.size()) {}

  VecX f;  // N
};

// 1. Forces ---------------------------------------------------------------------------------------

// All that one element's conditions add up to on its vectors y.
template <class Family>
struct Sum {
  Vecs<Family::Y> f = zero_vectors<Family::Y>();
};

// How a condition acts:  f = −∂E/∂y = −k C ∂C/∂y
template <class Family>
void act(const Term& term, const auto& c, Sum<Family>& sum) {
  for (int m = 0; m < c.M; ++m) sum.f[c.first + m] -= term.k * c.C * c.dCdy[m];
}

// One family of elements: gather y, let its conditions act there, and scatter to the vertices.
template <class Family>
void add_family(const Family& family, const State& state, System& system) {
  for (const auto& element : family.elements) {
    const Vecs<Family::Y> y = gather(element, state.x);
    Sum<Family> sum;
    family.conditions(element, y,
                      [&](const Term& term, const auto& condition) { act(term, condition, sum); });
    scatter(element, sum.f, system.f);
  }
}

inline void add_gravity(const Cloth& cloth, System& system) {
  for (int i = 0; i < cloth.vertices(); ++i)
    system.f.segment<3>(3 * i) += cloth.mass[3 * i] * *cloth.gravity;
}

inline void forces(const Cloth& cloth, const State& state, System& system) {
  system.f.setZero();
  if (cloth.gravity) add_gravity(cloth, system);
  add_family(cloth.triangles, state, system);
  add_family(cloth.springs, state, system);
}

// 2. Time step ------------------------------------------------------------------------------------

inline void time_step(const Cloth& cloth, double h, State& state, System& system) {
  forces(cloth, state, system);
  state.v += h * cloth.inverse_mass.cwiseProduct(system.f);
  state.x += h * state.v;
}

}  // namespace step01
