#include "scene/memory.h"

#include <cmath>
#include <limits>

#include "math/cloth.h"
#include "scene/mesh.h"
#include "text/machine.h"
#include "text/text.h"

namespace {

std::string megabytes(double bytes) {
  return text("%.0f MB", std::ceil(bytes / 1e6));
}

}  // namespace

// Per vertex: its place in the mesh, x and v of the start, mass and inverse mass. Per cell two
// faces, each with its rest shape and its element. In double: 2³¹ × 2³¹ cells overflow any integer.
double bytes_of_grid(const std::array<int, 2>& cells) {
  constexpr size_t per_vertex = 5 * sizeof(Vec3);
  constexpr size_t per_face = sizeof(Face) + sizeof(Mesh::rest[0]) + sizeof(Triangle);
  const double nx = cells[0], ny = cells[1];
  return per_vertex * (nx + 1) * (ny + 1) + 2 * per_face * nx * ny;
}

std::optional<std::string> too_large(const std::array<int, 2>& cells) {
  const double nx = cells[0], ny = cells[1], bytes = bytes_of_grid(cells);
  const std::string grid = text("%.0f x %.0f cells", nx, ny);
  if (bytes > physical_memory())
    return grid + " need at least " + megabytes(bytes) + " of memory, this machine has " +
           megabytes(physical_memory()) + "; take fewer cells";
  // Coordinate 3 i of vertex i is an int.
  const double most = std::numeric_limits<int>::max() / 3;
  if ((nx + 1) * (ny + 1) > most)
    return grid + text(" make more than the %.0f vertices that can be numbered; take fewer", most);
  return {};
}
