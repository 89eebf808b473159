#include "support/decompositions.h"

#include <Eigen/Eigenvalues>

MatX product(std::initializer_list<MatX> factors) {
  MatX all = *factors.begin();
  for (auto factor = factors.begin() + 1; factor < factors.end(); ++factor) all = all * *factor;
  return all;
}

Eigenpairs eigenpairs(const MatX& A) {
  const Eigen::SelfAdjointEigenSolver<MatX> solver(A);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

VecX eigenvalues(const MatX& A) {
  return Eigen::SelfAdjointEigenSolver<MatX>(A, Eigen::EigenvaluesOnly).eigenvalues();
}

MatX range(const MatX& A) {
  const Eigenpairs pairs = eigenpairs(A);
  const double zero = 1e-9 * std::max(pairs.values.maxCoeff(), 1e-9);
  return pairs.vectors.rightCols((pairs.values.array() > zero).count());
}

VecX solve(const MatX& A, const VecX& b) {
  return A.partialPivLu().solve(b);
}

MatX inverse(const MatX& A) {
  return A.inverse();
}

MatX root(const MatX& A) {
  const Eigenpairs pairs = eigenpairs(A);
  return pairs.vectors * pairs.values.cwiseSqrt().asDiagonal();
}
