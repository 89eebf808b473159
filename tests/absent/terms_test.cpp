// A term is one fact in one place: the toy term is one header and one name in a list (CMakeLists.txt), and
// the whole program knows it. This executable also runs every_model_test.cpp on the toy. absent_test.cpp
// shows that the toy costs nothing in a scene that does not name it.
#include <algorithm>

#include "explain/parts.h"
#include "program/diagnostics.h"
#include "support/assembly.h"
#include "support/every_term.h"
#include "support/scene_files.h"

namespace terms_test {

// Lines 1 to 7: [cloth] and [time]; 8: [toy]; 10: [damping].
const std::string toy_alone = cloth_and_time + "[toy]\nk = 40\n";
const std::string toy_scene = toy_alone + "[damping]\ntoy = 0.5\n";

std::vector<std::string> names_of_parts(const Cloth& cloth) {
  std::vector<std::string> names;
  for (const Part& part : parts_of(cloth)) names.push_back(part.name);
  return names;
}

struct ToyTermTest : SceneFiles {};

TEST_F(ToyTermTest, IsReadFromItsTableWithItsDamping) {
  for (const char* program : {"step03_implicit", "step05_bend"}) {
    const Cloth cloth = read(toy_scene, program).cloth;
    const std::optional<ToyTerm>& toy = cloth.term<ToyTerm>();
    ASSERT_TRUE(toy);
    EXPECT_EQ(toy->k, 40);
    EXPECT_EQ(toy->kd, 0.5);
    EXPECT_EQ(cloth.triangles.elements.size(), 8u);
    EXPECT_FALSE(cloth.term<StretchTerm>());
    EXPECT_TRUE(damped(cloth));
    EXPECT_EQ(first_step_of(cloth), 3);
  }
  EXPECT_FALSE(damped(read(toy_alone, "step03_implicit").cloth));
}

TEST_F(ToyTermTest, IsRefusedByTheStepsBeforeItsFirst) {
  for (const std::string program : {"step01_explicit", "step02_damping"})
    EXPECT_EQ(refusal(toy_alone, program),
              "scene.toml:8: " + program +
                  " does not model [toy]; step03_implicit does. --without toy runs the scene "
                  "without it");
  expect_says(refusal(cloth_and_time + "[damping]\ntoy = 0.5\n"),
              {"scene.toml:9: ", "[toy]", "step03_implicit does"});
}

TEST_F(ToyTermTest, IsRefusedWithABadValue) {
  const std::string table = cloth_and_time + "[toy]\n";
  expect_says(refusal(table + "k = -1\n", "step03_implicit"), {"scene.toml:9: ", "[toy]", "k"});
  expect_says(refusal(table + "stiffness = 1\n", "step03_implicit"),
              {"scene.toml:9: ", "stiffness"});
  expect_says(refusal(cloth_and_time + "[damping]\ntoy = 1\n", "step03_implicit"),
              {"scene.toml:9: ", "the scene has no [toy] to damp"});
  expect_says(refusal(cloth_and_time + "[tay]\nk = 1\n", "step03_implicit"), {"tay", "toy"});
}

TEST_F(ToyTermTest, GoesWithItsDampingByWithout) {
  for (const char* program : {"step01_explicit", "step03_implicit"}) {
    const std::string scene = program[5] == '1' ? toy_alone : toy_scene;
    const Cloth cloth = read(scene, program, {.without = {"toy"}}).cloth;
    EXPECT_FALSE(cloth.term<ToyTerm>());
    EXPECT_TRUE(cloth.triangles.elements.empty());
    EXPECT_FALSE(damped(cloth));
  }
}

// The columns of log.csv are the tables of elastic_energies.
TEST_F(ToyTermTest, HasAColumnOfTheLog) {
  const Scene scene = read(toy_scene + "[shear]\nk = 7\n", "step03_implicit");
  const VecX x = 1.1 * scene.start.x;  // C = √a 0.21 everywhere, on 1 m²
  const TermEnergies energies = elastic_energies(scene.cloth, x);
  ASSERT_EQ(energies.size(), 2u);
  EXPECT_EQ(energies[0].first, "shear");
  EXPECT_EQ(energies[1].first, "toy");
  EXPECT_NEAR(energies[1].second, 0.5 * 40 * 0.21 * 0.21, 1e-12);
  EXPECT_TRUE(elastic_energies(read(cloth_and_time).cloth, x).empty());
}

TEST_F(ToyTermTest, HasItsPartsOfThePageOfExplain) {
  const Cloth cloth = read(toy_scene + "[shear]\nk = 7\n", "step03_implicit").cloth;
  EXPECT_EQ(describe_terms(cloth),
            (std::vector<std::string>{"shear k = 7 N/m", "toy k = 40 N/m, kd = 0.5 N·s/m"}));
  EXPECT_EQ(names_of_parts(cloth), (std::vector<std::string>{"shear", "toy", "damping of toy"}));
  EXPECT_EQ(sharing_of(cloth).terms, (std::vector<std::string>{"shear", "toy"}));
  EXPECT_EQ(sharing_of(cloth).elements, std::vector<std::string>{"triangles"});
  const Part toy = parts_of(cloth)[1], damping = parts_of(cloth)[2];
  EXPECT_EQ(toy.option, "--without toy");
  EXPECT_FALSE(toy.cloth.term<ToyTerm>());
  EXPECT_TRUE(toy.cloth.term<ShearTerm>());
  EXPECT_EQ(damping.cloth.term<ToyTerm>()->kd, 0);
}

// every_model_test.cpp tests its derivatives, momentum, definiteness and damping.
TEST_F(ToyTermTest, IsAmongTheModels) {
  const std::vector<ListedTerm> terms = every_term();
  EXPECT_EQ(std::count_if(terms.begin(), terms.end(),
                          [](const ListedTerm& term) { return term.name == "toy"; }),
            1);
}

// Two families of one kind of element: the springs that are the cloth, and those that bend it.
struct TwoKindsOfSprings : SceneFiles {
  TwoKindsOfSprings()
      : scene(read(cloth_and_time + "[bend]\nmodel = \"springs\"\nk = 3\n[damping]\nbend = 0.2\n",
                   "step05_bend")),
        cloth(scene.cloth) {
    cloth.term<SpringTerm>() = SpringTerm(30, 1);
    cloth.springs.elements = {make_spring(0, 8, 1.2), make_spring(1, 5, 0.4, 0.7)};
    x = scene.start.x + random.vector(int(scene.start.x.size()), 0.2);
    v = random.vector(int(x.size()), 2);
  }
  template <class T>
  Cloth without() const {
    Cloth one = cloth;
    one.term<T>().reset();
    return one;
  }

