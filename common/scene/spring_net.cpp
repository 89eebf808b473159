#include "scene/spring_net.h"

#include <algorithm>
#include <tuple>

#include "scene/hinges.h"
#include "scene/mesh_edges.h"

namespace {

enum class Kind { edge, diagonal, apart };

// A spring to be: sorted by its vertices and its kind.
struct Link {
  int low, high;
  Kind kind;
  double rest_length;  // m
  double stiffness;    // N/m

  auto key() const { return std::tie(low, high, kind); }
};

class Net {
 public:
  void add(int i, int j, Kind kind, double rest_length, double stiffness) {
    if (stiffness > 0)
      links.push_back({std::min(i, j), std::max(i, j), kind, rest_length, stiffness});
  }
  std::vector<Spring> springs(double k) {
    const auto before = [](const Link& a, const Link& b) { return a.key() < b.key(); };
    const auto same = [](const Link& a, const Link& b) { return a.key() == b.key(); };
    std::sort(links.begin(), links.end(), before);
    links.erase(std::unique(links.begin(), links.end(), same), links.end());
    std::vector<Spring> springs;
    springs.reserve(links.size());
    for (const Link& link : links)
      springs.push_back(make_spring(link.low, link.high, link.rest_length, link.stiffness / k));
    return springs;
  }

 private:
  std::vector<Link> links;
};

// The mesh of a grid lies flat at rest.
double distance(const Mesh& mesh, int i, int j) {
  return (mesh.x.segment<3>(3 * i) - mesh.x.segment<3>(3 * j)).norm();
}

// The springs along one direction of the grid: cells[along] of them in each of cells[across] + 1 rows.
void add_rows(const Mesh& mesh, int along, const SpringTerm& term, Net& net) {
  const Grid& grid = *mesh.grid;
  const int across = 1 - along, rows = grid.cells[across] + 1;
  for (int row = 0; row < rows; ++row) {
    const double share = row == 0 || row == rows - 1 ? 0.5 : 1;
    const auto vertex = [&](int i) {
      return along == 0 ? grid.vertex(i, row) : grid.vertex(row, i);
    };
    const auto add = [&](int i, int j, Kind kind, double stiffness) {
      net.add(vertex(i), vertex(j), kind, distance(mesh, vertex(i), vertex(j)), share * stiffness);
    };
    for (int i = 0; i < grid.cells[along]; ++i) {
      add(i, i + 1, Kind::edge, term.k);
      if (i + 2 <= grid.cells[along]) add(i, i + 2, Kind::apart, term.apart);
    }
  }
}

// One diagonal is that of the triangles.
void add_diagonals(const Mesh& mesh, const SpringTerm& term, Net& net) {
  const Grid& grid = *mesh.grid;
  const auto add = [&](int i, int j) {
    net.add(i, j, Kind::diagonal, distance(mesh, i, j), term.shear);
  };
  if (term.both_diagonals)
    for (int j = 0; j < grid.cells[1]; ++j)
      for (int i = 0; i < grid.cells[0]; ++i) {
        add(grid.vertex(i, j), grid.vertex(i + 1, j + 1));
        add(grid.vertex(i + 1, j), grid.vertex(i, j + 1));
      }
  else
    for (const InteriorEdge& edge : find_edges(mesh.faces).interior) {
      const auto [i, j] = std::array{edge.vertices[1], edge.vertices[2]};
      const int columns = grid.cells[0] + 1;
      if (i % columns != j % columns && i / columns != j / columns) add(i, j);
    }
}

// The length of the edge between vertices i and j of a face, at rest.
double rest_edge(const Mesh& mesh, int face, int i, int j) {
  const auto uv = [&](int vertex) {
    const Face& f = mesh.faces[size_t(face)];
    return mesh.rest[size_t(face)][size_t(std::find(f.begin(), f.end(), vertex) - f.begin())];
  };
  return (uv(i) - uv(j)).norm();
}

// The two faces of an edge may differ on a seam.
void add_edges(const Mesh& mesh, const MeshEdges& edges, const SpringTerm& term, Net& net) {
  for (const InteriorEdge& edge : edges.interior) {
    const auto [i, j] = std::array{edge.vertices[1], edge.vertices[2]};
    const double length =
        (rest_edge(mesh, edge.faces[0], i, j) + rest_edge(mesh, edge.faces[1], i, j)) / 2;
    net.add(i, j, Kind::edge, length, term.k);
  }
  for (const auto& [vertices, face] : edges.boundary)
    net.add(vertices[0], vertices[1], Kind::edge, rest_edge(mesh, face, vertices[0], vertices[1]),
            0.5 * term.k);
}

// Where both faces rest flat, so does the spring across their edge.
void add_opposite(const Mesh& mesh, const MeshEdges& edges, const SpringTerm& term, Net& net) {
  const std::vector<Spring> flat = make_bend_springs(mesh);
  for (size_t e = 0; e < flat.size(); ++e) {
    const auto [i, j] = flat[e].vertices;
    const auto [face0, face1] = edges.interior[e].faces;
    const bool rests_flat = mesh.rests_flat(face0) && mesh.rests_flat(face1);
    net.add(i, j, Kind::apart, rests_flat ? flat[e].rest_length : distance(mesh, i, j), term.apart);
  }
}

}  // namespace

std::vector<Spring> make_spring_net(const Mesh& mesh, const SpringTerm& term) {
  Net net;
  if (mesh.grid && term.on_grid) {
    for (const int along : {0, 1}) add_rows(mesh, along, term, net);
    add_diagonals(mesh, term, net);
  } else {
    const MeshEdges edges = find_edges(mesh.faces);
    add_edges(mesh, edges, term, net);
    add_opposite(mesh, edges, term, net);
  }
  return net.springs(term.k);
}
