// Geometric multigrid for grids, as a preconditioner: one V-cycle with A = L + Δ + Lᵀ.
//
//   s  = (Δ + L)⁻¹ r                   smooth: block Gauss–Seidel, forwards from zero
//   s += P A_c⁻¹ Pᵀ (r − A s)          correct on the grid of half as many cells
//   s += (Δ + Lᵀ)⁻¹ (r − A s)          smooth, backwards: that makes the cycle symmetric
//
// P interpolates along the edges of the coarse grid, A_c = Pᵀ A P (Galerkin), and A_c⁻¹ is the same
// cycle again, down to a grid that cannot be halved; its system is solved densely. Smoothing removes
// errors that change from vertex to vertex. The smooth error that remains changes from vertex to vertex on
// a coarse grid, and is removed there. If pins hold all fine vertices around a coarse vertex, its row of
// A_c is zero: the coarse vertex is pinned, too.
#pragma once
#include <Eigen/Cholesky>

#include "math/pinned_blocks.h"
#include "math/preconditioner.h"

// Where a fine vertex lies between coarse ones; the weights add up to one.
struct Parent {
  int vertex;
  double weight;
};

// The parents of every vertex of a grid in the one of half as many cells: itself, the two ends of the
// coarse edge that it halves, or in the middle of a coarse cell without a diagonal its four corners.
std::vector<std::vector<Parent>> coarse_parents(const Grid& fine);

class Multigrid : public Preconditioner {
 public:
  // Throws std::invalid_argument for a grid with an odd number of cells, or one whose halving ends at
  // too many vertices.
  Multigrid(const BlockMatrix& pattern, const std::vector<Pin>& pins, const Grid& grid);

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
    std::vector<std::vector<Parent>> parents;
    std::vector<Contribution> contributions;  // of all blocks, diagonal ones first
    std::vector<int> contribution_start;      // of each block
  };

  BlockMatrix map_to_coarse(const Grid& fine);
  static void coarsen(const Level& fine, BlockMatrix& coarse);

  void cycle(size_t level);
  void solve_densely(Level&) const;
  static void smooth_forwards(Level&);                              // s = (Δ + L)⁻¹ r
  static void restrict_residual(const Level& fine, Level& coarse);  // r_c = Pᵀ (r − A s)
  static void interpolate(const Level& coarse, Level& fine);        // s += P s_c
  static void smooth_backwards(Level&);  // s += (Δ + Lᵀ)⁻¹ (r − A s)

  std::vector<Level> levels;  // the finest first
  Eigen::MatrixXd dense;
  Eigen::LDLT<Eigen::MatrixXd> coarsest;  // LLT would allocate in every step
};
