// The energy of one triangle from positions and (u, v) alone, without our weights and gradients. Eigen's
// automatic differentiation finds the force.
#pragma once
#include "math/types.h"
// This header of Eigen needs Eigen/Dense before it.
#include <unsupported/Eigen/AutoDiff>

using Nine = Eigen::AutoDiffScalar<Eigen::Matrix<double, 9, 1>>;  // a number and its slope in x

//   E = a/2 ( k (|w_u| − b_u)² + k (|w_v| − b_v)² + k_shear (w_u·w_v)² ),   [w_u w_v] = Ds Dm⁻¹
inline Nine energy_from_scratch(const std::array<Vec2, 3>& rest, const std::array<Vec3, 3>& at,
                                const std::array<double, 2>& b, double k, double k_shear) {
  const double u1 = rest[1].x() - rest[0].x(), v1 = rest[1].y() - rest[0].y();
  const double u2 = rest[2].x() - rest[0].x(), v2 = rest[2].y() - rest[0].y();
  const double det = u1 * v2 - u2 * v1;
  Nine uu(0), vv(0), uv(0);
  for (int axis = 0; axis < 3; ++axis) {
    const Nine x0(at[0][axis], 9, axis), x1(at[1][axis], 9, 3 + axis), x2(at[2][axis], 9, 6 + axis);
    const Nine d1 = x1 - x0, d2 = x2 - x0;
    const Nine wu = (d1 * v2 - d2 * v1) / det;
    const Nine wv = (d2 * u1 - d1 * u2) / det;
    uu += wu * wu;
    vv += wv * wv;
    uv += wu * wv;
  }
  const Nine Cu = sqrt(uu) - b[0], Cv = sqrt(vv) - b[1];
  return std::abs(det) / 4 * (k * Cu * Cu + k * Cv * Cv + k_shear * uv * uv);
}
