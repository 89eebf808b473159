// The table of a grid stores the same matrix as the block matrix.
#include "bench/grid_matrix.h"

#include <gtest/gtest.h>

#include "math/pattern.h"
#include "scene/make_cloth.h"
#include "support/poses.h"

namespace grid_matrix_test {

BlockMatrix random_matrix(const Mesh& mesh) {
  Model model;
  model.add(StretchTerm(1));
  BlockMatrix A = make_block_matrix(make_cloth(mesh, model));
  Random random(4);
  for (Mat3& B : A.diagonal) {
    B.reshaped() = random.vector(9, 1);
    B = (B + B.transpose()).eval();
  }
  for (Mat3& B : A.upper) B.reshaped() = random.vector(9, 1);
  return A;
}

TEST(GridMatrix, MultipliesAsTheMatrixOfBlocks) {
  for (const std::array<int, 2> cells : {std::array{1, 1}, {1, 5}, {5, 1}, {2, 2}, {7, 4}}) {
    const Mesh mesh = make_grid({1, 1}, cells, Diagonals::same);
    const BlockMatrix A = random_matrix(mesh);
    GridMatrix table(*mesh.grid);
    table.copy(A);
    Random random(7);
    const VecX p = random.vector(int(mesh.x.size()), 1);
    VecX expected, Ap;
    A.multiply(p, expected);
    for (int again = 0; again < 2; ++again) {
      table.multiply(p, Ap);
      EXPECT_LT((Ap - expected).norm(), 1e-14 * expected.norm()) << cells[0] << " x " << cells[1];
    }
  }
}

TEST(GridMatrix, RefusesAlternatingDiagonals) {
  EXPECT_THROW(GridMatrix({{4, 4}, Diagonals::alternating}), std::invalid_argument);
}

// Bending couples two vertices across an edge. The 7 blocks have no place for such a pair.
TEST(GridMatrix, RefusesNeighboursBeyondTheTable) {
  const Grid grid{{4, 4}, Diagonals::same};
  const BlockMatrix A =
      make_block_matrix(grid.vertices(), {{grid.vertex(0, 0), grid.vertex(1, 1)}});
  GridMatrix table(grid);
  EXPECT_THROW(table.copy(A), std::invalid_argument);
}

TEST(GridMatrix, HoldsSevenBlocksAVertex) {
  EXPECT_EQ(GridMatrix({{4, 3}, Diagonals::same}).bytes(), 20u * 7 * 9 * sizeof(double));
}

}  // namespace grid_matrix_test
