#include "scene/hinges.h"

#include <algorithm>

#include "scene/mesh_edges.h"

namespace {

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

// Bridson's σ = l²/(2 A0 + 2 A1).
double shape(const FlatFlap& flap0, const FlatFlap& flap1) {
  return squared_edge(flap0, flap1) / (2 * (area(flap0) + area(flap1)));
}

// m, above the longest edge.
double lowest_height(const FlatFlap& p) {
  const double longest =
      std::max({(p[1] - p[0]).norm(), (p[2] - p[1]).norm(), (p[0] - p[2]).norm()});
  return 2 * area(p) / longest;
}

// The distance of the two corners 0 when the hinge is flat.
double opposite_distance(const FlatFlap& flap0, const FlatFlap& flap1) {
  const auto place = [](const FlatFlap& p) {  // of corner 0: along the edge, and across it
    const Vec2 e = p[2] - p[1], middle = 0.5 * (p[1] + p[2]);
    return Vec2((p[0] - middle).dot(e) / e.norm(), 2 * area(p) / e.norm());
  };
  return (place(flap0) + place(flap1)).norm();  // for flap 1 both axes are reversed
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

std::vector<Hinge> make_hinges(const Mesh& mesh) {
  return for_each_hinge(mesh, [&](const InteriorEdge& edge, const auto& flap0, const auto& flap1) {
    Hinge hinge;
    hinge.vertices = edge.vertices;
    hinge.shape = shape(flap0, flap1);
    hinge.lowest = 1e-4 * std::min(lowest_height(flap0), lowest_height(flap1));
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
  for (Hinge& hinge : hinges) hinge.rest_angle = angle(gather(hinge, x));
}
