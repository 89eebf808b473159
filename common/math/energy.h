// What a cloth has stored: elastic energy, and energy of height.
#pragma once
#include "math/cloth.h"

// Σ k/2 C² over the elements of a family, handed term by term to add(term, J).
template <class Family, class Add>
void add_elastic_energy(const Family& family, const VecX& x, const Add& add) {
  for (const auto& element : family.elements)
    family.conditions(
        element, gather(element, x),
        [&](const Term& term, const auto& c, const auto&) { add(term, 0.5 * term.k * c.C * c.C); });
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
  const auto add = [&](const Term&, double joule) { energy += joule; };
  for_each_family(cloth, [&](const auto& family) { add_elastic_energy(family, x, add); });
  return energy;
}
