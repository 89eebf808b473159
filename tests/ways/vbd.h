// VBD: vertex block descent (Chen, Liu, Yang & Yuksel 2024).
//
// A sweep visits one vertex after the other and takes a step of Newton's method on Φ, in which only this
// vertex moves. That is a system of three equations:
//
//   (m/h² I − K_ii) δ = m/h² (x̃_i − x_i) − ∂E/∂x_i,   −K_ii = Σ k ∂C/∂x_i ∂C/∂x_iᵀ + tension
//
// The block is that of the definite matrix (math/tension.h). So Φ falls along δ, and δ is halved until it
// has fallen: every vertex step takes energy from Φ, and more sweeps come nearer to its minimum. Until they
// are there, the forces between two vertices do not cancel: momentum is only as good as the solution.
//
// Damping adds Σ kd/(2h) (∂C/∂y (y − y0))² to Φ, with ∂C/∂y as at x0: the −h/2 vᵀ D v of steps 3 to 5.
#pragma once
#include "math/tension.h"
#include "support/both_halves.h"
#include "ways/vertex_potential.h"

namespace vbd {

struct System : VertexPotential {
  System(const Cloth& cloth, int sweeps_)
      : VertexPotential(cloth), sweeps(sweeps_), S(free_directions(cloth)) {}

  int sweeps;           // per step
  std::vector<Mat3> S;  // what pins leave free
};

// δ of vertex i, m: A δ = f, with f = −Φ' and A the definite part of Φ'', in the free directions.
inline Vec3 newton(const Cloth& cloth, const VecX& x, int i, System& system) {
  Vec3 f = -system.inertia(cloth, i) * system.away(x, i);
  Mat3 A = system.inertia(cloth, i) * Mat3::Identity();
  const auto add = [&]<class F>(const F& family, const auto& element, int corner) {
    ++system.reads.forces;
    Tension<F::Y> T;
    system.conditions(family, element, x, [&](const Term& term, const auto& c) {
      const Vec3 dCdx = gradient(element, c, corner);
      f -= term.k * c.C * dCdx;
      A += term.k * dCdx * dCdx.transpose();
      T.add(term.k * c.C, c);
    });
    BothHalves<F::Y> K;
    T.subtract_from(K, element, gather(element, x));
    for (int m = 0; m < F::Y; ++m)
      for (int n = 0; n < F::Y; ++n)
        A -= weight(element, m, corner) * weight(element, n, corner) * K.blocks[m][n];
  };
  system.for_each_corner(cloth, i, add);
  const Mat3 &S = system.S[i], held = Mat3::Identity() - S;
  return (S * A * S + held).ldlt().solve(S * f);
}

// The step of one vertex, halved until Φ has fallen, but for rounding.
inline void descend(const Cloth& cloth, VecX& x, int i, System& system) {
  const Vec3 before = x.segment<3>(3 * i), delta = newton(cloth, x, i, system);
  const double most = (1 + 1e-14) * system.at(cloth, x, i);
  for (double step = 1; step > 1e-12; step /= 2) {
    x.segment<3>(3 * i) = before + step * delta;
    if (system.at(cloth, x, i) <= most) return;
  }
  x.segment<3>(3 * i) = before;
}

inline void time_step(Cloth& cloth, double h, State& state, System& system) {
  follow(cloth.hinges.elements, state.x);
  system.begin(cloth, h, state);
  state.x = system.flight;
  for (int n = 0; n < system.sweeps; ++n)
    for (int i = 0; i < cloth.vertices(); ++i)
      if (!system.S[i].isZero(0)) descend(cloth, state.x, i, system);
  state.v = (state.x - system.start.x) / h;
}

}  // namespace vbd
