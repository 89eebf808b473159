// Direct solvers for A Δv = b, each a thin wrapper around a library. Pinned vertices (inverse mass
// zero) leave the system before it is factorised; their Δv is zero.
#pragma once
#include <Eigen/SparseCore>
#include <memory>
#include <string>
#include <vector>

#include "math/block_matrix.h"

// A BlockMatrix without its pinned vertices as Eigen's compressed columns, upper triangle. The pattern
// is laid out once; `copy` only moves numbers.
class FreeMatrix {
 public:
  FreeMatrix(const BlockMatrix& pattern, const VecX& inverse_mass);

  void copy(const BlockMatrix& A);
  VecX restrict(const VecX& b) const;              // without the pinned vertices
  void extend(const VecX& free, VecX& all) const;  // with zeros for them

  Eigen::SparseMatrix<double> values;

 private:
  using Run = std::array<int, 3>;  // where each column of a block begins, or −1
  Run place(const Eigen::SparseMatrix<double>&, int i, int j) const;
  void copy(const Mat3& block, const Run& run);

  std::vector<int> number;  // of a vertex among the free ones, −1 if pinned
  std::vector<Run> diagonal, upper;
};

class DirectSolver {
 public:
  virtual ~DirectSolver() = default;

  // Solves A Δv = b. False if A is not positive definite: Δv is then the result of LDLᵀ without
  // pivoting or of the inverse, or zero where LDLᵀ stops. False, too, with Δv zero, where A is singular to
  // rounding and the Δv of the solver not finite.
  bool solve(const BlockMatrix& A, const VecX& b, VecX& dv) {
    const bool definite = factorise_and_solve(A, b, dv);
    if (dv.allFinite()) return definite;
    dv.setZero();
    return false;
  }

 private:
  virtual bool factorise_and_solve(const BlockMatrix& A, const VecX& b, VecX& dv) = 0;
};

// "ldlt": sparse LDLᵀ of Eigen, its ordering found once. "inverse": the dense inverse, a teaching
// baseline. "cholmod": the supernodal Cholesky of SuiteSparse, where it was found when building.
// Throws std::invalid_argument for another name, a solver that is not built in, or a dense matrix
// beyond the machine's memory (with the bytes it would need).
std::unique_ptr<DirectSolver> make_direct_solver(const std::string& name,
                                                 const BlockMatrix& pattern,
                                                 const VecX& inverse_mass);
