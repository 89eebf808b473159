// Eigen's decompositions of dense matrices, compiled once for all tests: every file that
// instantiates one compiles for seconds longer.
#pragma once
#include "math/types.h"

using MatX = Eigen::MatrixXd;

// Of a symmetric matrix; eigenvalues ascend, column j of `vectors` belongs to number j.
struct Eigenpairs {
  VecX values;
  MatX vectors;
};
Eigenpairs eigenpairs(const MatX&);
VecX eigenvalues(const MatX&);

// The eigenvectors of a symmetric matrix to eigenvalues other than zero: an
// orthonormal basis of its range.
MatX range(const MatX&);

VecX solve(const MatX& A, const VecX& b);  // x of A x = b, for a symmetric A
MatX inverse(const MatX&);
MatX cholesky(const MatX& A);          // the lower L of A = L Lᵀ, for a positive definite A
MatX orthonormal(const MatX& square);  // the Q of Q R
