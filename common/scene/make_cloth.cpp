#include "scene/make_cloth.h"

#include "scene/mesh_edges.h"

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

// A vertex of infinite mass: no force moves it.
VecX inverse_masses(const VecX& mass, const std::vector<Pin>& pins) {
  VecX inverse = mass.cwiseInverse();
  for (const Pin& pin : pins)
    if (pin.holds_all()) inverse.segment<3>(3 * pin.vertex).setZero();
  return inverse;
}

void add_bend(const Mesh& mesh, const Model& model, Cloth& cloth) {
  switch (model.bend_model) {
    case BendModel::dihedral:
    case BendModel::bridson:
      cloth.hinges = {make_hinges(mesh), model.bend, model.bend_model};
      break;
    case BendModel::quadratic:
      cloth.quadratic_hinges = {make_quadratic_hinges(mesh), model.bend};
      break;
    case BendModel::springs:
      cloth.springs = {make_bend_springs(mesh), model.bend};
  }
}

}  // namespace

Cloth make_cloth(const Mesh& mesh, const Model& model) {
  Cloth cloth;
  cloth.mass = vertex_masses(mesh, model.density);
  cloth.inverse_mass = inverse_masses(cloth.mass, model.pins);
  cloth.pins = model.pins;
  cloth.gravity = model.gravity;
  cloth.grid = mesh.grid;
  cloth.triangles.stretch = model.stretch;
  cloth.triangles.shear = model.shear;
  if (model.stretch || model.shear) {
    cloth.triangles.elements.reserve(mesh.faces.size());
    for (size_t face = 0; face < mesh.faces.size(); ++face)
      cloth.triangles.elements.push_back(make_triangle(mesh, face));
  }
  if (model.bend) add_bend(mesh, model, cloth);
  return cloth;
}
