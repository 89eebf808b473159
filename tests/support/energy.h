// Cloths without a scene, their forces as step 1 computes them, and the energy of one family.
#pragma once
#include "math/energy.h"
#include "step01_explicit/time_step.h"

// E = Σ k/2 C² over the conditions of one family.
template <class Family>
double energy(const Family& family, const VecX& x) {
  double E = 0;
  add_elastic_energy(family, family.elements, x, E);
  return E;
}

inline VecX forces(const Cloth& cloth, const VecX& x) {
  step01::System system(cloth);
  step01::forces(cloth, {x, VecX::Zero(x.size())}, system);
  return system.f;
}

// Vertices of 1 kg, without elements.
inline Cloth bare_cloth(int vertices) {
  Cloth cloth;
  cloth.mass = cloth.inverse_mass = VecX::Ones(3 * vertices);
  return cloth;
}

inline Cloth one_triangle(const Triangle& t, double k_stretch, double k_shear) {
  Cloth cloth = bare_cloth(3);
  cloth.triangles.elements = {t};
  if (k_stretch > 0) cloth.term<StretchTerm>() = StretchTerm(k_stretch);
  if (k_shear > 0) cloth.term<ShearTerm>() = ShearTerm(k_shear);
  return cloth;
}

inline Cloth one_spring(const Spring& s, double k) {
  Cloth cloth = bare_cloth(2);
  cloth.springs.elements = {s};
  cloth.term<SpringTerm>() = SpringTerm(k);
  return cloth;
}
