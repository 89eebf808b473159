#include "scene/bad_input.h"
#include "scene/mesh.h"
#include "scene/obj_file.h"

namespace {

// A triangle of space, laid flat with its first edge along u.
std::array<Vec2, 3> laid_flat(const Vec3& x0, const Vec3& x1, const Vec3& x2) {
  const Vec3 edge = x1 - x0, side = x2 - x0;
  const double length = edge.norm();
  return {Vec2(0, 0), Vec2(length, 0),
          Vec2(edge.dot(side) / length, edge.cross(side).norm() / length)};
}

std::array<Vec2, 3> rest_shape(const ObjFile& file, const std::array<ObjCorner, 3>& corners) {
  const auto& [a, b, c] = corners;
  if (a.uv) return {file.uv[size_t(*a.uv)], file.uv[size_t(*b.uv)], file.uv[size_t(*c.uv)]};
  return laid_flat(file.positions[size_t(a.vertex)], file.positions[size_t(b.vertex)],
                   file.positions[size_t(c.vertex)]);
}

VecX stacked(const std::vector<Vec3>& positions) {
  VecX x(3 * Eigen::Index(positions.size()));
  for (size_t i = 0; i < positions.size(); ++i) x.segment<3>(3 * Eigen::Index(i)) = positions[i];
  return x;
}

}  // namespace

Mesh read_obj(const std::filesystem::path& path) {
  const ObjFile file = read_obj_file(path);
  if (file.faces.empty())
    throw BadInput(path.string() + ": no faces; a cloth needs v lines and triangles, f lines");
  Mesh mesh;
  mesh.x = stacked(file.positions);
  for (const ObjFace& face : file.faces) {
    const auto& [a, b, c] = face.corners;
    mesh.faces.push_back({a.vertex, b.vertex, c.vertex});
    mesh.rest.push_back(rest_shape(file, face.corners));
  }
  check(mesh, path);
  return mesh;
}

VecX read_obj_vertices(const std::filesystem::path& path) {
  return stacked(read_obj_file(path).positions);
}
