// A small cloth without a scene, for the checks of whole steps.
#pragma once
#include "math/pattern.h"

// A flat square metre of cells × cells squares, two triangles each, 1 kg per vertex.
struct SmallCloth {
  explicit SmallCloth(int cells) {
    const int side = cells + 1;
    cloth.mass = cloth.inverse_mass = VecX::Ones(3 * side * side);
    x.resize(3 * side * side);
    const auto uv = [&](int i) { return Vec2(Vec2(i % side, i / side) / cells); };
    for (int i = 0; i < side * side; ++i) x.segment<3>(3 * i) << uv(i), 0;
    for (int j = 0; j < cells; ++j)
      for (int i = 0; i < cells; ++i) {
        const int a = j * side + i, b = a + 1, c = a + side, d = c + 1;
        for (const Face& face : {Face{a, b, d}, Face{d, c, a}})
          cloth.triangles.elements.push_back(
              make_triangle(face, uv(face[0]), uv(face[1]), uv(face[2])));
      }
  }
  void hold(const Pin& pin) {
    cloth.pins.push_back(pin);
    if (pin.holds_all()) cloth.inverse_mass.segment<3>(3 * pin.vertex).setZero();
  }

  Cloth cloth;
  VecX x;
};

// The whole of a BlockMatrix, of which one half is stored.
inline Eigen::MatrixXd whole(const BlockMatrix& A) {
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(3 * A.rows(), 3 * A.rows());
  for (int i = 0; i < A.rows(); ++i) {
    all.block<3, 3>(3 * i, 3 * i) = A.diagonal[i];
    for (int s = A.row_start[i]; s < A.row_start[i + 1]; ++s) {
      all.block<3, 3>(3 * i, 3 * A.column[s]) = A.upper[s];
      all.block<3, 3>(3 * A.column[s], 3 * i) = A.upper[s].transpose();
    }
  }
  return all;
}

// Random numbers in every block, negative definite as K and D are: −B Bᵀ on each pair of vertices.
template <class Random>
void fill_negative(BlockMatrix& A, Random& random) {
  A.set_zero();
  for (int i = 0; i < A.rows(); ++i)
    for (int s = A.row_start[i]; s < A.row_start[i + 1]; ++s) {
      const VecX b = random.vector(6, 1);
      const Vec3 b_i = b.head<3>(), b_j = b.tail<3>();
      A.diagonal[i] -= b_i * b_i.transpose();
      A.diagonal[A.column[s]] -= b_j * b_j.transpose();
      A.upper[s] -= b_i * b_j.transpose();
    }
}
