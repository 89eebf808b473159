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

// The sides of all faces, those of one edge next to each other.
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

// The rest shape of a face, as flap 0 or 1 of a hinge.
FlatFlap rest_flap(const Mesh& mesh, const InteriorEdge& edge, int flap) {
  const Face& face = mesh.faces[edge.faces[flap]];
  FlatFlap p;
  for (int i = 0; i < 3; ++i) {
    const auto corner = std::find(face.begin(), face.end(), edge.vertices[corners[flap][i]]);
    p[i] = mesh.rest[edge.faces[flap]][corner - face.begin()];
  }
  return p;
}

// |e|² at rest, the mean of the two flaps, which may differ on a seam.
double squared_edge(const FlatFlap& flap0, const FlatFlap& flap1) {
  return 0.5 * ((flap0[1] - flap0[2]).squaredNorm() + (flap1[1] - flap1[2]).squaredNorm());
}

// Bridson's |e|²/(|N0| + |N1|), where |N| is twice an area.
double shape(const FlatFlap& flap0, const FlatFlap& flap1) {
  return squared_edge(flap0, flap1) / (2 * (area(flap0) + area(flap1)));
}

// How far the corners 0 are apart when the hinge is flat.
double opposite_distance(const FlatFlap& flap0, const FlatFlap& flap1) {
  const auto place = [](const FlatFlap& p) {  // of corner 0: along the edge, and off it
    const Vec2 e = p[2] - p[1], middle = 0.5 * (p[1] + p[2]);
    return Vec2((p[0] - middle).dot(e) / e.norm(), 2 * area(p) / e.norm());
  };
  return (place(flap0) + place(flap1)).norm();  // flap 1 sees both turned round
}

template <class Make>
auto for_each_hinge(const Mesh& mesh, const Make& make) {
  using Element = decltype(make(InteriorEdge{}, FlatFlap{}, FlatFlap{}));
  std::vector<Element> elements;
  for (const InteriorEdge& edge : find_edges(mesh.faces).interior)
    elements.push_back(make(edge, rest_flap(mesh, edge, 0), rest_flap(mesh, edge, 1)));
  return elements;
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
      ++edges.boundary;
  }
  return edges;
}

std::vector<Hinge> make_hinges(const Mesh& mesh) {
  return for_each_hinge(mesh, [&](const InteriorEdge& edge, const auto& flap0, const auto& flap1) {
    Hinge hinge{edge.vertices, 0, shape(flap0, flap1)};
    const auto [face0, face1] = edge.faces;
    if (!mesh.rests_flat(face0) || !mesh.rests_flat(face1)) rest_at(mesh.x, {&hinge, 1});
    return hinge;
  });
}

std::vector<QuadraticHinge> make_quadratic_hinges(const Mesh& mesh) {
  return for_each_hinge(mesh, [](const InteriorEdge& edge, const auto& flap0, const auto& flap1) {
    return make_quadratic_hinge(edge.vertices, flap0, flap1);
  });
}

std::vector<Spring> make_bend_springs(const Mesh& mesh) {
  return for_each_hinge(mesh, [](const InteriorEdge& edge, const auto& flap0, const auto& flap1) {
    return make_spring(edge.vertices[0], edge.vertices[3], opposite_distance(flap0, flap1));
  });
}

void rest_at(const VecX& x, std::span<Hinge> hinges) {
  for (Hinge& hinge : hinges) hinge.rest_angle = angle(make_fold(gather(hinge, x)));
}
