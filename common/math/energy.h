// The energies of a cloth, its elastic forces, and its motion as a whole.
#pragma once
#include "math/cloth.h"

// Σ k/2 C² over the conditions that `actor`, a family or one of its terms, has on these elements, J.
// `energy` is the sum so far.
template <class Actor, class Elements>
void add_elastic_energy(const Actor& actor, const Elements& elements, const VecX& x,
                        double& energy) {
  for (const auto& element : elements)
    actor.conditions(element, gather(element, x),
                     [&](const Term& term, const auto& c) { energy += 0.5 * term.k * c.C * c.C; });
}

// f −= k C ∂C/∂y over the elements of a family, carried to the vertices: the force without damping, N.
template <class Family>
void add_elastic_forces(const Family& family, const VecX& x, VecX& f) {
  for (const auto& element : family.elements) {
    Vecs<Family::Y> f_y = zero_vectors<Family::Y>();
    family.conditions(element, gather(element, x), [&](const Term& term, const auto& c) {
      for (int m = 0; m < c.M; ++m) f_y[c.first + m] -= term.k * c.C * c.dCdy[m];
    });
    scatter(element, f_y, f);
  }
}

// −Σ m g·x, J, zero at the origin.
inline double gravitational_energy(const Cloth& cloth, const VecX& x) {
  double energy = 0;
  if (cloth.gravity)
    for (int i = 0; i < cloth.vertices(); ++i)
      energy -= cloth.mass[3 * i] * cloth.gravity->dot(x.segment<3>(3 * i));
  return energy;
}

// The energy whose negative gradient is the force without damping, J.
inline double potential_energy(const Cloth& cloth, const VecX& x) {
  double energy = gravitational_energy(cloth, x);
  for_each_family(
      cloth, [&](const auto& family) { add_elastic_energy(family, family.elements, x, energy); });
  return energy;
}

// The potential energy of one cloth, and the positions it belongs to. Where pins stand still, a step begins
// at the positions whose energy the guard has just computed.
struct LastEnergy {
  explicit LastEnergy(Eigen::Index numbers) : x(VecX::Constant(numbers, std::nan(""))) {}

  template <class Positions>
  double at(const Cloth& cloth, const Positions& positions) {
    if (x == positions) return energy;
    x = positions;
    return energy = potential_energy(cloth, x);
  }

  VecX x;
  double energy = 0;
};

// ½ |v|²_M, J.
template <class Velocities>
double kinetic_energy(const Cloth& cloth, const Velocities& v) {
  return 0.5 * v.cwiseAbs2().dot(cloth.mass);
}

// z, m/s: the velocity of a cloth that does not deform in a step of h, and so stands still for whoever moves
// with it. Without pins it falls freely, all of it with
//
//   v̄ + h g,   v̄ = Σ m v / Σ m
//
// With pins it follows them (pin.h). In the directions that a pin holds, its vertex has the velocity of the
// pin. Only where pins move apart does z deform the cloth, beside them.
//
// An implicit step is measured against z, and Newton's method begins there. So the same cloth takes the same
// step for an observer at rest and for one in a train.
inline void stand_still(const Cloth& cloth, double h, const VecX& v, VecX& z) {
  Vec3 momentum = Vec3::Zero();
  double mass = 0;
  for (int i = 0; i < cloth.vertices(); ++i) {
    momentum += cloth.mass[3 * i] * v.segment<3>(3 * i);
    mass += cloth.mass[3 * i];
  }
  Vec3 whole = momentum / mass;
  if (cloth.gravity) whole += h * *cloth.gravity;
  whole = led_by(cloth.pins, whole);
  for (int i = 0; i < cloth.vertices(); ++i) z.segment<3>(3 * i) = whole;
  for (const Pin& pin : cloth.pins) z.segment<3>(3 * pin.vertex) = pin.held(whole);
}
