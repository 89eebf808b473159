// The potential energy of a cloth, elastic and gravitational, and its elastic forces.
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

// ½ |v|²_M, J.
template <class Velocities>
double kinetic_energy(const Cloth& cloth, const Velocities& v) {
  return 0.5 * v.cwiseAbs2().dot(cloth.mass);
}
