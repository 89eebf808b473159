#include "scene/mesh_edges.h"

#include <algorithm>
#include <tuple>

#include "text/bad_input.h"

namespace {

// A side of a face, from corner to corner + 1.
struct Side {
  int low, high;  // its vertices, in order of their numbers
  int face, corner;

  auto key() const { return std::tie(low, high, face); }
  bool same_edge(const Side& other) const { return low == other.low && high == other.high; }
};

// The sides of all faces, sorted: the sides of one edge are neighbours.
std::vector<Side> sorted_sides(const std::vector<Face>& faces) {
  std::vector<Side> sides;
  sides.reserve(3 * faces.size());
  for (size_t face = 0; face < faces.size(); ++face)
    for (int corner = 0; corner < 3; ++corner) {
      const auto [low, high] = std::minmax(faces[face][corner], faces[face][(corner + 1) % 3]);
      sides.push_back({low, high, int(face), corner});
    }
  std::sort(sides.begin(), sides.end(),
            [](const Side& a, const Side& b) { return a.key() < b.key(); });
  return sides;
}

int opposite(const std::vector<Face>& faces, const Side& side) {
  return faces[side.face][(side.corner + 2) % 3];
}

InteriorEdge make_interior_edge(const std::vector<Face>& faces, const Side& a, const Side& b) {
  const Face& f = faces[a.face];
  return {{opposite(faces, a), f[a.corner], f[(a.corner + 1) % 3], opposite(faces, b)},
          {a.face, b.face}};
}

}  // namespace

MeshEdges find_edges(const std::vector<Face>& faces, const std::string& source) {
  const std::vector<Side> sides = sorted_sides(faces);
  MeshEdges edges;
  for (size_t first = 0, next; first < sides.size(); first = next) {
    for (next = first + 1; next < sides.size() && sides[first].same_edge(sides[next]);) ++next;
    if (next - first > 2)
      throw BadInput(source + ": the edge between vertices " + std::to_string(sides[first].low) +
                     " and " + std::to_string(sides[first].high) +
                     " (counted from 0) has more than two faces; cloth has one or two on an edge");
    if (next - first == 2)
      edges.interior.push_back(make_interior_edge(faces, sides[first], sides[first + 1]));
    else
      edges.boundary.push_back({{sides[first].low, sides[first].high}, sides[first].face});
  }
  return edges;
}
