#include "math/incomplete_cholesky.h"

#include <Eigen/Cholesky>

IncompleteCholesky::IncompleteCholesky(const BlockMatrix& pattern, const std::vector<Pin>& pins)
    : pinned(pattern, pins), U(pattern), inverse(pattern.diagonal) {
  for (int k = 0; k < U.rows(); ++k)
    for (int a = U.row_start[k]; a < U.row_start[k + 1]; ++a)
      for (int b = a + 1; b < U.row_start[k + 1]; ++b) {
        const int i = U.column[a], slot = U.slot(i, U.column[b]);
        const bool there = slot < U.row_start[i + 1] && U.column[slot] == U.column[b];
        targets.push_back(there ? slot : -1);
      }
}

void IncompleteCholesky::set(const BlockMatrix& A) {
  constexpr double most = 1e3;  // by then U hardly matters beside the diagonal
  for (shift = 0; shift < most; shift = std::max(2 * shift, 1e-3)) {
    U.diagonal = A.diagonal;
    U.upper = A.upper;
    for (Mat3& block : U.diagonal) block *= 1 + shift;
    pinned.project(U);
    pinned.make_regular(U);
    if (factorise()) return;
  }
  // A is far from definite. With P = I conjugate gradients detect that themselves.
  for (Mat3& block : U.upper) block.setZero();
  for (Mat3& block : inverse) block.setIdentity();
}

bool IncompleteCholesky::factorise() {
  auto target = targets.begin();
  for (int k = 0; k < U.rows(); ++k) {
    const Eigen::LLT<Mat3> cholesky(U.diagonal[k]);
    if (cholesky.info() != Eigen::Success) return false;
    inverse[k] = cholesky.solve(Mat3::Identity());
    for (int a = U.row_start[k]; a < U.row_start[k + 1]; ++a) {
      const int i = U.column[a];
      const Mat3 W = inverse[k] * U.upper[a];
      U.diagonal[i] -= U.upper[a].transpose() * W;
      for (int b = a + 1; b < U.row_start[k + 1]; ++b, ++target)
        if (*target >= 0) U.upper[*target] -= W.transpose() * U.upper[b];
    }
  }
  return true;
}

// (Λ + U)ᵀ t = r forwards, (Λ + U) s = Λ t backwards; t is kept in s.
void IncompleteCholesky::apply(const VecX& r, VecX& s) {
  s = r;
  for (int k = 0; k < U.rows(); ++k) {
    const Vec3 t_k = inverse[k] * s.segment<3>(3 * k);
    s.segment<3>(3 * k) = t_k;
    for (int a = U.row_start[k]; a < U.row_start[k + 1]; ++a)
      s.segment<3>(3 * U.column[a]) -= U.upper[a].transpose() * t_k;
  }
  for (int k = U.rows() - 1; k >= 0; --k) {
    Vec3 sum = Vec3::Zero();
    for (int a = U.row_start[k]; a < U.row_start[k + 1]; ++a)
      sum += U.upper[a] * s.segment<3>(3 * U.column[a]);
    s.segment<3>(3 * k) -= inverse[k] * sum;
  }
}
