// The cloth as the time steps see it: masses, pins, gravity, and families of elements. Whatever a
// scene does not name is empty here.
#pragma once
#include <optional>

#include "math/grid.h"
#include "math/hinge.h"
#include "math/pin.h"
#include "math/quadratic_bend.h"
#include "math/spring.h"
#include "math/triangle.h"

struct Cloth {
  VecX mass;                    // kg, one entry per coordinate
  VecX inverse_mass;            // 1/kg, zero where a pin holds all of the vertex
  std::vector<Pin> pins;        // at most one to a vertex
  std::optional<Vec3> gravity;  // m/s²

  Triangles triangles;
  Springs springs;
  Hinges hinges;
  QuadraticHinges quadratic_hinges;
  std::optional<Grid> grid;  // of a cloth that is one

  int vertices() const { return int(mass.size()) / 3; }
};

template <class Act>
void for_each_family(const Cloth& cloth, const Act& act) {
  act(cloth.triangles);
  act(cloth.springs);
  act(cloth.hinges);
  act(cloth.quadratic_hinges);
}

// Does any term of the cloth cost energy?
inline bool damped(const Cloth& cloth) {
  for (const auto& term : {cloth.triangles.stretch, cloth.triangles.shear, cloth.springs.spring,
                           cloth.hinges.bend, cloth.quadratic_hinges.bend})
    if (term && term->kd > 0) return true;
  return false;
}

struct State {
  VecX x;  // m
  VecX v;  // m/s
};
