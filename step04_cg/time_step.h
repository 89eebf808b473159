// Step 4: conjugate gradients.
//
//   M dv/dt = f(x, v),  dx/dt = v   the equation of motion
//   (M − h D − h² K) Δv = h (f + h K v),   K = ∂f/∂x,  D = ∂f/∂v
//   v += Δv,         x += h v       backward Euler, linearised once
#pragma once
#include "math/energy.h"
#include "math/method.h"
#include "math/pattern.h"
#include "math/preconditioner.h"
#include "math/tension.h"

namespace step04 {

// What a step computes; it lives from step to step, so that none allocates.
struct System {
  explicit System(const Cloth& cloth, const Method& method_ = {})
      : method(method_), f(cloth.mass.size()), b(f), dv(f), v(f), z(f), K(make_block_matrix(cloth)),
        A(K), slots(cloth, K), r(f.size()), c(r), q(r), s(r),
        preconditioner(make_preconditioner(method.preconditioner, A, cloth.pins, cloth.grid)) {
    if (damped(cloth)) D = D_start = K;
  }

  Method method;
  VecX f, b, dv, v, z;           // N, N·s, m/s, m/s, m/s
  BlockMatrix K, D, A, D_start;  // N/m, N·s/m, kg, N·s/m; D is empty without damping
  ClothSlots slots;
  VecX r, c, q, s;                                 // residual, N·s; direction, m/s; A c; P⁻¹ r
  std::unique_ptr<Preconditioner> preconditioner;  // P, near A
  State start, trial{f, VecX::Zero(f.size())};
  LastEnergy E{f.size()};
  Counters counts;
};

// 1. Forces and their derivatives -----------------------------------------------------------------

// All that one element's conditions add up to on its vectors y.
template <class Family>
struct Sum {
  Vecs<Family::Y> f = zero_vectors<Family::Y>();
  ElementMatrix<typename Family::Element> K, D;
  Tension<Family::Y> T;
};

// How a condition acts:  f = −∂E/∂y = −k C ∂C/∂y
// and how it is damped:  d = −kd Ċ ∂C/∂y,  Ċ = ∂C/∂y · ẏ
// Their derivatives:     K = −k ∂C/∂y ∂C/∂yᵀ − (k C + kd Ċ) ∂²C/∂y²,  D = −kd ∂C/∂y ∂C/∂yᵀ
// With --jacobian definite, K keeps of ∂²C/∂y² only the tension T of the element: A is positive definite.
template <class Family>
void act(const Term& term, const auto& c, Jacobian jacobian, const auto& ydot, Sum<Family>& sum) {
  double Cdot = 0;
  if (term.kd > 0)
    for (int m = 0; m < c.M; ++m) Cdot += c.dCdy[m].dot(ydot[c.first + m]);
  const double load = term.k * c.C + term.kd * Cdot;
  for (int m = 0; m < c.M; ++m) sum.f[c.first + m] -= load * c.dCdy[m];

  sum.T.add(term.k * c.C, c);
  for (int m = 0; m < c.M; ++m)
    for (int n = m; n < c.M; ++n) {
      const Mat3 ggT = c.dCdy[m] * c.dCdy[n].transpose();
      sum.K.add(c.first + m, c.first + n, -term.k * ggT);
      if (term.kd > 0) sum.D.add(c.first + m, c.first + n, -term.kd * ggT);
    }
  if (jacobian == Jacobian::bw98) add_second(-load, c, sum.K);
}

// One family of elements: gather y, let its conditions act there, and scatter to the vertices.
template <class Family>
void add_family(const Family& family, const State& state, System& system) {
  auto slot = system.slots.of(family).begin();
  for (const auto& element : family.elements) {
    const Vecs<Family::Y> y = gather(element, state.x), ydot = gather(element, state.v);
    Sum<Family> sum{.K = {element, *slot, system.K}, .D = {element, *slot, system.D}};
    family.conditions(element, y, [&](const Term& term, const auto& condition) {
      act(term, condition, system.method.jacobian, ydot, sum);
    });
    if (system.method.jacobian == Jacobian::definite) sum.T.subtract_from(sum.K, element, y);
    scatter(element, sum.f, system.f);
    sum.K.scatter(), sum.D.scatter();
    ++slot;
  }
}

inline void add_gravity(const Cloth& cloth, System& system) {
  for (int i = 0; i < cloth.vertices(); ++i)
    system.f.segment<3>(3 * i) += cloth.mass[3 * i] * *cloth.gravity;
}

inline void forces(const Cloth& cloth, const State& state, System& system) {
  system.f.setZero();
  system.K.set_zero(), system.D.set_zero();
  if (cloth.gravity) add_gravity(cloth, system);
  add_family(cloth.triangles, state, system);
  add_family(cloth.springs, state, system);
}

// 2. Conjugate gradients --------------------------------------------------------------------------

// The filter, r ← S r: removes from r its components in the directions that pins hold.
inline void filter(const Cloth& cloth, VecX& r) {
  for (const Pin& pin : cloth.pins) {
    const Vec3 r_i = r.segment<3>(3 * pin.vertex);
    r.segment<3>(3 * pin.vertex) = pin.S * r_i;
  }
}

// z: the velocity of the pin minus v in the directions that a pin holds, and zero in all others.
inline void prescribe(const Cloth& cloth, const VecX& v, VecX& z) {
  z.setZero();
  for (const Pin& pin : cloth.pins) {
    const Vec3 lacking = pin.velocity - v.segment<3>(3 * pin.vertex);
    z.segment<3>(3 * pin.vertex) = lacking - pin.S * lacking;
  }
}

// Modified conjugate gradients (BW98): minimises ½ Δvᵀ A Δv − bᵀ Δv over all Δv that equal z in the
// directions that pins hold. At the minimum the residual r = S (b − A Δv) is zero. Each direction c is
// A-conjugate to the earlier ones. The iteration ends at rᵀ P⁻¹ r ≤ tolerance² Δvᵀ M Δv: if P were A, the
// error of Δv would then be at most tolerance times Δv, both measured by their kinetic energy.
inline void conjugate_gradients(const Cloth& cloth, System& system) {
  VecX &dv = system.dv, &r = system.r, &c = system.c, &q = system.q, &s = system.s;
  system.A.multiply(dv, q);  // Δv = z
  r = system.b - q;
  filter(cloth, r);
  c.setZero();
  double delta_before = 1;
  for (int i = 0; i < system.method.max_iterations; ++i) {
    system.preconditioner->apply(r, s);
    filter(cloth, s);
    const double delta = r.dot(s), scale = dv.cwiseAbs2().dot(cloth.mass);
    const double enough = system.method.tolerance * system.method.tolerance * scale;
    if (delta >= 0 && delta <= enough) return;
    c = s + delta / delta_before * c;
    system.A.multiply(c, q);
    filter(cloth, q);
    const double cAc = c.dot(q);
    if (!(delta > 0 && cAc > 0)) {  // A or P is not definite, or holds a NaN
      ++system.counts.indefinite;
      return;
    }
    dv += delta / cAc * c;
    r -= delta / cAc * q;
    delta_before = delta;
    ++system.counts.iterations;
  }
  ++system.counts.capped;
}

// 3. Time step ------------------------------------------------------------------------------------

// A = M − h D − h² K, and A Δv = b with the change of v that the pins prescribe.
inline void solve(const Cloth& cloth, double h, const VecX& v, System& system) {
  system.A.set_diagonal(cloth.mass);
  system.A.add(-h, system.D);
  system.A.add(-h * h, system.K);
  system.preconditioner->set(system.A);
  prescribe(cloth, v, system.dv);
  conjugate_gradients(cloth, system);
}

// E(x0 + h v) + ½ |v − u|²_M: the energy at the end of the step, seen from a frame that moves with u.
inline double energy(const Cloth& cloth, double h, const VecX& v, const VecX& u, System& system) {
  return system.E.at(cloth, system.start.x + h * v) + kinetic_energy(cloth, v - u);
}

// Φ(v) = ½ |v − v0|²_M + E(x0 + h v) − h/2 vᵀ D v: backward Euler's v, with D as at x0, minimises it.
inline double potential(const Cloth& cloth, double h, const VecX& v, System& system) {
  return energy(cloth, h, v, system.start.v, system) - 0.5 * h * system.D.form(v);
}

// The fraction of Δv to take. fall = bᵀΔv is −dΦ/dstep. The step is halved until Φ falls by at least
// 1e-4 · step · fall (Armijo), but for rounding. Zero if Φ falls nowhere along Δv.
inline double line_search(const Cloth& cloth, double h, const VecX& v, System& system) {
  const double Phi = potential(cloth, h, v, system), most = Phi + 1e-12 * std::abs(Phi);
  const double fall = system.b.dot(system.dv);
  for (double step = fall < 0 ? -1 : 1; std::abs(step) > 1e-12; step /= 2) {
    system.v = v + step * system.dv;
    if (potential(cloth, h, system.v, system) <= most - 1e-4 * step * fall) return step;
  }
  return 0;
}

// Newton's method on Φ, from standing still: b = −Φ', and A is Φ'' or its definite part. Converged: the
// Newton decrement bᵀΔv is at most 1e-8 of the first one, and so Δv about 1e-4 of the first Δv.
inline void newton_step(const Cloth& cloth, double h, int limit, State& state, System& system) {
  VecX &v = (state.v = system.z), &v0 = system.start.v;
  double enough = 1e-20 * std::abs(energy(cloth, h, v, v0, system)), step = 1;
  bool converged = false;
  for (int iteration = 0; iteration < limit && !converged && step != 0; ++iteration) {
    system.trial.x = system.start.x + h * v;
    forces(cloth, system.trial, system);
    if (iteration == 0) system.D_start = system.D;
    system.D = system.D_start;
    system.b = cloth.mass.cwiseProduct(v0 - v) + h * system.f;
    system.D.add_product(h, v, system.b);
    solve(cloth, h, v, system);
    const double decrement = system.b.dot(system.dv);
    if (iteration == 0) enough += 1e-8 * std::abs(decrement);
    step = line_search(cloth, h, v, system);
    v += step * system.dv;
    converged = std::abs(decrement) <= enough;
  }
  if (!converged) ++system.counts.unconverged;
  state.x = system.start.x + h * v;
}

// The guard: true if v leaves more energy than standing still, v = z, would, beyond the rounding of x and E.
inline bool gains_energy(const Cloth& cloth, double h, const VecX& v, System& system) {
  const double still = energy(cloth, h, system.z, system.start.v, system);
  const double moved = energy(cloth, h, v, system.z, system);
  const bool moves = !(h * (v - system.z).norm() <= 1e-12 * system.start.x.norm());
  return moves && !(moved <= still + 1e-12 * std::abs(still));
}

inline void time_step(const Cloth& cloth, double h, State& state, System& system) {
  system.start = state;
  stand_still(cloth, h, state.v, system.z);
  if (system.method.newton > 1) return newton_step(cloth, h, system.method.newton, state, system);
  forces(cloth, state, system);
  system.K.multiply(state.v, system.b);
  system.b = h * (system.f + h * system.b);
  solve(cloth, h, state.v, system);
  state.v += system.dv;
  state.x += h * state.v;
  if (system.method.guarded() && gains_energy(cloth, h, state.v, system)) {
    ++system.counts.redone;
    newton_step(cloth, h, 5, state, system);
  }
}

}  // namespace step04
