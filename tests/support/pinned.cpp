#include "support/pinned.h"

MatX filter_matrix(const Cloth& cloth) {
  MatX S = MatX::Identity(cloth.mass.size(), cloth.mass.size());
  for (const Pin& pin : cloth.pins) S.block<3, 3>(3 * pin.vertex, 3 * pin.vertex) = pin.S;
  return S;
}

MatX free_directions(const Cloth& cloth) {
  return range(filter_matrix(cloth));
}

VecX prescribed(const Cloth& cloth, const VecX& v) {
  VecX lacking = VecX::Zero(v.size());
  for (const Pin& pin : cloth.pins)
    lacking.segment<3>(3 * pin.vertex) = pin.velocity - v.segment<3>(3 * pin.vertex);
  return lacking - filter_matrix(cloth) * lacking;
}

VecX reduced_solution(const Cloth& cloth, const MatX& A, const VecX& b, const VecX& z) {
  const MatX Z = free_directions(cloth);
  return z + Z * solve(product({Z.transpose(), A, Z}), Z.transpose() * (b - A * z));
}

PinnedSheet::PinnedSheet(unsigned seed, Diagonals diagonals, const std::array<int, 2>& cells)
    : random(seed), mesh(make_grid({1, 1}, cells, diagonals)) {
  const Grid& grid = *mesh.grid;
  const int right = cells[0], top = cells[1];
  const auto pin = [&](int i, int j, const Mat3& S) {
    model.pins.emplace_back(grid.vertex(i, j), S, random.vector(3, 1));
  };
  pin(0, top, Mat3::Zero());
  pin(right, top, Mat3::Zero());
  pin(right - 1, top, Mat3::Zero());
  pin(1, 0, only(Vec3::UnitY()));
  pin(right, 1, only(random.direction()));
  pin(0, 1, all_but(Vec3::UnitX()));
  pin(2, 2, all_but(random.direction()));
  pin(3, 2, all_but(random.direction()));
  model.add(StretchTerm(1000, 0.5));
  model.add(ShearTerm(500, 0.2));
  model.gravity = Vec3(0, -9.81, 0);
  cloth = make_cloth(mesh, model);
  state = disturbed(mesh, 0.3 / right, random);
}

step04::System PinnedSheet::step(const Method& method) const {
  step04::System system(cloth, method);
  State end = state;
  step04::time_step(cloth, h, end, system);
  return system;
}