  Random random{61};
  Scene scene;
  Cloth cloth;
  VecX x, v;
};

TEST_F(TwoKindsOfSprings, HaveColumnsOfTheirOwn) {
  const TermEnergies both = elastic_energies(cloth, x);
  ASSERT_EQ(both.size(), 2u);
  EXPECT_EQ(both[0].first, "spring");
  EXPECT_EQ(both[1].first, "bend");
  EXPECT_EQ(both[0], elastic_energies(without<SpringBend>(), x)[0]);
  EXPECT_EQ(both[1], elastic_energies(without<SpringTerm>(), x)[0]);
  EXPECT_GT(both[0].second, 0.01);
  EXPECT_GT(both[1].second, 0.01);
  EXPECT_NE(both[0].second, both[1].second);
}

TEST_F(TwoKindsOfSprings, HaveDampingOfTheirOwn) {
  EXPECT_EQ(cloth.term<SpringTerm>()->kd, 1);
  EXPECT_EQ(cloth.term<SpringBend>()->kd, 0.2);
  const Cloth springs = without<SpringBend>(), bend = without<SpringTerm>();
  const VecX d = Assembly(cloth).damping(x, v), d_springs = Assembly(springs).damping(x, v),
             d_bend = Assembly(bend).damping(x, v);
  EXPECT_GT(d_springs.norm(), 0.01);
  EXPECT_GT(d_bend.norm(), 0.01);
  EXPECT_LT(relative(d, d_springs + d_bend), 1e-13);
  cloth.term<SpringTerm>()->kd = 0;
  EXPECT_LT(relative(Assembly(cloth).damping(x, v), d_bend), 1e-13);
}

TEST_F(TwoKindsOfSprings, AddUpAndCanBeLeftOutOneByOne) {
  const Cloth springs = without<SpringBend>(), bend = without<SpringTerm>();
  EXPECT_LT(relative(Assembly(cloth).f(x), Assembly(springs).f(x) + Assembly(bend).f(x)), 1e-13);
  EXPECT_LT(relative(Assembly(cloth).K(x), Assembly(springs).K(x) + Assembly(bend).K(x)), 1e-13);
  const std::vector<Part> parts = parts_of(cloth);
  ASSERT_EQ(names_of_parts(cloth), (std::vector<std::string>{"spring", "bend", "damping of spring",
                                                             "damping of bend", "all damping"}));
  EXPECT_TRUE(parts[0].cloth.springs.elements.empty());
  EXPECT_EQ(parts[0].cloth.bend_springs.elements.size(), cloth.bend_springs.elements.size());
  EXPECT_EQ(parts[1].cloth.springs.elements.size(), 2u);
  EXPECT_TRUE(parts[1].cloth.bend_springs.elements.empty());
}

}  // namespace terms_test
