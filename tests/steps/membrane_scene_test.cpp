// [membrane] and [spring] of a scene: moduli, refusals, the nets of springs, and what --explain says of them.
#include <algorithm>
#include <set>

#include "explain/parts.h"
#include "math/energy.h"
#include "scene/spring_net.h"
#include "support/membranes.h"
#include "support/scene_files.h"

namespace membrane_scene_test {

// 7 lines; the tables follow from line 8 on.
const std::string grid = cloth_and_time;

class MembraneScene : public SceneFiles {
 protected:
  Cloth membrane(const std::string& lines) const {
    return read(grid + "[membrane]\n" + lines).cloth;
  }
  std::string refused(const std::string& lines) const {
    return refusal(grid + "[membrane]\n" + lines);
  }
  Cloth springs(const std::string& lines) const { return read(grid + "[spring]\n" + lines).cloth; }
};

TEST_F(MembraneScene, HasTheLameConstantsOfEAndNu) {
  const auto expect_moduli = [&](const std::string& lines, double mu, double lambda) {
    const Cloth cloth = membrane("model = \"corotated\"\n" + lines);
    const auto& term = cloth.term<Membrane<Corotated>>();
    ASSERT_TRUE(term);
    EXPECT_NEAR(term->mu(), mu, 1e-12 * mu) << lines;
    EXPECT_NEAR(term->lambda(), lambda, 1e-12 * mu) << lines;
    EXPECT_EQ(cloth.triangles.elements.size(), 8u);
  };
  expect_moduli("E = 1000.0", 500, 0);
  expect_moduli("E = 1000\nnu = 0.3", 1000 / 2.6, 300 / 0.91);
  expect_moduli("E = 1000\nnu = -0.5", 1000, -500 / 0.75);
  expect_moduli("mu = 10", 10, 0);
  expect_moduli("mu = 10\nlambda = -10", 10, -10);
}

TEST_F(MembraneScene, EveryModelIsReadByItsName) {
  for (const std::string& name : membrane_names()) {
    const Cloth cloth = membrane("model = \"" + name + "\"\nmu = 3\n[damping]\nmembrane = 0.5");
    int found = 0;
    for_each_term(cloth, [&]<class T>(const std::optional<T>& term) {
      if (!term) return;
      ++found;
      EXPECT_EQ(T::info.model, name);
      EXPECT_EQ(term->k, 3);
      EXPECT_EQ(term->kd, 0.5);
    });
    EXPECT_EQ(found, 1);
  }
  EXPECT_TRUE(membrane("mu = 3").term<Membrane<Stvk>>()) << "the first of the list is the default";
}

TEST_F(MembraneScene, ModuliThatNoSheetHasAreRefused) {
  expect_says(refused("mu = -1"), {"scene.toml:9: [membrane] mu = -1 is not valid"});
  expect_says(refused("mu = 1\nlambda = -2"),
              {"scene.toml:10: ", "lambda + mu must not be negative"});
  expect_says(refused("E = 1\nnu = 1"), {"scene.toml:10: ", "between -1 and 1"});
  expect_says(refused("E = 1\nmu = 1"), {"scene.toml:9: ", "E = 1", "take it out"});
  expect_says(refused("lambda = 1"), {"scene.toml:9: ", "it needs mu"});
  expect_says(refused("model = \"stvk\""), {"[membrane] needs E"});
  expect_says(refused("k = 1"), {"[membrane] has no key k", "model, E, nu, mu, lambda"});
  expect_says(refused("model = \"rubber\"\nE = 1"), {"rubber", "neo-hookean-barrier"});
  expect_says(refused("model = \"arap\"\nE = 1\nnu = 0.1"), {"scene.toml:11: ", "arap has none"});
  expect_says(refused("model = \"arap\"\nmu = 1\nlambda = 1"),
              {"scene.toml:11: ", "arap has none"});
  const std::string barrier = "model = \"neo-hookean-barrier\"\n";
  expect_says(refused(barrier + "E = 1\nnu = -0.1"), {"scene.toml:11: ", "nu = -0.1"});
  expect_says(refused(barrier + "mu = 1\nlambda = -0.1"), {"scene.toml:11: ", "lambda = -0.1"});
  expect_says(refused(barrier + "mu = 0"), {"scene.toml:10: ", "above zero"});
}

TEST_F(MembraneScene, AClothHasThreadsOrAMembraneOrSprings) {
  const std::string membrane = "[membrane]\nE = 1\n", spring = "[spring]\nk = 1\n";
  for (const std::string table : {"stretch", "shear"}) {
    const std::string threads = "[" + table + "]\nk = 1\n";
    expect_says(refusal(grid + threads + membrane),
                {"[membrane] stands in place of [" + table + "]"});
    expect_says(refusal(grid + threads + spring), {"[spring] stands in place of [" + table + "]"});
  }
  expect_says(refusal(grid + spring + membrane), {"in place of"});
  EXPECT_TRUE(read(grid + spring + "[bend]\nk = 1", "step05_bend").cloth.term<DihedralBend>());
}

// Linear takes its axes from the start: wherever the cloth hangs, it is content there.
TEST_F(MembraneScene, TheLinearModelIsContentWhereItStarts) {
  for (const std::string shape : {"flat", "hanging"}) {
    const Scene scene =
        read(grid + "[membrane]\nmodel = \"linear\"\nE = 1000\n[start]\nshape = \"" + shape + "\"");
    const Cloth threads = read(grid + "[stretch]\nk = 1000").cloth;
    const double wrinkle = potential_energy(threads, scene.start.x);
    EXPECT_LE(potential_energy(scene.cloth, scene.start.x), 2 * wrinkle + 1e-20) << shape;
  }
}

TEST_F(MembraneScene, ExplainNamesTheModuli) {
  const auto words = [](const Cloth& cloth) { return describe_terms(cloth).back(); };
  EXPECT_EQ(words(membrane("model = \"neo-hookean\"\nmu = 4\nlambda = 2\n[damping]\nmembrane = 1")),
            "membrane (neo-hookean) mu = 4 N/m, lambda = 2 N/m, kd = 1 N·s/m");
  EXPECT_EQ(words(springs("k = 100\nshear = 50")), "spring k = 100 N/m, shear = 50 N/m");
}

// Springs ----------------------------------------------------------------------------------------

using Link = std::tuple<int, int, double, double>;  // vertices, rest length, stiffness

std::set<Link> links_of(const Cloth& cloth) {
  const double k = cloth.term<SpringTerm>()->k;
  std::set<Link> links;
  for (const Spring& s : cloth.springs.elements) {
    const double stiffness = k * s.sqrt_share * s.sqrt_share;
    links.emplace(s.vertices[0], s.vertices[1], std::round(1e9 * s.rest_length) / 1e9,
                  std::round(1e9 * stiffness) / 1e9);
  }
  EXPECT_EQ(links.size(), cloth.springs.elements.size()) << "no spring is there twice";
  return links;
}

// 2 × 2 cells on 1 m × 1 m: vertices 0 1 2 below, 3 4 5, 6 7 8 on top.
TEST_F(MembraneScene, ANetOnAGridHasEdgesDiagonalsAndSpringsTwoApart) {
  const double diagonal = std::round(1e9 * std::sqrt(0.5)) / 1e9;
  std::set<Link> expected;
  for (const int row : {0, 3, 6})
    for (const int i : {0, 1}) expected.emplace(row + i, row + i + 1, 0.5, row == 3 ? 100 : 50);
  for (const int column : {0, 1, 2})
    for (const int j : {0, 3})
      expected.emplace(column + j, column + j + 3, 0.5, column == 1 ? 100 : 50);
  EXPECT_EQ(links_of(springs("k = 100")), expected);

  const std::set<Link> edges = expected;
  for (const int corner : {0, 1, 3, 4}) {
    expected.emplace(corner, corner + 4, diagonal, 30);
    expected.emplace(corner + 1, corner + 3, diagonal, 30);
  }
  EXPECT_EQ(links_of(springs("k = 100\nshear = 30")), expected);

  for (const int row : {0, 3, 6}) expected.emplace(row, row + 2, 1, row == 3 ? 8 : 4);
  for (const int column : {0, 1, 2}) expected.emplace(column, column + 6, 1, column == 1 ? 8 : 4);
  EXPECT_EQ(links_of(springs("k = 100\nshear = 30\napart = 8")), expected);

  std::set<Link> one = edges;  // the diagonals of the triangles
  for (const int corner : {0, 1, 3, 4}) one.emplace(corner + 1, corner + 3, diagonal, 30);
  EXPECT_EQ(links_of(springs("k = 100\nshear = 30\ndiagonals = \"one\"")), one);
}

// Two triangles: five edges, one of them inside, and the spring between its opposite vertices.
TEST_F(MembraneScene, ANetOnAMeshHasASpringPerEdgeAndOneAcrossEach) {
  write("mesh.obj",
        "v 0 0 0\nv 3 0 0\nv 0 4 0\nv 3 4 0\nvt 0 0\nvt 3 0\nvt 0 4\nvt 3 4\n"
        "f 1/1 2/2 3/3\nf 2/2 4/4 3/3\n");
  const std::string mesh =
      "[cloth]\nmesh = \"mesh.obj\"\ndensity = 1\n[time]\nh = 0.01\nend = 1\n[spring]\nk = 10\n";
  const std::set<Link> expected = {{0, 1, 3, 5}, {0, 2, 4, 5}, {1, 2, 5, 10},
                                   {1, 3, 4, 5}, {2, 3, 3, 5}, {0, 3, 5, 2}};
  EXPECT_EQ(links_of(read(mesh + "apart = 2").cloth), expected);
  EXPECT_EQ(links_of(springs("k = 10\nnet = \"mesh\"")).size(), 16u);
  expect_says(refusal(mesh + "shear = 1"), {"scene.toml:9: ", "only a grid has cells"});
  expect_says(refusal(grid + "[spring]\nk = 10\nnet = \"mesh\"\nshear = 1"),
              {"scene.toml:11: ", "take it out"});
  expect_says(refusal(grid + "[spring]\nk = 0"), {"scene.toml:9: ", "k = 0"});
}

}  // namespace membrane_scene_test
