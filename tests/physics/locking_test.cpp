// Locking: a mesh whose edges cannot stretch can bend in far fewer ways than it has vertices to move.
#include <gtest/gtest.h>

#include "cantilever.h"
#include "scene/mesh_edges.h"
#include "support/decompositions.h"

namespace locking_test {

using Edge = std::array<int, 2>;

std::vector<Edge> edges(const Mesh& mesh) {
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

// A grid of 8 × 8 cells of 1 m, folded by 1 rad on a straight line: which edges change, and by how much.
struct Folded {
  int changed = 0;
  double most = 0;  // of the length at rest
};

Folded fold(const Vec2& through, double direction) {
  const Mesh mesh = make_grid({8, 8}, {8, 8}, Diagonals::same);
  const Vec3 p(through.x(), 0, -through.y()), along(std::cos(direction), 0, -std::sin(direction));
  const Vec3 aside = Vec3::UnitY().cross(along);
  VecX x = mesh.x;
  for (int i = 0; i < mesh.vertices(); ++i) {
    const Vec3 from_line = x.segment<3>(3 * i) - p;
    if (from_line.dot(aside) > 1e-9)
      x.segment<3>(3 * i) = p + Eigen::AngleAxisd(1, along) * from_line;
  }
  Folded folded;
  for (const auto& [i, j] : edges(mesh)) {
    const double before = (mesh.x.segment<3>(3 * i) - mesh.x.segment<3>(3 * j)).norm();
    const double change = (x.segment<3>(3 * i) - x.segment<3>(3 * j)).norm() / before - 1;
    if (std::abs(change) > 1e-12) ++folded.changed;
    folded.most = std::max(folded.most, std::abs(change));
  }
  return folded;
}

// A fold along a mesh line only bends hinges. Any other fold shortens the edges that it crosses: at most to
// cos(1/2) of their length, where it crosses the middle of an edge at a right angle.
TEST(Locking, OnlyFoldsAlongMeshLinesChangeNoLength) {
  ASSERT_EQ(edges(make_grid({8, 8}, {8, 8}, Diagonals::same)).size(), 208u);
  struct Case {
    const char* name;
    Vec2 through;
    double degrees;
    int changed;
    double most;
  };
  for (const Case& c : {Case{"along u", {4, 4}, 0, 0, 0}, Case{"along v", {4, 4}, 90, 0, 0},
                        Case{"along the diagonals", {4, 4}, 135, 0, 0},
                        Case{"across the diagonals", {4, 4}, 45, 8, 1 - std::cos(0.5)},
                        Case{"at 20 degrees", {0, 2.5}, 20, 23, 0.107}}) {
    const Folded folded = fold(c.through, c.degrees * pi / 180);
    std::printf("fold %s: %d of 208 edges change, by up to %.1f %%\n", c.name, folded.changed,
                100 * folded.most);
    EXPECT_EQ(folded.changed, c.changed) << c.name;
    EXPECT_NEAR(folded.most, c.most, 1e-3) << c.name;
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
  const double straight = locked(8, 0), crooked = locked(8, 0.25);
  EXPECT_GT(straight, 0.02);
  EXPECT_GT(crooked, 1.3 * straight);
  EXPECT_LT(locked(16, 0), 0.9 * straight);
  EXPECT_LT(locked(16, 0.25), 0.9 * crooked);
}

}  // namespace locking_test
