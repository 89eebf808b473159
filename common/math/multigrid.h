// Multigrid for any mesh, as a preconditioner: one V-cycle with A = L + Λ + Lᵀ.
//
//   s  = (Λ + L)⁻¹ r                   smooth: block Gauss–Seidel, forwards from zero
//   s += Q A_c⁻¹ Qᵀ (r − A s)          correct on a coarser level
//   s += (Λ + Lᵀ)⁻¹ (r − A s)          smooth, backwards: that makes the cycle symmetric
//
// Q interpolates from the vertices of the coarse level (math/parents.h): from the grid of half as many cells
// while a grid can be halved, else from aggregates. Its weights are numbers that do not change. A_c = Qᵀ A Q
// (Galerkin), and A_c⁻¹ is the same cycle again, down to a level whose system is solved densely. Smoothing
// removes errors that change from vertex to vertex. The smooth error that remains changes from vertex to
// vertex on a coarse level, and is removed there. If pins hold all fine vertices around a coarse vertex, its
// row of A_c is zero: the coarse vertex is pinned, too.
#pragma once
#include <Eigen/Cholesky>

#include "math/parents.h"
#include "math/pinned_blocks.h"
#include "math/preconditioner.h"

class Multigrid : public Preconditioner {
 public:
  // `grid` is the grid that the vertices are, if they are one.
  Multigrid(const BlockMatrix& pattern, const std::vector<Pin>& pins, std::optional<Grid> grid);

  void set(const BlockMatrix& A) override;
  void apply(const VecX& r, VecX& s) override;

  size_t bytes() const;  // of matrices and maps

 private:
  // A block of a level in the next coarser one: A_c[block] += weight B or its transpose.
  struct Contribution {
    int block;  // a diagonal one, or rows + an upper one
    bool transposed;
    double weight;
  };
  struct Level {
    Level(const BlockMatrix& pattern, const std::vector<Pin>& pins);

    BlockMatrix A;  // S A S + I − S
    PinnedBlocks pinned;
    std::vector<Mat3> inverse;  // of the diagonal blocks
    VecX r, s, t;
    Parents parents;
    std::vector<Contribution> contributions;  // of all blocks, diagonal ones first
    std::vector<int> contribution_start;      // of each block
  };

  static BlockMatrix map_to_coarse(Level& fine);
  static void coarsen(const Level& fine, BlockMatrix& coarse);

  void cycle(size_t level);
  void solve_densely(Level&) const;
  static void smooth_forwards(Level&);                              // s = (Λ + L)⁻¹ r
  static void restrict_residual(const Level& fine, Level& coarse);  // r_c = Qᵀ (r − A s)
  static void interpolate(const Level& coarse, Level& fine);        // s += Q s_c
  static void smooth_backwards(Level&);  // s += (Λ + Lᵀ)⁻¹ (r − A s)

  std::vector<Level> levels;  // the finest first
  Eigen::MatrixXd dense;
  Eigen::LDLT<Eigen::MatrixXd> coarsest;  // LLT would allocate in every step
};
