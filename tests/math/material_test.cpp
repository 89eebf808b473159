// The material is the cloth's and not the mesh's, and on a grid of right triangles stretch is
// nothing but springs on the grid lines.
#include <gtest/gtest.h>

#include <map>

#include "scene/make_cloth.h"
#include "support/energy.h"
#include "support/poses.h"

namespace material_test {

// A grid stretched along u.
struct Stretched {
  Mesh mesh;
  Cloth cloth;
  VecX x;
};

Stretched stretched_sheet(const Vec2& size, const std::array<int, 2>& cells, double k,
                          double strain) {
  Stretched s;
  s.mesh = make_grid(size, cells, Diagonals::same);
  Model model;
  model.add(StretchTerm(k));
  s.cloth = make_cloth(s.mesh, model);
  s.x = s.mesh.x;
  for (int i = 0; i < s.mesh.vertices(); ++i) s.x[3 * i] *= 1 + strain;
  return s;
}

// The pull on the edge u = size_x: Σ f over its vertices.
Vec3 force_on_right_edge(const Stretched& s) {
  const VecX f = forces(s.cloth, s.x);
  const double right = s.x.maxCoeff();
  Vec3 sum = Vec3::Zero();
  for (int i = 0; i < s.mesh.vertices(); ++i)
    if (s.x[3 * i] > right - 1e-9) sum += f.segment<3>(3 * i);
  return sum;
}

// The energy with the paper's weight: C = a (|w| − 1).
double energy_of_the_papers_weight(const Stretched& s, double k) {
  double E = 0;
  for (const Triangle& t : s.cloth.triangles.elements)
    for (const Vec3& w : gather(t, s.x)) E += k / 2 * std::pow(t.area * (w.norm() - 1), 2);
  return E;
}

TEST(Material, EnergyIsThatOfTheSheetWhateverTheMesh) {
  const double k = 1, strain = 0.05;
  for (const int n : {4, 8, 16, 32}) {
    const Stretched s = stretched_sheet({1, 1}, {n, n}, k, strain);
    EXPECT_NEAR(potential_energy(s.cloth, s.x), 1.25e-3, 1e-15) << n << " cells";  // k/2 ε² A
  }
  // A sheet that is not square, with cells that are not.
  const Stretched s = stretched_sheet({2, 0.5}, {7, 3}, 300, strain);
  EXPECT_NEAR(potential_energy(s.cloth, s.x), 300 / 2 * strain * strain * (2 * 0.5), 1e-12);
}

TEST(Material, PullOnTheEdgeIsStiffnessTimesStrainTimesWidth) {
  for (const int n : {4, 32}) {
    const Stretched s = stretched_sheet({1, 1}, {n, n}, 1, 0.05);
    EXPECT_LT((force_on_right_edge(s) - Vec3(-0.05, 0, 0)).norm(), 1e-14) << n << " cells";
  }
  const Stretched s = stretched_sheet({2, 0.5}, {7, 3}, 300, 0.05);
  EXPECT_LT((force_on_right_edge(s) - Vec3(-300 * 0.05 * 0.5, 0, 0)).norm(), 1e-11);
}

// BW98 weighs by a: then every refinement makes the cloth four times softer.
TEST(Material, WeightOfThePaperWouldSoftenByFourPerRefinement) {
  double coarse = energy_of_the_papers_weight(stretched_sheet({1, 1}, {4, 4}, 1, 0.05), 1);
  for (const int n : {8, 16, 32}) {
    const double fine = energy_of_the_papers_weight(stretched_sheet({1, 1}, {n, n}, 1, 0.05), 1);
    EXPECT_NEAR(coarse / fine, 4, 1e-11) << n << " cells";
    coarse = fine;
  }
}

// The springs that replace stretch: on every edge along u or v
//
//   k_spring = k h_across / h_along · (triangles at the edge) / 2
//
// because each triangle has one edge along u, E = k/2 a (|w_u| − 1)² = k/2 a/h² (h|w_u| − h)².
Springs springs_on_grid_lines(const Mesh& mesh, const Vec2& cell, double k) {
  std::map<std::array<int, 3>, int> triangles_at;  // (smaller vertex, larger vertex, axis)
  for (size_t face = 0; face < mesh.faces.size(); ++face)
    for (size_t c = 0; c < 3; ++c) {
      const size_t d = (c + 1) % 3;
      const Vec2 edge = mesh.rest[face][d] - mesh.rest[face][c];
      const bool along_u = std::abs(edge.y()) < 1e-9, along_v = std::abs(edge.x()) < 1e-9;
      if (along_u || along_v)
        ++triangles_at[{std::min(mesh.faces[face][c], mesh.faces[face][d]),
                        std::max(mesh.faces[face][c], mesh.faces[face][d]), along_u ? 0 : 1}];
    }
  Springs springs;
  springs.term<SpringTerm>() = SpringTerm(k);
  for (const auto& [edge, triangles] : triangles_at) {
    const double along = cell[edge[2]], across = cell[1 - edge[2]];
    springs.elements.push_back(
        make_spring(edge[0], edge[1], along, across / along * triangles / 2));
  }
  return springs;
}

TEST(Material, StretchOnAGridIsSpringsOnTheGridLines) {
  const Vec2 size(1.0, 0.9);
  const std::array<int, 2> cells = {5, 3};
  const Vec2 cell(size.x() / cells[0], size.y() / cells[1]);
  const double k = 120;
  for (const Diagonals diagonals : {Diagonals::same, Diagonals::alternating}) {
    const Mesh mesh = make_grid(size, cells, diagonals);
    Model model;
    model.add(StretchTerm(k));
    const Cloth of_triangles = make_cloth(mesh, model);
    Cloth of_springs = bare_cloth(mesh.vertices());
    of_springs.springs = springs_on_grid_lines(mesh, cell, k);
    ASSERT_EQ(of_springs.springs.elements.size(), size_t(5 * 4 + 3 * 6));

    Random random(41);
    for (int i = 0; i < 10; ++i) {
      const VecX x = mesh.x + random.vector(int(mesh.x.size()), 0.05);
      const VecX f = forces(of_triangles, x);
      EXPECT_LT((forces(of_springs, x) - f).norm(), 1e-12 * f.norm());
      EXPECT_NEAR(potential_energy(of_springs, x), potential_energy(of_triangles, x),
                  1e-12 * potential_energy(of_triangles, x));
    }
  }
}

// A condition reads one vector, and `first` is its number.
TEST(Stretch, ReadsOneThreadAndSaysWhich) {
  const Triangle t = make_triangle({Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)});
  const Vecs<2> w = {Vec3(2, 0, 0), Vec3(0, 3, 0)};
  EXPECT_EQ(Stretch(t, w, 0).first, 0);
  EXPECT_EQ(Stretch(t, w, 1).first, 1);
  EXPECT_NEAR(Stretch(t, w, 0).C, std::sqrt(0.5) * 1, 1e-15);
  EXPECT_NEAR(Stretch(t, w, 1).C, std::sqrt(0.5) * 2, 1e-15);
}

// The share multiplies the stiffness: E = share k/2 (|y| − L)².
TEST(Spring, EnergyCountsTheShareAndItPullsTogetherWhenLong) {
  Random random(7);
  for (const double share : {1.0, 0.3})
    for (int i = 0; i < 20; ++i) {
      const Cloth cloth = one_spring(make_spring(0, 1, 0.8, share), 11);
      const VecX x = random.vector(6, 1);
      const double length = (x.head<3>() - x.tail<3>()).norm();
      EXPECT_NEAR(potential_energy(cloth, x), share * 11 / 2 * std::pow(length - 0.8, 2), 1e-14);
      const Vec3 towards = x.tail<3>() - x.head<3>();
      EXPECT_EQ(forces(cloth, x).head<3>().dot(towards) > 0, length > 0.8) << "length " << length;
    }
}

}  // namespace material_test
