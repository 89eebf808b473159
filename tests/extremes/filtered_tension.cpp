#include "extremes/filtered_tension.h"

#include <Eigen/Eigenvalues>

namespace extremes {
namespace {

// V f(λ) Vᵀ
template <class Matrix, class F>
Matrix on_eigenvalues(const Matrix& A, const F& f) {
  const Eigen::SelfAdjointEigenSolver<Matrix> pairs(A);
  const Matrix& V = pairs.eigenvectors();
  return V * pairs.eigenvalues().unaryExpr(f).asDiagonal() * V.transpose();
}

template <class Matrix>
Matrix clamped(const Matrix& A) {
  return on_eigenvalues(A, [](double value) { return std::max(value, 0.0); });
}
template <class Matrix>
Matrix reflected(const Matrix& A) {
  return on_eigenvalues(A, [](double value) { return std::abs(value); });
}

}  // namespace

Square<3> without_negative(const Square<3>& A) {
  return clamped(A);
}
Square<6> without_negative(const Square<6>& A) {
  return clamped(A);
}
Square<3> absolute(const Square<3>& A) {
  return reflected(A);
}
Square<6> absolute(const Square<6>& A) {
  return reflected(A);
}

}  // namespace extremes
