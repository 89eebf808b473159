// From geometry to physics: masses, pins and the elements that a scene needs.
#pragma once
#include "math/cloth.h"
#include "scene/mesh.h"

// The terms that a scene names, still without elements. An absent term costs nothing: no element,
// no array, no arithmetic.
struct Model : Families {
  double density = 0.2;  // kg/m²
  std::vector<Pin> pins;
  std::optional<Vec3> gravity;  // m/s²

  template <class T>
  Model& add(const T& named) {
    term<T>() = named;
    return *this;
  }
};

// A third of each triangle's mass goes to each of its corners: m_i = Σ ρ a/3.
Cloth make_cloth(const Mesh&, const Model&);

// The triangle of one face of the mesh, with the weights of its rest shape.
Triangle make_triangle(const Mesh&, size_t face);
