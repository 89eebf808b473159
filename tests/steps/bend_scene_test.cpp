// Scenes with [bend]: which elements each model makes, with which k, and at which angles they rest.
#include <numbers>

#include "support/scene_files.h"

namespace bend_scene_test {

constexpr double pi = std::numbers::pi;
constexpr const char* model_names[] = {"dihedral", "bridson", "quadratic", "springs"};

// 2 × 2 cells have 16 edges, 8 of them inside. 7 lines, and one empty one.
const std::string grid = cloth_and_time + "\n";

std::string with_mesh(const std::string& bend) {
  return "[cloth]\nmesh = \"m.obj\"\ndensity = 0.2\n[time]\nh = 0.001\nend = 1.0\n[bend]\n" + bend;
}

// A unit square, folded by a right angle about its diagonal from (1, 0) to (0, 1): the corner (1,
// 1) points to the back, so that θ is π/2.
const std::string folded_square =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0.5 0.5 -0.70710678118654752\n"
    "vt 0 0\nvt 1 0\nvt 0 1\nvt 1 1\n";
const std::string in_space = folded_square + "f 1 2 3\nf 2 4 3\n";
const std::string laid_flat = folded_square + "f 1/1 2/2 3/3\nf 2/2 4/4 3/3\n";
const std::string half_laid_flat = folded_square + "f 1/1 2/2 3/3\nf 2 4 3\n";

class BendScene : public SceneFiles {
 protected:
  Cloth cloth(const std::string& text, const Overrides& overrides = {}) const {
    return read(text, "step05_bend", overrides).cloth;
  }
  std::string refused(const std::string& text, const std::string& program = "step05_bend") const {
    return refusal(text, program);
  }
  double rest_angle(const std::string& mesh, const std::string& model) const {
    write("m.obj", mesh);
    const Hinges hinges = cloth(with_mesh("k = 1\nmodel = \"" + model + "\"")).hinges;
    EXPECT_EQ(hinges.elements.size(), 1u);
    return hinges.elements.at(0).rest_angle;
  }
};

size_t elements(const Cloth& cloth) {
  return cloth.hinges.elements.size() + cloth.quadratic_hinges.elements.size() +
         cloth.bend_springs.elements.size();
}

TEST_F(BendScene, EachModelHasTheElementsOfItsFamilyAndNoOthers) {
  const auto with = [&](const std::string& model) {
    const Cloth made = cloth(grid + "[bend]\nk = 0.5\n" + model);
    EXPECT_EQ(elements(made), 8u) << model;
    EXPECT_TRUE(made.triangles.elements.empty());
    return made;
  };
  for (const std::string model : {"", "model = \"dihedral\"", "model = \"bridson\""}) {
    const Hinges hinges = with(model).hinges;
    EXPECT_EQ(hinges.elements.size(), 8u) << model;
    const bool bridson = model.find("bridson") != model.npos;
    EXPECT_EQ(hinges.term<DihedralBend>().has_value(), !bridson);
    EXPECT_EQ(hinges.term<BridsonBend>().has_value(), bridson);
    EXPECT_EQ(bridson ? hinges.term<BridsonBend>()->k : hinges.term<DihedralBend>()->k, 0.5);
  }
  const QuadraticHinges quadratic = with("model = \"quadratic\"").quadratic_hinges;
  EXPECT_EQ(quadratic.elements.size(), 8u);
  EXPECT_EQ(quadratic.term<QuadraticBend>()->k, 0.5);
  const BendSprings springs = with("model = \"springs\"").bend_springs;
  EXPECT_EQ(springs.elements.size(), 8u);
  EXPECT_EQ(springs.term<SpringBend>()->k, 0.5);
  EXPECT_EQ(springs.term<SpringBend>()->kd, 0);
  EXPECT_EQ(SpringBend::info.table, "bend") << "its column in the log";
}

TEST_F(BendScene, WithoutTheTableNothingBends) {
  const Cloth absent = cloth(grid), left_out = cloth(grid +
                                                         "[bend]\nk = 1\n[stretch]\nk = 1\n"
                                                         "[damping]\nstretch = 2\nbend = 3\n",
                                                     {.without = {"bend"}});
  for (const Cloth& c : {absent, left_out}) {
    EXPECT_EQ(c.hinges.elements.capacity(), 0u);
    EXPECT_EQ(c.quadratic_hinges.elements.capacity(), 0u);
    EXPECT_EQ(c.bend_springs.elements.capacity(), 0u);
    EXPECT_FALSE(c.hinges.acts() || c.quadratic_hinges.acts() || c.bend_springs.acts());
  }
  EXPECT_EQ(left_out.triangles.term<StretchTerm>()->kd, 2)
      << "of all damping, only that of [bend] is gone";
}

// math/hinge.h says what k each model needs for a modulus.
TEST_F(BendScene, KFollowsFromTheModulusOfEachModel) {
  const auto with = [&](const std::string& model) {
    return cloth(grid + "[bend]\nB = 0.06\nmodel = \"" + model + "\"");
  };
  EXPECT_DOUBLE_EQ(with("dihedral").term<DihedralBend>()->k, 0.06);
  EXPECT_DOUBLE_EQ(with("bridson").term<BridsonBend>()->k, 0.24);
  EXPECT_DOUBLE_EQ(with("quadratic").term<QuadraticBend>()->k, 0.02);
  EXPECT_EQ(cloth(grid + "[bend]\nB = 0").term<DihedralBend>()->k, 0);
}

TEST_F(BendScene, DampingReachesEveryModel) {
  for (const std::string model : model_names) {
    const Cloth c =
        cloth(grid + "[bend]\nk = 1\nmodel = \"" + model + "\"\n[damping]\nbend = 0.25");
    for_each_term(c, [&](const auto& term) { EXPECT_TRUE(!term || term->kd == 0.25) << model; });
    EXPECT_TRUE(damped(c)) << model;
    EXPECT_FALSE(damped(cloth(grid + "[bend]\nk = 1\nmodel = \"" + model + "\""))) << model;
  }
}

TEST_F(BendScene, AGridRestsFlatHoweverItStarts) {
  for (const Hinge& hinge :
       cloth(grid + "[bend]\nk = 1\n[start]\nshape = \"hanging\"").hinges.elements)
    EXPECT_EQ(hinge.rest_angle, 0);
}

TEST_F(BendScene, AMeshRestsAtItsAnglesInSpaceAndFlatWhereTextureCoordinatesLayIt) {
  for (const char* model : {"dihedral", "bridson"}) {
    EXPECT_NEAR(rest_angle(in_space, model), pi / 2, 1e-15);
    EXPECT_EQ(rest_angle(laid_flat, model), 0);
    EXPECT_NEAR(rest_angle(half_laid_flat, model), pi / 2, 1e-15)
        << "flat only where both faces are";
  }
}

TEST_F(BendScene, AnglesAtRestAreThoseOfTheMeshAndNotOfTheStart) {
  write("m.obj", in_space);
  write("start.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n");
  const Scene scene = read(with_mesh("k = 1\n[start]\npositions = \"start.obj\""), "step05_bend");
  EXPECT_NEAR(scene.cloth.hinges.elements.at(0).rest_angle, pi / 2, 1e-15);
  EXPECT_EQ(scene.start.x.tail<3>(), Vec3(1, 1, 0));
}

TEST_F(BendScene, ModelsThatRestFlatNeedTextureCoordinatesOnEveryFace) {
  for (const std::string model : {"quadratic", "springs"}) {
    const std::string scene = with_mesh("k = 1\nmodel = \"" + model + "\"");
    write("m.obj", laid_flat);
    EXPECT_EQ(elements(cloth(scene)), 1u);
    for (const std::string& mesh : {in_space, half_laid_flat}) {
      write("m.obj", mesh);
      expect_says(refused(scene), {"scene.toml:9: [bend] model = '" + model + "' is not valid: ",
                                   "faces without texture coordinates", "dihedral or bridson"});
    }
  }
}

TEST_F(BendScene, BadValuesAreRefusedWithWhatIsValid) {
  const auto bend = [&](const std::string& keys) { return refused(grid + "[bend]\n" + keys); };
  const std::string line = "scene.toml:10: [bend] ";
  expect_says(bend("model = \"cubic\"\nk = 1"),
              {line + "model = 'cubic'", "Valid are dihedral, bridson, quadratic, springs"});
  expect_says(bend("model = \"quadratik\"\nk = 1"), {line, "did you mean \"quadratic\"?"});
  expect_says(bend("model = 3\nk = 1"), {line + "model = 3", "Valid are dihedral"});
  expect_says(bend("B = 1\nk = 1"), {line + "B = 1", "take out one of the two"});
  expect_says(bend("B = 1\nmodel = \"springs\""),
              {line + "B = 1", "springs have no bending modulus", "k in N/m"});
  for (const std::string key : {"k", "B"})
    for (const std::string value : {"-1", "nan", "inf", "\"stiff\"", "[1]"})
      expect_says(bend(key + " = " + value), {line + key + " = ", "a number from 0 to 1e30"});
  expect_says(bend("k = 1\nangle = 2"),
              {"scene.toml:11: [bend] has no key angle", "Valid are model, k, B"});
}

TEST_F(BendScene, NeitherKNorBIsRefusedNamingBoth) {
  for (const std::string keys : {"", "model = \"bridson\""})
    expect_says(refused(grid + "[bend]\n" + keys),
                {"scene.toml:9: [bend] needs k = a number from 0 to 1e30, or B, the modulus"});
}

TEST_F(BendScene, DampingWithoutTheTableIsRefusedWithWhatTheStepKnows) {
  const std::string scene = grid + "[stretch]\nk = 1\n[damping]\nbend = 1";
  expect_says(refused(scene),
              {"scene.toml:12: [damping] bend = 1", "no [bend] to damp; add [bend]"});
  for (const std::string program : {"step02_damping", "step03_implicit", "step04_cg"}) {
    EXPECT_EQ(refused(scene, program),
              "scene.toml:12: " + program +
                  " does not model [bend]; step05_bend does. --without bend runs the scene without "
                  "it");
    EXPECT_FALSE(read(scene, program, {.without = {"bend"}}).cloth.hinges.acts());
  }
  EXPECT_EQ(refused(grid + "[damping]\nbent = 1", "step04_cg"),
            "scene.toml:10: [damping] has no key bent; Valid are stretch, shear, membrane, spring");
  expect_says(refused(grid + "[damping]\nbent = 1"),
              {"scene.toml:10: [damping] has no key bent; did you mean \"bend\"? "});
}

}  // namespace bend_scene_test
