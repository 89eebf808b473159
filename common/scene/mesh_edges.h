// Which triangles share an edge.
#pragma once
#include <string>

#include "scene/mesh.h"

// An edge of two faces, or of one.
struct InteriorEdge {
  std::array<int, 4> vertices;  // of its hinge: P0 | P1–P2 | P3
  std::array<int, 2> faces;     // with P0, with P3
};
struct BoundaryEdge {
  std::array<int, 2> vertices;
  int face;
};
struct MeshEdges {
  std::vector<InteriorEdge> interior;
  std::vector<BoundaryEdge> boundary;
};

// Flap 0 of a hinge is the face that is listed first, in its own orientation; the orientation of
// the other face does not matter. On a disc V − E + F = 1, and so E = 3V − 3 − B with B edges on
// the boundary. Throws BadInput, naming `source`, for an edge with more than two faces.
MeshEdges find_edges(const std::vector<Face>&, const std::string& source = "mesh");
