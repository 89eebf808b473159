// The error that a V-cycle removes last. A solver that only repeats the cycle, Δv += P⁻¹ (b − A Δv),
// multiplies its error e by I − P⁻¹ A. Applied again and again, that leaves the slowest mode. Pins hold all
// of their vertices here.
#pragma once
#include <random>

#include "math/cloth.h"
#include "math/preconditioner.h"
#include "scene/mesh.h"

// √(eᵀ A e), the norm in which every cycle makes an error smaller.
inline double energy_norm(const BlockMatrix& A, const VecX& e) {
  return std::sqrt(A.form(e));
}

// eᵀ A e / eᵀ M e: how many times the mass A is along e. 1 where nothing resists.
inline double stiffness(const Cloth& cloth, const BlockMatrix& A, const VecX& e) {
  return A.form(e) / e.cwiseAbs2().dot(cloth.mass);
}

// Zero where a pin holds.
inline VecX free_part(const Cloth& cloth, const VecX& e) {
  return (cloth.inverse_mass.array() > 0).select(e, 0);
}

// e − P⁻¹ A e.
inline VecX after_cycle(const Cloth& cloth, const BlockMatrix& A, Preconditioner& P,
                        const VecX& e) {
  VecX r, s;
  A.multiply(e, r);
  r = free_part(cloth, r);
  P.apply(r, s);
  return e - s;
}

struct SlowMode {
  VecX e;       // of energy norm 1
  double left;  // of this norm after one more cycle
};

// From a random error. A and P are those of `cloth`.
inline SlowMode slowest_mode(const Cloth& cloth, const BlockMatrix& A, Preconditioner& P,
                             int cycles) {
  std::mt19937 random(1);
  VecX e(cloth.mass.size());
  for (double& entry : e) entry = double(random()) / double(random.max()) - 0.5;
  e = free_part(cloth, e);
  double left = 1;
  for (int n = 0; n < cycles; ++n) {
    e = after_cycle(cloth, A, P, e / energy_norm(A, e));
    left = energy_norm(A, e);
  }
  return {e / left, left};
}

// One sweep of block Gauss–Seidel, from the first vertex to the last: each moves to where it costs least
// energy while all others stand still.
inline VecX after_sweep(const Cloth& cloth, const BlockMatrix& A, VecX e) {
  VecX r;
  A.multiply(e, r);
  for (int i = 0; i < A.rows(); ++i) {
    if (cloth.inverse_mass[3 * i] == 0) continue;
    const Vec3 move = -(inverse_of(A.diagonal[i]) * r.segment<3>(3 * i));
    e.segment<3>(3 * i) += move;
    for (int k = A.row_start[i]; k < A.row_start[i + 1]; ++k)
      r.segment<3>(3 * A.column[k]) += A.upper[k].transpose() * move;
  }
  return e;
}

// The vertex normals of a surface, weighted by area.
inline VecX normals(const Mesh& mesh, const VecX& x) {
  VecX sum = VecX::Zero(x.size());
  for (const auto& [i, j, k] : mesh.faces) {
    const Vec3 x_i = x.segment<3>(3 * i);
    const Vec3 n = (x.segment<3>(3 * j) - x_i).cross(x.segment<3>(3 * k) - x_i);
    for (const int vertex : {i, j, k}) sum.segment<3>(3 * vertex) += n;
  }
  for (int i = 0; i < mesh.vertices(); ++i) sum.segment<3>(3 * i).normalize();
  return sum;
}

// The share of |e|² that lies along the normals of x.
inline double share_along_normals(const Mesh& mesh, const VecX& x, const VecX& e) {
  const VecX n = normals(mesh, x);
  double sum = 0;
  for (int i = 0; i < mesh.vertices(); ++i)
    sum += std::pow(n.segment<3>(3 * i).dot(e.segment<3>(3 * i)), 2);
  return sum / e.squaredNorm();
}

// nᵀ A_ii n / m_i of a vertex that moves alone along its normal: the mean, weighted by |e_i|².
inline double stiffness_alone(const Cloth& cloth, const Mesh& mesh, const VecX& x,
                              const BlockMatrix& A, const VecX& e) {
  const VecX n = normals(mesh, x);
  double sum = 0;
  for (int i = 0; i < mesh.vertices(); ++i) {
    const Vec3 n_i = n.segment<3>(3 * i);
    sum += e.segment<3>(3 * i).squaredNorm() * n_i.dot(A.diagonal[i] * n_i) / cloth.mass[3 * i];
  }
  return sum / e.squaredNorm();
}
