// The equilibrium of a cloth in given unknowns: the minimum of its energy, by Newton's method with
// the forces and derivatives of step 5.
#pragma once
#include <Eigen/SparseCore>
#include <memory>

#include "math/block_matrix.h"
#include "math/cloth.h"

namespace step05 {
struct System;
}

using Sparse = Eigen::SparseMatrix<double>;

Sparse sparse(const BlockMatrix&);

// x = start + P q: a column of P says which coordinates an unknown moves.
Sparse freedom(Eigen::Index coordinates, const std::vector<std::vector<int>>& unknowns);

// Forces and K̂ = −K at a state at rest, with all of ∂²C/∂x².
class Statics {
 public:
  explicit Statics(const Cloth&);
  ~Statics();

  void evaluate(const VecX& x);
  VecX f;
  Sparse K;

 private:
  const Cloth& cloth_;
  std::unique_ptr<step05::System> system_;
};

// If K̂ is not definite, a multiple of I is added. A step that raises the energy is halved. The
// iteration ends with a step of less than a billionth of a metre.
VecX equilibrium(const Cloth&, const Sparse& P, VecX x);
