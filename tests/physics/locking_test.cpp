// Locking: a mesh whose edges cannot stretch can bend in far fewer ways than it has vertices to move.
#include <gtest/gtest.h>

#include "cantilever.h"
#include "scene/mesh_edges.h"
#include "support/decompositions.h"
#include "support/straight_fold.h"

namespace locking_test {

// One row per edge: the derivative of its length by the positions of the vertices.
MatX rigidity(const VecX& x, const std::vector<Edge>& edges) {
  MatX R = MatX::Zero(Eigen::Index(edges.size()), x.size());
  for (size_t row = 0; row < edges.size(); ++row) {
    const auto [i, j] = edges[row];
    const Vec3 n = (x.segment<3>(3 * i) - x.segment<3>(3 * j)).normalized();
    R.block<1, 3>(Eigen::Index(row), 3 * i) = n.transpose();
    R.block<1, 3>(Eigen::Index(row), 3 * j) = -n.transpose();
  }
  return R;
}

int rank(const MatX& A) {
  return int(range(product({A, A.transpose()})).cols());
}

// E = 3 V − 3 − B edges of fixed length leave B + 3 of the 3 V coordinates free: a mesh with more inner
// vertices has a smaller share of free motions. Six of the free motions move the mesh as a whole. The test
// counts by the rank of the rigidity matrix, in space. On a flat mesh the rank is smaller, because to lift a
// vertex changes no length at first.
TEST(Locking, EdgesLeaveAsManyWaysToMoveAsTheBoundaryHasVerticesAndThreeMore) {
  struct Case {
    std::array<int, 2> vertices;
    int edges, left;
  };
  Random random(51);
  for (const Case& known :
       {Case{{2, 2}, 5, 7}, Case{{3, 3}, 16, 11}, Case{{4, 5}, 43, 17}, Case{{6, 6}, 85, 23}})
    for (const Diagonals diagonals : {Diagonals::same, Diagonals::alternating}) {
      const auto [nx, ny] = known.vertices;
      const Mesh mesh = make_grid({1, 1}, {nx - 1, ny - 1}, diagonals);
      const std::vector<Edge> all = edges(mesh);
      const int V = mesh.vertices(), E = int(all.size()),
                B = int(find_edges(mesh.faces).boundary.size());
      SCOPED_TRACE(std::to_string(nx) + " x " + std::to_string(ny));
      EXPECT_EQ(E, known.edges);
      EXPECT_EQ(E, 3 * V - 3 - B);

      const VecX crumpled = mesh.x + random.vector(3 * V, 0.3 / nx);
      EXPECT_EQ(rank(rigidity(crumpled, all)), E) << "no edge is idle";
      EXPECT_EQ(3 * V - E, known.left);
      EXPECT_EQ(3 * V - E, B + 3);
      EXPECT_EQ(rank(rigidity(mesh.x, all)), 2 * V - 3) << "flat: only what keeps a plane rigid";
    }
}

// A fold along a mesh line only bends hinges. Any other fold shortens the edges that it crosses: at most to
// cos(1/2) of their length, where it crosses the middle of an edge at a right angle.
TEST(Locking, OnlyFoldsAlongMeshLinesChangeNoLength) {
  const Mesh mesh = make_grid({8, 8}, {8, 8}, Diagonals::same);
  ASSERT_EQ(edges(mesh).size(), 208u);
  struct Case {
    const char* name;
    Vec2 through;
    double degrees;
    size_t changed;
    double most;
  };
  for (const Case& c : {Case{"along u", {4, 4}, 0, 0, 0}, Case{"along v", {4, 4}, 90, 0, 0},
                        Case{"along the diagonals", {4, 4}, 135, 0, 0},
                        Case{"across the diagonals", {4, 4}, 45, 8, 1 - std::cos(0.5)},
                        Case{"at 20 degrees", {0, 2.5}, 20, 23, 0.107}}) {
    const std::vector<ChangedEdge> changed =
        changed_by_fold(mesh, {c.through, c.degrees * pi / 180});
    double most = 0;
    for (const ChangedEdge& edge : changed) most = std::max(most, std::abs(edge.change));
    std::printf("fold %s: %zu of 208 edges change, by up to %.1f %%\n", c.name, changed.size(),
                100 * most);
    EXPECT_EQ(changed.size(), c.changed) << c.name;
    EXPECT_NEAR(most, c.most, 1e-3) << c.name;
  }
}

// How much less a free strip droops when its membrane gets ten thousand times as stiff.
double locked(int N, double jitter) {
  Cantilever c;
  c.N = N;
  c.across = N / 2;
  c.rows = Rows::free;
  c.jitter = jitter;
  std::vector<double> droops;
  for (const double membrane : {1e4, 1e8}) {
    c.membrane = membrane;
    droops.push_back(tips(c, {2, 5, 10}).back().droop());
  }
  const double lost = 1 - droops[1] / droops[0];
  std::printf("N = %d, vertices up to %.2f h off: H/W %.4f, %.4f: %.1f %% lost\n", N, jitter,
              droops[0], droops[1], 100 * lost);
  return lost;
}

// Membrane locking: cloth that cannot stretch can only fold along mesh lines. So it bends less than its
// hinges allow. The effect is larger where the mesh lines are crooked, and smaller on finer grids. (With
// k L²/B = 1e4 the weight, Γ = 10, stretches the strip by 1e-3, which can be neglected.)
TEST(Locking, StiffMembranesBendLess) {
  struct Case {
    int N;
    double jitter, lost;
  };
  for (const Case& c :
       {Case{8, 0, 0.049}, Case{8, 0.25, 0.158}, Case{16, 0, 0.027}, Case{16, 0.25, 0.076}})
    EXPECT_NEAR(locked(c.N, c.jitter), c.lost, 0.001) << "N = " << c.N << ", " << c.jitter << " h";
}

}  // namespace locking_test
