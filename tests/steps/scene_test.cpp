// Reading a scene: its defaults, its tables, the start of the cloth, and the changes of the command
// line.
#include "scene/velocities.h"
#include "support/scene_files.h"

namespace scene_test {

using SceneTest = SceneFiles;

const std::string all_tables =
    cloth_and_time +
    "[gravity]\ng = 9.81\n[stretch]\nk = 1000\n[shear]\nk = 500.5\n[damping]\nstretch = 0.02\n"
    "shear = 0.01\n[camera]\neye = [0, 1, 4]\nstill = 0.5\n";

TEST_F(SceneTest, WithoutATableNothingOfItExists) {
  const Scene scene = read(cloth_and_time);
  EXPECT_FALSE(scene.cloth.gravity);
  EXPECT_FALSE(scene.cloth.term<StretchTerm>());
  EXPECT_FALSE(scene.cloth.term<ShearTerm>());
  EXPECT_EQ(scene.cloth.triangles.elements.capacity(), 0u);
  EXPECT_EQ(scene.cloth.springs.elements.capacity(), 0u);
  EXPECT_EQ(scene.cloth.pins.capacity(), 0u);
  EXPECT_FALSE(scene.camera.eye || scene.camera.target || scene.camera.still);
}

TEST_F(SceneTest, EveryTableArrivesWhereTheStepsReadIt) {
  const Scene scene = read(all_tables);
  EXPECT_EQ(*scene.cloth.gravity, Vec3(0, -9.81, 0));
  const Triangles& triangles = scene.cloth.triangles;
  EXPECT_EQ(triangles.elements.size(), 8u);
  EXPECT_EQ(StretchTerm::info.table, "stretch");
  EXPECT_EQ(ShearTerm::info.table, "shear");
  EXPECT_EQ(triangles.term<StretchTerm>()->k, 1000);
  EXPECT_EQ(triangles.term<ShearTerm>()->k, 500.5);
  EXPECT_EQ(triangles.term<StretchTerm>()->kd, 0.02);
  EXPECT_EQ(triangles.term<ShearTerm>()->kd, 0.01);
  EXPECT_EQ(*scene.camera.eye, Vec3(0, 1, 4));
  EXPECT_FALSE(scene.camera.target);
  EXPECT_EQ(*scene.camera.still, 0.5);
  EXPECT_EQ(scene.file, directory / "scene.toml");
}

TEST_F(SceneTest, DefaultsAreTwelveFramesTheDiagonalsOfTheNotesAndAFlatClothAtRest) {
  const Scene scene = read(cloth_and_time);
  const Mesh grid = make_grid({1, 1}, {2, 2}, Diagonals::same);
  EXPECT_EQ(scene.time.frames, 12);
  EXPECT_EQ(scene.mesh.faces, grid.faces);
  EXPECT_EQ(scene.start.x, grid.x);
  EXPECT_TRUE(scene.start.v.isZero(0));
  EXPECT_EQ(scene.start.v.size(), grid.x.size());
}

TEST_F(SceneTest, OneTermIsDampedWithoutTheOther) {
  const Scene scene =
      read(cloth_and_time + "[stretch]\nk = 1\n[shear]\nk = 1\n[damping]\nshear = 2");
  EXPECT_EQ(scene.cloth.term<StretchTerm>()->kd, 0);
  EXPECT_EQ(scene.cloth.term<ShearTerm>()->kd, 2);
}

TEST_F(SceneTest, WholeNumbersAreNumbersAndZeroGravityAndStiffnessAreAllowed) {
  const Scene scene =
      read(with_line(6, "h = 1", cloth_and_time + "[gravity]\ng = 0\n[shear]\nk = 0"));
  EXPECT_EQ(scene.time.h, 1);
  EXPECT_TRUE(scene.cloth.gravity->isZero(0));
  EXPECT_EQ(scene.cloth.term<ShearTerm>()->k, 0);
}

TEST_F(SceneTest, TheNumberOfStepsForgivesRoundingAndCoversTheEnd) {
  EXPECT_EQ((Time{0.001, 1.0, 12}).steps(), 1000);
  EXPECT_EQ((Time{0.1, 0.3, 12}).steps(), 3) << "0.3 / 0.1 is 2.9999999999999996";
  EXPECT_EQ((Time{0.3, 1.0, 12}).steps(), 4) << "the last step goes beyond the end";
  EXPECT_EQ((Time{2.0, 1.0, 12}).steps(), 1);
  EXPECT_EQ((Time{1e-9, 1.0, 12}).steps(), 1000000000);
}

TEST_F(SceneTest, FramesAreSpreadEvenlyOverTheSteps) {
  const Time time{0.3, 3.0, 4};
  EXPECT_EQ(time.step_of_frame(0), 0);
  EXPECT_EQ(time.step_of_frame(1), 3) << "2.5 rounded";
  EXPECT_EQ(time.step_of_frame(2), 5);
  EXPECT_EQ(time.step_of_frame(4), time.steps());
  EXPECT_EQ((Time{1e-9, 1.0, 1000}).step_of_frame(999), 999000000);
}

TEST_F(SceneTest, PinsAreCornersEdgesAndNumbersAndEachVertexOnce) {
  const auto pins = [&](const std::string& list) {
    std::vector<int> vertices;
    for (const Pin& pin : read(with_line(4, "density = 1\npins = " + list)).cloth.pins) {
      EXPECT_TRUE(pin.holds_all());
      EXPECT_TRUE(pin.velocity.isZero(0));
      vertices.push_back(pin.vertex);
    }
    return vertices;
  };
  using Pins = std::vector<int>;
  EXPECT_EQ(pins("[\"bottom left\"]"), (Pins{0}));
  EXPECT_EQ(pins("[\"bottom right\"]"), (Pins{2}));
  EXPECT_EQ(pins("[\"top left\"]"), (Pins{6}));
  EXPECT_EQ(pins("[\"top right\"]"), (Pins{8}));
  EXPECT_EQ(pins("[\"bottom\"]"), (Pins{0, 1, 2}));
  EXPECT_EQ(pins("[\"top\"]"), (Pins{6, 7, 8}));
  EXPECT_EQ(pins("[\"left\"]"), (Pins{0, 3, 6}));
  EXPECT_EQ(pins("[\"right\"]"), (Pins{2, 5, 8}));
  EXPECT_EQ(pins("[\"top\", 4, \"left\", 4, 8]"), (Pins{0, 3, 4, 6, 7, 8}));
  EXPECT_EQ(pins("[]"), Pins{});
}

TEST_F(SceneTest, AHangingClothIsUprightWithAWrinkleOfAMillimetreAndNoMirrorSymmetry) {
  const Scene scene =
      read(with_line(3, "cells = [10, 10]", cloth_and_time) + "[start]\nshape = \"hanging\"\n");
  double largest = 0;
  for (int i = 0; i < 121; ++i) {
    const Vec3 x = scene.start.x.segment<3>(3 * i);
    const Vec3 mirrored = scene.start.x.segment<3>(3 * (i / 11 * 11 + 10 - i % 11));
    EXPECT_EQ(x.x(), scene.mesh.x[3 * i]);
    EXPECT_EQ(x.y(), -scene.mesh.x[3 * i + 2]);
    EXPECT_GT(std::abs(x.z()), 1e-6) << "vertex " << i << " is in the plane";
    if (i % 11 % 5 != 0) {  // neither in the middle nor at the edges
      EXPECT_GT(std::abs(std::abs(x.z()) - std::abs(mirrored.z())), 1e-6) << i;
    }
    largest = std::max(largest, std::abs(x.z()));
  }
  EXPECT_LE(largest, 1e-3);
  EXPECT_GT(largest, 0.8e-3);
}

TEST_F(SceneTest, VelocityAndSpinAddUpAndGiveTheseMomenta) {
  const Scene scene = read(with_line(3, "cells = [5, 3]\ndiagonals = \"alternating\"") +
                           "[start]\nvelocity = [1, 2, 3]\nspin = [0, 6, 0]\n");
  const Cloth& cloth = scene.cloth;
  Vec3 momentum = Vec3::Zero(), angular = Vec3::Zero(), center = Vec3::Zero();
  double inertia = 0;  // about the vertical axis through the centre of mass
  for (int i = 0; i < cloth.vertices(); ++i)
    center += cloth.mass[3 * i] * scene.start.x.segment<3>(3 * i) / 0.2;
  for (int i = 0; i < cloth.vertices(); ++i) {
    const double mass = cloth.mass[3 * i];
    const Vec3 arm = scene.start.x.segment<3>(3 * i) - center, v = scene.start.v.segment<3>(3 * i);
    momentum += mass * v;
    angular += mass * arm.cross(v);
    inertia += mass * (arm.x() * arm.x() + arm.z() * arm.z());
  }
  EXPECT_LT((momentum - 0.2 * Vec3(1, 2, 3)).norm(), 1e-15);
  EXPECT_LT((angular - inertia * Vec3(0, 6, 0)).norm(), 1e-15);
}

TEST_F(SceneTest, PinnedVerticesStartAtRest) {
  const Scene scene = read(with_line(4, "density = 1\npins = [0, 4]") +
                           "[start]\nvelocity = [1, 1, 1]\nspin = [1, 0, 0]\n");
  for (int i = 0; i < 9; ++i)
    EXPECT_EQ(scene.start.v.segment<3>(3 * i).isZero(0), i == 0 || i == 4) << i;
}

// The smallest scene with these pins, for a step that knows tables of them.
std::string with_pins(const std::string& list) {
  return with_line(4, "density = 1\npins = " + list);
}

Mat3 diagonal(double x, double y, double z) {
  return Vec3(x, y, z).asDiagonal();
}

TEST_F(SceneTest, PinsFixTheAxesOfTheirLettersAndLeaveTheOthersFree) {
  const auto free_of = [&](const std::string& fix) {
    return read(with_pins("[{vertex = 4" + fix + "}]"), "step04_cg").cloth.pins.at(0).S;
  };
  EXPECT_EQ(free_of(", fix = \"x\""), diagonal(0, 1, 1));
  EXPECT_EQ(free_of(", fix = \"y\""), diagonal(1, 0, 1));
  EXPECT_EQ(free_of(", fix = \"z\""), diagonal(1, 1, 0));
  EXPECT_EQ(free_of(", fix = \"xz\""), diagonal(0, 1, 0));
  EXPECT_EQ(free_of(", fix = \"zx\""), diagonal(0, 1, 0));
  EXPECT_EQ(free_of(", fix = \"yz\""), diagonal(1, 0, 0));
  EXPECT_EQ(free_of(", fix = \"zyx\""), diagonal(0, 0, 0));
  EXPECT_EQ(free_of(""), diagonal(0, 0, 0)) << "without fix all directions are held";
}

TEST_F(SceneTest, PinsFixOneDirectionWhateverItsLength) {
  const Vec3 p = Vec3(2, -1, 2) / 3, q = Vec3(1, 2, 0).normalized();  // q is across p
  for (const char* fix : {"[2, -1, 2]", "[2e-200, -1e-200, 2e-200]", "[2e29, -1e29, 2e29]"}) {
    const std::string list = std::string("[{vertex = 4, fix = ") + fix + "}]";
    const Mat3 S = read(with_pins(list), "step04_cg").cloth.pins.at(0).S;
    EXPECT_LT((S * p).norm(), 1e-15) << fix;
    EXPECT_LT((S * q - q).norm(), 1e-15) << fix;
    EXPECT_LT((S - (Mat3::Identity() - p * p.transpose())).norm(), 1e-15) << fix;
  }
}

TEST_F(SceneTest, PinsThatHoldAllHaveNoInverseMassAndTheOthersHaveTheirs) {
  const Cloth cloth =
      read(with_pins("[1, {vertex = 4}, {vertex = 5, fix = \"xy\"}]"), "step04_cg").cloth;
  ASSERT_EQ(cloth.pins.size(), 3u);
  for (const int vertex : {1, 4})
    EXPECT_TRUE(cloth.inverse_mass.segment<3>(3 * vertex).isZero(0)) << vertex;
  EXPECT_EQ(cloth.inverse_mass[15], 1 / cloth.mass[15]);
}

TEST_F(SceneTest, PinsOfAnEdgeShareWhatItsTableSays) {
  const Scene scene =
      read(with_pins("[8, {vertex = 'left', fix = 'yz', velocity = [0, 0.5, -0.25]}]") +
               "[start]\nvelocity = [1, 2, 3]\n",
           "step04_cg");
  ASSERT_EQ(scene.cloth.pins.size(), 4u);
  for (const int row : {0, 1, 2}) {
    const Pin& pin = scene.cloth.pins[size_t(row)];
    EXPECT_EQ(pin.vertex, 3 * row);
    EXPECT_EQ(pin.S, diagonal(1, 0, 0));
    EXPECT_EQ(pin.velocity, Vec3(0, 0.5, -0.25));
    EXPECT_EQ(scene.start.v.segment<3>(9 * row), Vec3(1, 0.5, -0.25))
        << "it starts with the velocity of its pin, and moves freely along x";
  }
  EXPECT_EQ(scene.cloth.pins[3].vertex, 8);
  EXPECT_TRUE(scene.cloth.pins[3].holds_all());
  EXPECT_EQ(scene.start.v.segment<3>(24), Vec3::Zero());
  EXPECT_EQ(scene.start.v.segment<3>(12), Vec3(1, 2, 3));
}

TEST_F(SceneTest, PinsMoveAlongTheDirectionThatTheyFix) {
  const auto pin = [&](const std::string& velocity) {
    const std::string list = "[{vertex = 4, fix = [1, 2, 2], velocity = " + velocity + "}]";
    return read(with_pins(list), "step04_cg").cloth.pins.at(0);
  };
  EXPECT_LT((pin("[0.1, 0.2, 0.2]").velocity - Vec3(0.1, 0.2, 0.2)).norm(), 1e-15);
  const Pin rounded = pin("[0.1, 0.2, 0.2000001]");
  EXPECT_LT((rounded.velocity - Vec3(0.1, 0.2, 0.2)).norm(), 1e-6);
  EXPECT_LT((rounded.S * rounded.velocity).norm(), 1e-15) << "the free part is removed";
}

TEST_F(SceneTest, PinsNamedTwiceWithTheSameAreOne) {
  const std::string list =
      "[{vertex = 'top'}, 7, {vertex = 8, fix = 'xyz', velocity = [0, 0, 0]}, "
      "{vertex = 0, fix = 'x'}, {vertex = 0, fix = [3, 0, 0]}, "
      "{vertex = 1, fix = [1, 2, 3]}, {vertex = 1, fix = [-10, -20, -30]}]";
  std::vector<int> vertices;
  for (const Pin& pin : read(with_pins(list), "step04_cg").cloth.pins)
    vertices.push_back(pin.vertex);
  EXPECT_EQ(vertices, (std::vector<int>{0, 1, 6, 7, 8}));
}

TEST_F(SceneTest, TheFilesOfARunStartAnotherOneToTheLastDigit) {
  const Scene scene = read(cloth_and_time);
  const VecX x = VecX::Random(27), v = 1e-7 * VecX::Random(27);
  write_obj(directory / "final.obj", scene.mesh, x);
  write_velocities(directory / "final.csv", v);
  const Scene restarted =
      read(cloth_and_time + "[start]\npositions = \"final.obj\"\nvelocities = \"final.csv\"\n");
  EXPECT_LE((restarted.start.x - x).cwiseAbs().maxCoeff(), 1e-15);
  EXPECT_EQ(restarted.start.v, v);
  EXPECT_EQ(restarted.mesh.x, scene.mesh.x);
}

TEST_F(SceneTest, AMeshIsFoundBesideTheSceneAndStartsAsItsFileHasIt) {
  write("m.obj", "v 0 5 0\nv 2 5 0\nv 0 5 1\nf 1 2 3\n");
  const Scene scene = read(
      "[cloth]\nmesh = \"m.obj\"\ndensity = 3\npins = [1]\n[time]\nh = 1\nend = 1\n[shear]\nk = 1");
  EXPECT_EQ(scene.start.x, scene.mesh.x);
  EXPECT_EQ(scene.start.x[1], 5);
  EXPECT_DOUBLE_EQ(scene.cloth.mass[0], 1);
  EXPECT_EQ(scene.cloth.inverse_mass.segment<3>(3), Vec3::Zero());
  EXPECT_EQ(scene.cloth.triangles.elements.size(), 1u);
}

TEST_F(SceneTest, TablesTakenOutAreNotModelledAndATermGoesWithItsDamping) {
  const Scene bare = read(all_tables, "step02", {.without = {"damping", "gravity", "bend"}});
  EXPECT_EQ(bare.cloth.term<StretchTerm>()->kd, 0);
  EXPECT_FALSE(bare.cloth.gravity);
  const Scene no_shear = read(all_tables, "step02", {.without = {"shear"}});
  EXPECT_FALSE(no_shear.cloth.term<ShearTerm>());
  EXPECT_EQ(no_shear.cloth.term<StretchTerm>()->kd, 0.02);
  const Scene first = read(all_tables, "step01_explicit", {.without = {"damping"}});
  EXPECT_EQ(first.cloth.term<StretchTerm>()->kd, 0);
}

TEST_F(SceneTest, TheCommandLineReplacesTimeAndCells) {
  const Scene scene = read(with_line(3, "cells = [4, 2]", all_tables), "step02",
                           {.h = 0.01, .end = 0.25, .frames = 5, .cells = 6});
  EXPECT_EQ(scene.time.h, 0.01);
  EXPECT_EQ(scene.time.end, 0.25);
  EXPECT_EQ(scene.time.frames, 5);
  EXPECT_EQ(scene.mesh.vertices(), 7 * 4) << "cells keep their shape";
  EXPECT_EQ(*scene.camera.still, 0.25) << "the still of a shortened run is its end";
  EXPECT_EQ(*read(scene.effective).camera.still, 0.25) << "run.toml makes the same run";
}

TEST_F(SceneTest, ASettingReplacesAValueOrMakesATable) {
  const Scene scene = read(all_tables, "step05_bend",
                           {.set = {"stretch.k=1e4", "time.end=0.25", "bend.model=quadratic",
                                    "bend.k=1", "cloth.pins=[\"top\"]"}});
  EXPECT_EQ(scene.cloth.term<StretchTerm>()->k, 1e4);
  EXPECT_EQ(scene.cloth.term<StretchTerm>()->kd, 0.02) << "the rest of the table stays";
  EXPECT_TRUE(scene.cloth.term<QuadraticBend>());
  EXPECT_EQ(*scene.camera.still, 0.25) << "the still of a shortened run is its end";
  EXPECT_EQ(scene.cloth.pins.size(), scene.cloth.grid->cells[0] + 1u);

  const Scene membrane =
      read(cloth_and_time, "step01", {.set = {"membrane.model=stvk", "membrane.E=5"}});
  EXPECT_NE(membrane.effective.find("[membrane]\nE = 5\nmodel = 'stvk'"), std::string::npos)
      << membrane.effective;
}

TEST_F(SceneTest, AStillAtTheVeryEndAndWindowsLineEndsAreAccepted) {
  EXPECT_EQ(*read(cloth_and_time + "[camera]\nstill = 1\n").camera.still, 1);
  std::string windows;
  for (const char c : all_tables) windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
  EXPECT_EQ(read(windows).cloth.term<StretchTerm>()->k, 1000);
}

TEST_F(SceneTest, AProgramThatIsNoStepIsAnErrorOfTheProgrammer) {
  EXPECT_THROW(read(cloth_and_time, "study"), std::invalid_argument);
}

}  // namespace scene_test
