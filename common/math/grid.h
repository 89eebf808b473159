// The shape of a cloth that is a grid of cells. Vertex number j (cells_x + 1) + i is the i-th from the
// left in row j from below.
#pragma once
#include <array>

//   2---3     same: the triangles (0, 1, 2) and (3, 2, 1) in every cell
//   | \ |     alternating: every other cell has (0, 1, 3) and (0, 3, 2)
//   0---1
enum class Diagonals { same, alternating };

struct Grid {
  std::array<int, 2> cells;
  Diagonals diagonals;

  int vertices() const { return (cells[0] + 1) * (cells[1] + 1); }
  int vertex(int i, int j) const { return j * (cells[0] + 1) + i; }

  bool can_be_halved() const { return cells[0] % 2 == 0 && cells[1] % 2 == 0; }
  Grid half() const { return {{cells[0] / 2, cells[1] / 2}, diagonals}; }  // of half as many cells
};
