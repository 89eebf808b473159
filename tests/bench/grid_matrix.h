// The matrix of a grid with equal diagonals as a table: 7 blocks, 21 columns, per vertex.
//
//   slot  0   1     2   3  4   5     6
//   j−i  −w  −w+1  −1   0  1  w−1    w       w = cells_x + 1 vertices in a row
//
// The slot tells where the neighbour is, so no column number is stored. Beyond the edge
// of the grid the blocks are zero. The price: the table fits no other mesh, and no
// element that reaches further.
#pragma once
#include <algorithm>
#include <stdexcept>
#include <vector>

#include "math/block_matrix.h"
#include "math/grid.h"

class GridMatrix {
 public:
  explicit GridMatrix(const Grid& grid)
      : offset({-grid.cells[0] - 1, -grid.cells[0], -1, 0, 1, grid.cells[0], grid.cells[0] + 1}),
        margin(grid.cells[0] + 1), rows(size_t(grid.vertices())),
        padded(VecX::Zero(3 * (grid.vertices() + 2 * margin))) {
    if (grid.diagonals != Diagonals::same)
      throw std::invalid_argument(
          "a table of 7 blocks fits equal diagonals only: with alternating ones a vertex has 4 or "
          "8 "
          "neighbours");
    for (Row& row : rows) row.setZero();
  }

  void copy(const BlockMatrix& A) {
    for (int i = 0; i < A.rows(); ++i) {
      block(i, i) = A.diagonal[size_t(i)];
      for (int s = A.row_start[size_t(i)]; s < A.row_start[size_t(i) + 1]; ++s) {
        const int j = A.column[size_t(s)];
        block(i, j) = A.upper[size_t(s)];
        block(j, i) = A.upper[size_t(s)].transpose();
      }
    }
  }

  // Ap = A p. A margin of zeros around p lets every row read 7 vertices.
  void multiply(const VecX& p, VecX& Ap) {
    Ap.resize(p.size());
    padded.segment(3 * margin, p.size()) = p;
    for (int i = 0; i < int(rows.size()); ++i) {
      Vec3 sum = Vec3::Zero();
      for (int s = 0; s < 7; ++s)
        sum += rows[size_t(i)].middleCols<3>(3 * s) *
               padded.segment<3>(3 * (i + margin + offset[size_t(s)]));
      Ap.segment<3>(3 * i) = sum;
    }
  }

  size_t bytes() const { return rows.size() * sizeof(Row); }

 private:
  using Row = Eigen::Matrix<double, 3, 21>;

  Eigen::Block<Row, 3, 3> block(int i, int j) {
    const auto slot = std::find(offset.begin(), offset.end(), j - i);
    if (slot == offset.end())
      throw std::invalid_argument("a table of 7 blocks has no place for these two vertices");
    return rows[size_t(i)].block<3, 3>(0, 3 * (slot - offset.begin()));
  }

  std::array<int, 7> offset;
  int margin;
  std::vector<Row> rows;
  VecX padded;
};
