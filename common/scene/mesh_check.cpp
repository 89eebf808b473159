#include <algorithm>

#include "scene/mesh.h"
#include "scene/mesh_edges.h"
#include "text/bad_input.h"

namespace {

// Area / (longest edge)²; a triangle with less is a line.
constexpr double smallest_area = 1e-12;

bool has_three_vertices(const Face& f) {
  return f[0] != f[1] && f[1] != f[2] && f[2] != f[0];
}

void check_face(const Mesh& mesh, size_t face, const std::string& source) {
  const Face& f = mesh.faces[face];
  const std::string name = source + ": face " + std::to_string(face) + " (vertices " +
                           std::to_string(f[0]) + ", " + std::to_string(f[1]) + ", " +
                           std::to_string(f[2]) + ", all counted from 0) ";
  if (!has_three_vertices(f)) throw BadInput(name + "must have three different vertices");
  if (!has_area(mesh.rest[face])) throw BadInput(name + "has no area at rest; take it out");
}

// A vertex without a face would have no mass.
void check_vertices(const Mesh& mesh, const std::string& source) {
  std::vector<bool> used(size_t(mesh.vertices()));
  for (const Face& f : mesh.faces)
    for (const int i : f) used[i] = true;
  const auto unused = std::find(used.begin(), used.end(), false);
  if (unused != used.end())
    throw BadInput(source + ": vertex " + std::to_string(unused - used.begin()) +
                   " (counted from 0) belongs to no face and so has no mass; take it out");
}

}  // namespace

bool has_area(const std::array<Vec2, 3>& uv) {
  const Vec2 a = uv[1] - uv[0], b = uv[2] - uv[0], c = uv[2] - uv[1];
  const double area = 0.5 * std::abs(a.x() * b.y() - a.y() * b.x());
  const double longest = std::max({a.squaredNorm(), b.squaredNorm(), c.squaredNorm()});
  return area > smallest_area * longest;  // false for 0 and for nan
}

void check(const Mesh& mesh, const std::filesystem::path& source) {
  for (size_t face = 0; face < mesh.faces.size(); ++face) check_face(mesh, face, source.string());
  find_edges(mesh.faces, source.string());
  check_vertices(mesh, source.string());
}
