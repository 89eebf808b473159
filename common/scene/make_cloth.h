// From geometry to physics: masses, pins and the elements that a scene needs.
#pragma once
#include "math/cloth.h"
#include "scene/mesh.h"

// What a scene names. An absent term costs nothing: no element, no array, no arithmetic.
struct Model {
  double density = 0.2;  // kg/m²
  std::vector<Pin> pins = {};
  std::optional<Term> stretch = {};  // N/m
  std::optional<Term> shear = {};
  std::optional<Vec3> gravity = {};  // m/s²
  std::optional<Term> bend = {};     // N·m; N/m for springs
  BendModel bend_model = BendModel::dihedral;
};

// A third of each triangle's mass goes to each of its corners: m_i = Σ ρ a/3.
Cloth make_cloth(const Mesh&, const Model&);

// The triangle of one face of the mesh, with the weights of its rest shape.
Triangle make_triangle(const Mesh&, size_t face);
