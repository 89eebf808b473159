// A grid that is folded on a straight line, and what the fold does to the lengths of its edges.
#pragma once
#include <algorithm>
#include <vector>

#include "scene/mesh.h"

using Edge = std::array<int, 2>;  // two vertices, the lower number first

inline std::vector<Edge> edges(const Mesh& mesh) {
  std::vector<Edge> all;
  for (const Face& f : mesh.faces)
    for (int c = 0; c < 3; ++c) {
      const auto [low, high] = std::minmax(f[c], f[(c + 1) % 3]);
      all.push_back({low, high});
    }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

struct FoldLine {
  Vec2 through;      // m, a point of the line in (u, v)
  double direction;  // radians from u
};

struct ChangedEdge {
  Edge edge;
  double change;  // of the length, relative to that at rest
};

// The edges of a flat mesh that change their length where one side of the line is turned by 1 rad.
inline std::vector<ChangedEdge> changed_by_fold(const Mesh& mesh, const FoldLine& line) {
  const Vec3 p(line.through.x(), 0, -line.through.y());
  const Vec3 along(std::cos(line.direction), 0, -std::sin(line.direction));
  const Vec3 aside = Vec3::UnitY().cross(along);
  VecX x = mesh.x;
  for (int i = 0; i < mesh.vertices(); ++i) {
    const Vec3 from_line = x.segment<3>(3 * i) - p;
    if (from_line.dot(aside) > 1e-9)
      x.segment<3>(3 * i) = p + Eigen::AngleAxisd(1, along) * from_line;
  }
  std::vector<ChangedEdge> changed;
  for (const Edge& edge : edges(mesh)) {
    const auto length = [&, i = edge[0], j = edge[1]](const VecX& at) {
      return (at.segment<3>(3 * i) - at.segment<3>(3 * j)).norm();
    };
    const double change = length(x) / length(mesh.x) - 1;
    if (std::abs(change) > 1e-12) changed.push_back({edge, change});
  }
  return changed;
}
