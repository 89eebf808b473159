// Which triangles share an edge: counted by Euler's formula, oriented for the angle, and refused
// where three triangles meet.
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "scene/hinges.h"
#include "scene/mesh_edges.h"
#include "support/poses.h"
#include "text/bad_input.h"

namespace hinge_topology_test {

// A disc: V − E + F = 1. Every face has three sides: 3 F = 2 E − B.
void expect_disc(const Mesh& mesh) {
  const MeshEdges edges = find_edges(mesh.faces);
  const int V = mesh.vertices(), F = int(mesh.faces.size()), B = int(edges.boundary.size());
  const int E = int(edges.interior.size()) + B;
  EXPECT_EQ(V - E + F, 1);
  EXPECT_EQ(3 * F, 2 * E - B);
  EXPECT_EQ(E, 3 * V - 3 - B);
}

TEST(HingeTopology, GridsObeyEulersFormula) {
  for (const Diagonals diagonals : {Diagonals::same, Diagonals::alternating})
    for (const std::array<int, 2>& cells : {std::array{1, 1}, {2, 2}, {3, 4}, {5, 5}, {1, 7}}) {
      SCOPED_TRACE(std::to_string(cells[0]) + " x " + std::to_string(cells[1]));
      const Mesh mesh = make_grid({1, 1}, cells, diagonals);
      expect_disc(mesh);
      EXPECT_EQ(find_edges(mesh.faces).boundary.size(), 2 * size_t(cells[0] + cells[1]));
    }
}

// The edge counts of note 003: 2 × 2, 3 × 3, 4 × 5 and 6 × 6 vertices.
TEST(HingeTopology, EdgesOfSmallGridsAreThoseOfTheNotes) {
  const auto edges = [](int nx, int ny) {
    const MeshEdges found = find_edges(make_grid({1, 1}, {nx - 1, ny - 1}, Diagonals::same).faces);
    return int(found.interior.size()) + int(found.boundary.size());
  };
  EXPECT_EQ(edges(2, 2), 5);
  EXPECT_EQ(edges(3, 3), 16);
  EXPECT_EQ(edges(4, 5), 43);
  EXPECT_EQ(edges(6, 6), 85);
}

TEST(HingeTopology, AClosedSurfaceHasNoBoundary) {
  const std::vector<Face> tetrahedron = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  const MeshEdges edges = find_edges(tetrahedron);
  EXPECT_EQ(edges.boundary.size(), 0u);
  EXPECT_EQ(edges.interior.size(), 6u);  // E = 3 V − 6
}

bool has_side(const Face& f, int from, int to) {
  for (int c = 0; c < 3; ++c)
    if (f[c] == from && f[(c + 1) % 3] == to) return true;
  return false;
}

TEST(HingeTopology, BothFlapsAreWoundAsTheirFaces) {
  const Mesh mesh = make_grid({2, 1}, {4, 3}, Diagonals::alternating);
  std::set<std::pair<int, int>> seen;
  for (const InteriorEdge& edge : find_edges(mesh.faces).interior) {
    const auto [p0, p1, p2, p3] = edge.vertices;
    const Face &face0 = mesh.faces[edge.faces[0]], &face1 = mesh.faces[edge.faces[1]];
    EXPECT_LT(edge.faces[0], edge.faces[1]);
    EXPECT_TRUE(has_side(face0, p0, p1) && has_side(face0, p1, p2) && has_side(face0, p2, p0));
    EXPECT_TRUE(has_side(face1, p3, p2) && has_side(face1, p2, p1) && has_side(face1, p1, p3));
    EXPECT_TRUE(seen.insert(std::minmax(p1, p2)).second) << "found twice";
  }
}

// The hinges do not depend on the order of the faces, nor on the corner at which a face begins.
TEST(HingeTopology, OrderOfTheFacesIsOnlyAName) {
  Mesh mesh = make_grid({1, 1}, {4, 4}, Diagonals::alternating);
  using Unordered = std::set<std::pair<std::set<int>, std::set<int>>>;
  const auto hinges = [](const std::vector<Face>& faces) {
    Unordered all;
    for (const InteriorEdge& e : find_edges(faces).interior)
      all.insert({{e.vertices[1], e.vertices[2]}, {e.vertices[0], e.vertices[3]}});
    return all;
  };
  const Unordered before = hinges(mesh.faces);
  std::shuffle(mesh.faces.begin(), mesh.faces.end(), std::mt19937(1));
  for (size_t f = 0; f < mesh.faces.size(); ++f)
    std::rotate(mesh.faces[f].begin(), mesh.faces[f].begin() + f % 3, mesh.faces[f].end());
  EXPECT_EQ(hinges(mesh.faces), before);
}

// A face wound against its neighbour: the hinge reverses flap 1, so that a flat hinge has the angle 0.
TEST(HingeTopology, AFaceWoundTheOtherWayMakesNoFold) {
  Mesh mesh = make_grid({1, 1}, {3, 3}, Diagonals::same);
  std::swap(mesh.faces[7][0], mesh.faces[7][1]);
  std::swap(mesh.rest[7][0], mesh.rest[7][1]);
  expect_disc(mesh);
  const std::vector<Hinge> hinges = make_hinges(mesh);
  for (const Hinge& hinge : hinges) EXPECT_NEAR(angle(gather(hinge, mesh.x)), 0, 1e-15);
}

TEST(HingeTopology, ThreeFacesOnAnEdgeAreRefusedByName) {
  const std::vector<Face> book = {{0, 1, 2}, {1, 0, 3}, {7, 4, 5}, {0, 1, 4}};
  try {
    find_edges(book, "book.obj");
    FAIL() << "not refused";
  } catch (const BadInput& refusal) {
    EXPECT_STREQ(refusal.what(),
                 "book.obj: the edge between vertices 0 and 1 (counted from 0) has more than two "
                 "faces; cloth has one or two on an edge");
  }
}

TEST(HingeTopology, NoFacesHaveNoEdges) {
  EXPECT_TRUE(find_edges({}).interior.empty());
  EXPECT_EQ(find_edges({}).boundary.size(), 0u);
}

// Bridson's σ of the two kinds of hinges of a square cell of side s: the diagonal √2 s, an axis edge s,
// each with two triangles of s²/2.
TEST(HingeTopology, ShapeFactorsOfSquareCells) {
  for (const Hinge& hinge : make_hinges(make_grid({3, 3}, {6, 6}, Diagonals::same))) {
    const bool diagonal = std::abs(hinge.vertices[1] - hinge.vertices[2]) == 6;
    EXPECT_NEAR(hinge.shape, diagonal ? 1 : 0.5, 1e-14);
    EXPECT_EQ(hinge.rest_angle, 0);
    EXPECT_EQ(hinge.theta, 0);
  }
}

// Opposite vertices of a cell are √2 s apart, those across an axis edge √5 s.
TEST(HingeTopology, BendSpringsRestWhereTheClothIsFlat) {
  const Mesh mesh = make_grid({3, 3}, {6, 6}, Diagonals::same);
  const std::vector<Spring> springs = make_bend_springs(mesh);
  EXPECT_EQ(springs.size(), make_hinges(mesh).size());
  std::map<long, int> lengths;
  for (const Spring& s : springs) {
    EXPECT_NEAR(gather(s, mesh.x)[0].norm(), s.rest_length, 1e-15);
    ++lengths[std::lround(4 * s.rest_length * s.rest_length)];
  }
  EXPECT_EQ(lengths, (std::map<long, int>{{2, 36}, {5, 60}}));
}

// A tetrahedron at rest in space: between two faces of a regular one the angle is π − acos(1/3).
TEST(HingeTopology, RestAnglesInSpaceAreThoseOfTheRestShape) {
  Mesh mesh;
  mesh.faces = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};  // counter-clockwise from outside
  mesh.x.resize(12);
  mesh.x << 1, 1, 1, -1, 1, -1, 1, -1, -1, -1, -1, 1;
  const double side = std::sqrt(8);
  mesh.rest.assign(4, {Vec2(0, 0), Vec2(side, 0), Vec2(side / 2, std::sqrt(6))});
  const Vec3 out = (mesh.x.segment<3>(6) - mesh.x.head<3>())
                       .cross(Vec3(mesh.x.segment<3>(3) - mesh.x.head<3>()));
  ASSERT_GT(out.dot(mesh.x.head<3>()), 0) << "the faces look outside";
  std::vector<Hinge> hinges = make_hinges(mesh);
  rest_at(mesh.x, hinges);
  for (const Hinge& hinge : hinges)
    EXPECT_NEAR(hinge.rest_angle, std::numbers::pi - std::acos(1 / 3.0), 1e-14);
}

}  // namespace hinge_topology_test
