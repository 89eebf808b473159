// The cloth as geometry: faces, the rest shape of each, and where the vertices lie.
#pragma once
#include <filesystem>
#include <optional>
#include <vector>

#include "math/grid.h"
#include "math/types.h"

struct Mesh {
  std::vector<Face> faces;
  // m, (u, v) per face corner: a vertex on a seam has several.
  std::vector<std::array<Vec2, 3>> rest;
  VecX x;                           // m, as the grid is laid or the file says
  std::vector<bool> in_space = {};  // per face: does it rest as it lies in x? empty where none does
  std::optional<Grid> grid = {};    // of a mesh that make_grid made

  int vertices() const { return int(x.size()) / 3; }
  bool rests_flat(int face) const { return in_space.empty() || !in_space[face]; }
};

// A grid (math/grid.h) of cells_x × cells_y cells on size_x × size_y m. Its vertex (i, j) has
// (u, v) = (i size_x / cells_x, j size_y / cells_y) and lies at (u, 0, −v): horizontal, front up.
// Throws BadInput where the machine has not enough memory for it.
Mesh make_grid(const Vec2& size, const std::array<int, 2>& cells, Diagonals diagonals);

// An OBJ file. The rest shape of a face is its texture coordinates, in m, or where it has none the
// flat triangle itself, its first edge along u. Throws BadInput for a file without faces, faces
// that are not triangles, an index out of range, a number that is not finite, and what check()
// refuses.
Mesh read_obj(const std::filesystem::path&);

// Only the v lines of an OBJ file: start positions for a cloth with as many vertices.
VecX read_obj_vertices(const std::filesystem::path&);

// Is a rest triangle more than a line, beyond rounding?
bool has_area(const std::array<Vec2, 3>& uv);

// Throws BadInput, naming `source` and the place, where a face has no area at rest or names a
// vertex twice, an edge has more than two faces, or a vertex has no face and so no mass.
void check(const Mesh&, const std::filesystem::path& source);

// 17 significant digits; read_obj gives the same numbers, up to the last digit.
void write_obj(const std::filesystem::path&, const Mesh&, const VecX& x);
