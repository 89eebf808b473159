// Eigen's decompositions and products of dense matrices, compiled once for all tests: every file that
// instantiates one compiles for seconds longer.
#pragma once
#include <initializer_list>

#include "math/types.h"

using MatX = Eigen::MatrixXd;

MatX product(std::initializer_list<MatX> factors);  // product({A, B, C}) is A B C

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

VecX solve(const MatX& A, const VecX& b);  // x of A x = b
MatX inverse(const MatX&);
MatX root(const MatX& A);  // an R with A = R Rᵀ, for a positive definite A
