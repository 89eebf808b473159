#include "scene/memory.h"
#include "scene/mesh.h"
#include "text/bad_input.h"

namespace {

// The two triangles of the cell whose lower left vertex is v0, `row` vertices to a row.
std::array<Face, 2> cell_faces(int v0, int row, bool other_diagonal) {
  const int v1 = v0 + 1, v2 = v0 + row, v3 = v2 + 1;
  if (other_diagonal) return {{{v0, v1, v3}, {v0, v3, v2}}};
  return {{{v0, v1, v2}, {v3, v2, v1}}};
}

}  // namespace

Mesh make_grid(const Vec2& size, const std::array<int, 2>& cells, Diagonals diagonals) {
  if (const std::optional<std::string> reason = too_large(cells)) throw BadInput(*reason);
  const int nx = cells[0], ny = cells[1];
  const int row = nx + 1;
  const auto uv = [&](int vertex) {
    return Vec2(size.x() * (double(vertex % row) / nx), size.y() * (double(vertex / row) / ny));
  };

  Mesh mesh;
  mesh.grid = Grid{cells, diagonals};
  mesh.x.resize(3 * row * (ny + 1));
  for (int i = 0; i < mesh.vertices(); ++i)
    mesh.x.segment<3>(3 * i) = Vec3(uv(i).x(), 0, -uv(i).y());

  const size_t faces = 2 * size_t(nx) * size_t(ny);
  mesh.faces.reserve(faces);
  mesh.rest.reserve(faces);
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i) {
      const bool other_diagonal = diagonals == Diagonals::alternating && (i + j) % 2 == 1;
      for (const Face& f : cell_faces(j * row + i, row, other_diagonal)) {
        mesh.faces.push_back(f);
        mesh.rest.push_back({uv(f[0]), uv(f[1]), uv(f[2])});
      }
    }
  return mesh;
}
