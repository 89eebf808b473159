#include <tiny_obj_loader.h>

#include "scene/mesh.h"
#include "scene/plain_obj.h"
#include "text/bad_input.h"
#include "text/text_file.h"

namespace {

tinyobj::ObjReader read(const std::filesystem::path& path) {
  const std::string text = plain_obj(read_text(path), path);
  tinyobj::ObjReaderConfig config;
  config.triangulate = false;
  tinyobj::ObjReader reader;
  if (!reader.ParseFromString(text, "", config))
    throw BadInput(path.string() + ": " + reader.Error().substr(0, reader.Error().find('\n')));
  return reader;
}

VecX positions(const tinyobj::attrib_t& file) {
  return Eigen::Map<const VecX>(file.vertices.data(), Eigen::Index(file.vertices.size()));
}

// Either all corners of a face have one or none (plain_obj.h).
bool has_uv(const tinyobj::index_t& corner) {
  return corner.texcoord_index >= 0;
}

// A triangle of space, laid flat with its first edge along u.
std::array<Vec2, 3> laid_flat(const Vec3& x0, const Vec3& x1, const Vec3& x2) {
  const Vec3 edge = x1 - x0, side = x2 - x0;
  const double length = edge.norm();
  return {Vec2(0, 0), Vec2(length, 0),
          Vec2(edge.dot(side) / length, edge.cross(side).norm() / length)};
}

std::array<Vec2, 3> rest_shape(const tinyobj::attrib_t& file, const tinyobj::index_t* corner) {
  const auto uv = [&](int i) -> Vec2 {
    return Eigen::Map<const Vec2>(file.texcoords.data() + 2 * corner[i].texcoord_index);
  };
  const auto x = [&](int i) -> Vec3 {
    return Eigen::Map<const Vec3>(file.vertices.data() + 3 * corner[i].vertex_index);
  };
  if (has_uv(*corner)) return {uv(0), uv(1), uv(2)};
  return laid_flat(x(0), x(1), x(2));
}

}  // namespace

Mesh read_obj(const std::filesystem::path& path) {
  const tinyobj::ObjReader reader = read(path);
  Mesh mesh;
  mesh.x = positions(reader.GetAttrib());
  for (const tinyobj::shape_t& shape : reader.GetShapes())
    for (size_t c = 0; c < shape.mesh.indices.size(); c += 3) {
      const tinyobj::index_t* corner = &shape.mesh.indices[c];
      mesh.faces.push_back(
          {corner[0].vertex_index, corner[1].vertex_index, corner[2].vertex_index});
      mesh.rest.push_back(rest_shape(reader.GetAttrib(), corner));
      mesh.in_space.push_back(!has_uv(*corner));
    }
  if (mesh.faces.empty())
    throw BadInput(path.string() + ": no faces; a cloth needs v lines and triangles, f lines");
  check(mesh, path);
  return mesh;
}

VecX read_obj_vertices(const std::filesystem::path& path) {
  return positions(read(path).GetAttrib());
}
