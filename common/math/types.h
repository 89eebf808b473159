// The few types that everything else is written in.
#pragma once
#include <array>
#include <Eigen/Dense>

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;
using VecX = Eigen::VectorXd;  // three numbers per vertex; vertex i at segment<3>(3 * i)

template <int M>
using Vecs = std::array<Vec3, M>;  // M vectors of space
template <int M>
using Mats = std::array<std::array<Mat3, M>, M>;  // M × M blocks of a matrix on them

template <int M>
using Square = Eigen::Matrix<double, M, M>;  // M × M numbers

template <int M>
Vecs<M> zero_vectors() {
  Vecs<M> zero;
  zero.fill(Vec3::Zero());
  return zero;
}
template <int M>
Mats<M> zero_matrices() {
  Mats<M> zero;
  for (auto& row : zero) row.fill(Mat3::Zero());
  return zero;
}

using Face = std::array<int, 3>;  // the vertices of a triangle, counter-clockwise from the front
