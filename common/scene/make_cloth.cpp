#include "scene/make_cloth.h"

#include "scene/hinges.h"
#include "scene/spring_net.h"

Triangle make_triangle(const Mesh& mesh, size_t face) {
  const auto& [uv0, uv1, uv2] = mesh.rest[face];
  return make_triangle(mesh.faces[face], uv0, uv1, uv2);
}

namespace {

VecX vertex_masses(const Mesh& mesh, double density) {
  VecX mass = VecX::Zero(mesh.x.size());
  for (size_t face = 0; face < mesh.faces.size(); ++face) {
    const double share = density * make_triangle(mesh, face).area / 3;
    for (const int i : mesh.faces[face]) mass.segment<3>(3 * i).array() += share;
  }
  return mass;
}

// A pinned vertex has infinite mass: no force moves it.
VecX inverse_masses(const VecX& mass, const std::vector<Pin>& pins) {
  VecX inverse = mass.cwiseInverse();
  for (const Pin& pin : pins)
    if (pin.holds_all()) inverse.segment<3>(3 * pin.vertex).setZero();
  return inverse;
}

// The elements that the terms of a family act on.
void make_elements(const Mesh& mesh, Triangles& triangles) {
  triangles.elements.reserve(mesh.faces.size());
  for (size_t face = 0; face < mesh.faces.size(); ++face) {
    triangles.elements.push_back(make_triangle(mesh, face));
    triangles.elements.back().face = int(face);
  }
}
// The net is that of [spring]; without it, the net of a [spring] that gives k alone.
void make_elements(const Mesh& mesh, Springs& springs) {
  springs.elements = make_spring_net(mesh, springs.term<SpringTerm>().value_or(SpringTerm(1)));
}
void make_elements(const Mesh& mesh, Hinges& hinges) {
  hinges.elements = make_hinges(mesh);
}
void make_elements(const Mesh& mesh, QuadraticHinges& hinges) {
  hinges.elements = make_quadratic_hinges(mesh);
}
void make_elements(const Mesh& mesh, BendSprings& springs) {
  springs.elements = make_bend_springs(mesh);
}

}  // namespace

Cloth make_cloth(const Mesh& mesh, const Model& model) {
  Cloth cloth{model};
  cloth.mass = vertex_masses(mesh, model.density);
  cloth.inverse_mass = inverse_masses(cloth.mass, model.pins);
  cloth.pins = model.pins;
  cloth.gravity = model.gravity;
  cloth.grid = mesh.grid;
  for_each_family(cloth, [&](auto& family) {
    if (family.acts()) make_elements(mesh, family);
  });
  start_terms(cloth, mesh.x);
  return cloth;
}
