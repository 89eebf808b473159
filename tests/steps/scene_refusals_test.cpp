// Every refusal of a scene: one line with the file, the line, and what would be valid.
#include <algorithm>
#include <limits>

#include "support/scene_files.h"

namespace scene_refusals_test {

using SceneRefusals = SceneFiles;

// 8 lines come before what is added.
const std::string scene = cloth_and_time + "\n";

TEST_F(SceneRefusals, AMissingFileIsNamed) {
  expect_says(message([&] { read_scene(directory / "none.toml", "step01"); }),
              {"none.toml: there is no such file"});
}

TEST_F(SceneRefusals, ADirectoryIsNoScene) {
  std::filesystem::create_directory(directory / "d");
  expect_says(message([&] { read_scene(directory / "d", "step01"); }),
              {"d: ", "directory", "file"});
}

TEST_F(SceneRefusals, MalformedTomlIsOneLineWithItsLineNumber) {
  expect_says(refusal("[cloth]\nsize = [1.0,\n= 3\n"), {"scene.toml:3: "});
  expect_says(refusal(scene + "[time]\n"), {"scene.toml:9: ", "time"});
  expect_says(refusal(with_line(6, "h = ")), {"scene.toml:6: "});
}

TEST_F(SceneRefusals, ATableOfALaterStepIsNamedWithItsStepAndTheWayRoundIt) {
  EXPECT_EQ(refusal(scene + "[damping]\nstretch = 1", "step01_explicit"),
            "scene.toml:9: step01_explicit does not model [damping]; step02_damping does. "
            "--without damping runs the scene without it");
  EXPECT_EQ(refusal(scene + "[bend]\nk = 1", "step04_cg"),
            "scene.toml:9: step04_cg does not model [bend]; step05_bend does. "
            "--without bend runs the scene without it");
}

TEST_F(SceneRefusals, AnUnknownTableIsNamedWithTheValidOnesAndTheNearest) {
  expect_says(
      refusal(scene + "[strech]\nk = 1"),
      {"scene.toml:9: ", "[strech]", "did you mean \"stretch\"?", "cloth, gravity, stretch"});
  const std::string far = refusal(scene + "[wind]\nk = 1", "step01");
  expect_says(far, {"scene.toml:9: ", "[wind]", "Valid are cloth"});
  EXPECT_EQ(far.find("did you mean"), far.npos);
  EXPECT_EQ(far.find("damping"), far.npos) << "step01 does not teach damping";
}

TEST_F(SceneRefusals, AnUnknownKeyIsNamedWithTheValidOnesAndTheNearest) {
  expect_says(refusal(with_line(3, "cell = [2, 2]")),
              {"scene.toml:3: ", "[cloth] has no key cell", "did you mean \"cells\"?", "density"});
  for (const char* table : {"gravity", "stretch", "shear", "damping", "start", "camera"})
    expect_says(refusal(scene + "[" + table + "]\nzzzzz = 1"),
                {"scene.toml:10: ", std::string("[") + table + "] has no key zzzzz", "Valid are "});
  expect_says(refusal(scene + "dt = 1"),
              {"scene.toml:9: ", "[time] has no key dt", "h, end, frames"});
}

TEST_F(SceneRefusals, AKeyOutsideOfTheTablesAndATableThatIsNoneAreRefused) {
  expect_says(refusal("h = 1\n" + scene), {"scene.toml:1: ", "key h outside", "Valid are cloth"});
  expect_says(refusal("stretch = 1\n" + scene), {"scene.toml:1: ", "one table, [stretch]"});
  expect_says(refusal(scene + "[[shear]]\nk = 1"), {"scene.toml:9: ", "one table, [shear]"});
}

TEST_F(SceneRefusals, ClothAndTimeAreRequired) {
  expect_says(refusal("[time]\nh = 1\nend = 1"), {"scene.toml: ", "[cloth] is missing"});
  expect_says(refusal("[cloth]\nsize = [1, 1]"), {"scene.toml: ", "[time] is missing"});
}

TEST_F(SceneRefusals, AMissingKeyIsNamedWithWhatItWouldBe) {
  expect_says(refusal(with_line(2, "")), {"scene.toml:1: ", "[cloth] needs size", "mesh"});
  expect_says(refusal(with_line(3, "")), {"scene.toml:1: ", "needs cells = two whole numbers"});
  expect_says(refusal(with_line(4, "")),
              {"scene.toml:1: ", "needs density = a number from 1e-30 to 1e30"});
  expect_says(refusal(with_line(6, "")),
              {"scene.toml:5: ", "[time] needs h = a number from 1e-30"});
  expect_says(refusal(with_line(7, "")),
              {"scene.toml:5: ", "[time] needs end = a number from 1e-30"});
  expect_says(refusal(scene + "[gravity]"),
              {"scene.toml:9: ", "needs g = a number from 0 to 1e30"});
  expect_says(refusal(scene + "[stretch]"),
              {"scene.toml:9: ", "needs k = a number from 0 to 1e30"});
}

struct BadLine {
  int line;
  std::string text, valid;
};

TEST_F(SceneRefusals, EveryValueOutOfRangeOrOfAnotherTypeIsShownWithWhatIsValid) {
  const BadLine bad_lines[] = {
      {2, "size = [0, 1]", "two numbers from 1e-30 to 1e30"},
      {2, "size = [1, nan]", "two numbers from 1e-30 to 1e30"},
      {2, "size = [1, 1, 1]", "two numbers from 1e-30 to 1e30"},
      {2, "size = 1", "two numbers from 1e-30 to 1e30"},
      {2, "size = [\"a\", 1]", "two numbers from 1e-30 to 1e30"},
      {2, "size = [1e-14, 1]", "no area"},
      {3, "cells = [0, 1]", "two whole numbers from 1"},
      {3, "cells = [2.0, 2.0]", "two whole numbers from 1"},
      {3, "cells = [2147483648, 1]", "two whole numbers from 1 to 2147483647"},
      {4, "density = 0", "a number from 1e-30 to 1e30"},
      {4, "density = -1", "a number from 1e-30 to 1e30"},
      {4, "density = inf", "a number from 1e-30 to 1e30"},
      {4, "density = \"heavy\"", "a number from 1e-30 to 1e30"},
      {4, "density = 1\ndiagonals = \"altern\"", "Valid are same, alternating"},
      {4, "density = 1\ndiagonals = 3", "Valid are same, alternating"},
      {6, "h = 0", "a number from 1e-30 to 1e30"},
      {6, "h = -0.1", "a number from 1e-30 to 1e30"},
      {6, "h = nan", "a number from 1e-30 to 1e30"},
      {6, "h = true", "a number from 1e-30 to 1e30"},
      {7, "end = 1e12", "1e9 steps; take a larger h or a smaller end"},
      {7, "end = 0", "a number from 1e-30 to 1e30"},
      {7, "end = inf", "a number from 1e-30 to 1e30"},
      {7, "end = 1\nframes = 0", "a whole number from 1"},
      {7, "end = 1\nframes = 12.0", "a whole number from 1"},
      {8, "[gravity]\ng = -9.81", "a number from 0 to 1e30"},
      {8, "[gravity]\ng = [0, 0, 1]", "a number from 0 to 1e30"},
      {8, "[stretch]\nk = -1", "a number from 0 to 1e30"},
      {8, "[stretch]\nk = inf", "a number from 0 to 1e30"},
      {8, "[shear]\nk = -1", "a number from 0 to 1e30"},
      {8, "[stretch]\nk = 1\n[damping]\nstretch = -1", "a number from 0 to 1e30"},
      {8, "[shear]\nk = 1\n[damping]\nshear = nan", "a number from 0 to 1e30"},
      {8, "[camera]\neye = [1, 2]", "three numbers"},
      {8, "[camera]\ntarget = [1, 2, inf]", "three numbers"},
      {8, "[camera]\neye = [1, 2, 3]\ntarget = [1, 2, 3]", "another point than target"},
      {8, "[camera]\neye = [5e-324, 2, 3]\ntarget = [0, 2, 3]", "another point than target"},
      {8, "[camera]\nstill = -1", "a number from 0 to 1e30"},
      {8, "[camera]\nstill = 1.5", "from 0 to the end of [time]"},
      {8, "[start]\nvelocity = 3", "three numbers"},
      {8, "[start]\nspin = [0, 6]", "three numbers"},
      {8, "[start]\nshape = \"round\"", "Valid are flat, hanging"},
  };
  for (const BadLine& bad : bad_lines) {
    const std::string said = refusal(with_line(bad.line, bad.text, scene));
    const bool eye = bad.text.find("eye") != bad.text.npos;  // refused above the last line
    const long below = std::count(bad.text.begin(), bad.text.end(), '\n');
    const long line = bad.line + (eye ? 1 : below);
    expect_says(said, {"scene.toml:" + std::to_string(line) + ": [", bad.valid});
  }
}

TEST_F(SceneRefusals, DampingOfAnAbsentTermIsRefused) {
  expect_says(refusal(scene + "[stretch]\nk = 1\n[damping]\nstretch = 1\nshear = 1"),
              {"scene.toml:13: ", "[damping] shear", "no [shear]", "add [shear], or take out"});
}

TEST_F(SceneRefusals, AClothIsAGridOrAMeshAndNotBoth) {
  write("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  expect_says(refusal(with_line(3, "mesh = \"m.obj\"")),
              {"scene.toml:2: ", "mesh", "take out one"});
}

TEST_F(SceneRefusals, AMeshThatIsMissingOrNoFileIsNamedInTheLineOfTheScene) {
  const auto mesh = [](const std::string& m) {
    return "[cloth]\nmesh = " + m + "\ndensity = 0.2\n[time]\nh = 1\nend = 1\n";
  };
  expect_says(refusal(mesh("\"no.obj\"")), {"scene.toml:2: ", "no.obj: there is no such file"});
  expect_says(refusal(mesh("\".\"")), {"scene.toml:2: ", "directory, a file is needed"});
  expect_says(refusal(mesh("3")), {"scene.toml:2: ", "name of a file"});
}

TEST_F(SceneRefusals, AGridTooLargeForMemorySaysHowMuchItNeedsAndHowMuchThereIs) {
  expect_says(refusal(with_line(3, "cells = [2147483647, 2147483647]")),
              {"scene.toml:3: ", "2147483647 x 2147483647 cells", "need at least", "MB",
               "this machine has", "fewer cells"});
  expect_says(refusal(with_line(3, "cells = [10000000, 100000]")),
              {"scene.toml:3: ", "MB", "fewer"});
}

TEST_F(SceneRefusals, PinsThatDoNotExistAreNamedWithTheValidOnes) {
  const auto pins = [&](const std::string& list) {
    return refusal(with_line(4, "density = 1\npins = " + list));
  };
  expect_says(pins("[9]"), {"scene.toml:5: ", "pins = 9", "a vertex number from 0 to 8"});
  expect_says(pins("[-1]"), {"scene.toml:5: ", "a vertex number from 0 to 8"});
  expect_says(pins("[1.0]"), {"scene.toml:5: ", "a name or a vertex number from 0 to 8"});
  expect_says(pins("[\"top lef\"]"),
              {"scene.toml:5: ", "did you mean \"top left\"?", "bottom right", "from 0 to 8"});
  expect_says(pins("\"top\""), {"scene.toml:5: ", "a list, like [\"top left\", \"top right\"]"});
}

TEST_F(SceneRefusals, TablesOfPinsAreRefusedWithWhatTheirKeysCanBe) {
  const auto pin = [&](const std::string& keys) {
    return refusal(with_line(4, "density = 1\npins = [\n0, {" + keys + "}]"), "step04_cg");
  };
  const std::string at = "scene.toml:6: [cloth] pin ";
  expect_says(pin("vertex = 9"), {at + "vertex = 9", "a vertex number from 0 to 8"});
  expect_says(pin("vertex = 1.5"), {at + "vertex = 1.5", "a name or a vertex number from 0 to 8"});
  expect_says(pin("vertex = \"tops\""), {at + "vertex = 'tops'", "did you mean \"top\"?"});
  expect_says(pin("fix = \"x\""), {at + "needs vertex = a vertex number or a name"});
  expect_says(pin("vertex = 4, fixx = \"x\""),
              {at + "has no key fixx", "did you mean \"fix\"?", "vertex, fix, velocity"});
  for (const std::string fix : {"''", "'a'", "'xx'", "'xyzx'", "'X'", "'x z'", "[0, 0, 0]",
                                "[1, 0]", "[1, 0, nan]", "['x']", "1", "true"})
    expect_says(pin("vertex = 4, fix = " + fix),
                {at + "fix = ", "letters of x, y and z, each at most once",
                 "the three numbers of one direction that is not zero, like [0, 1, 1]"});
  for (const std::string velocity : {"1", "[1, 2]", "[0, 0, inf]", "'x'"})
    expect_says(pin("vertex = 4, velocity = " + velocity), {at + "velocity = ", "three numbers"});
}

TEST_F(SceneRefusals, PinsCannotMoveWhereTheyHoldNothing) {
  const auto pin = [&](const std::string& keys) {
    return refusal(with_line(4, "density = 1\npins = [{vertex = 4, " + keys + "}]"), "step04_cg");
  };
  const std::string at = "scene.toml:5: [cloth] pin velocity = ",
                    must =
                        "it must lie in the directions that the pin fixes; the part that does is ";
  expect_says(pin("fix = 'y', velocity = [1, 2, 0]"), {at + "[1, 2, 0]", must + "[0, 2, 0]"});
  expect_says(pin("fix = 'xz', velocity = [0, 1e-3, 0]"), {at, must + "[0, 0, 0]"});
  expect_says(pin("fix = [0, 1, 1], velocity = [0, 1, 0]"), {at, must + "[0, 0.5, 0.5]"});
}

TEST_F(SceneRefusals, AVertexThatIsPinnedInTwoWaysIsNamed) {
  const auto pins = [&](const std::string& list) {
    return refusal(with_line(4, "density = 1\npins = [" + list + "]"), "step04_cg");
  };
  const std::string twice = "vertex 8 is already pinned in another way; name it once";
  expect_says(pins("8,\n{vertex = 8, fix = 'x'}"), {"scene.toml:6: [cloth] pins = ", twice});
  expect_says(pins("{vertex = 8, fix = 'x'}, 'top'"), {"[cloth] pins = 'top'", twice});
  expect_says(pins("{vertex = 8, fix = 'x'}, {vertex = 'right', fix = 'y'}"), {twice});
  expect_says(pins("{vertex = 8, velocity = [1, 0, 0]}, {vertex = 8, velocity = [2, 0, 0]}"),
              {twice});
}

TEST_F(SceneRefusals, TablesOfPinsBelongToStep04On) {
  const std::string pinned = with_line(4, "density = 1\npins = [0,\n{vertex = 4}]");
  for (const std::string program : {"step01_explicit", "step02_damping", "step03_implicit"})
    EXPECT_EQ(refusal(pinned, program),
              "scene.toml:6: " + program +
                  " does not model pins with single directions or a velocity; step04_cg does. "
                  "A pin that is only a name or a number runs in every step");
  for (const std::string program : {"step04_cg", "step05_bend"})
    EXPECT_EQ(refusal(pinned, program), "accepted");
}

TEST_F(SceneRefusals, OtherCellsHaveNoPinsOfTheseNumbers) {
  const auto with_cells = [&](const std::string& pins, int cells) {
    return refusal(with_line(4, "density = 1\npins = [\"top\",\n" + pins + "]"), "step04_cg",
                   {.cells = cells});
  };
  for (const char* pin : {"4", "{vertex = 4, fix = 'x'}"}) {
    for (const int cells : {1, 4})
      expect_says(with_cells(pin, cells),
                  {"scene.toml:6: --cells " + std::to_string(cells) + ": pin 4 is the number of a ",
                   "named corners and edges"});
    EXPECT_EQ(with_cells(pin, 2), "accepted") << "these are the cells of the scene";
  }
  EXPECT_EQ(with_cells("{vertex = 'bottom', fix = 'x'}", 5), "accepted");
}

TEST_F(SceneRefusals, AMeshHasNoNamedPinsNoShapeAndNoCells) {
  write("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const std::string mesh = "[cloth]\nmesh = \"m.obj\"\ndensity = 1\n[time]\nh = 1\nend = 1\n";
  expect_says(refusal(with_line(3, "density = 1\npins = [\"top\"]", mesh)),
              {"scene.toml:4: ", "only a grid", "a vertex number from 0 to 2"});
  expect_says(refusal(mesh + "[start]\nshape = \"flat\""), {"scene.toml:8: ", "positions"});
  expect_says(refusal(mesh, "step01", {.cells = 3}), {"scene.toml: --cells 3", "only a grid"});
}

TEST_F(SceneRefusals, StartKeysThatExcludeEachOtherAreRefused) {
  write("p.obj", "");
  write("v.csv", "");
  expect_says(refusal(scene + "[start]\nshape = \"flat\"\npositions = \"p.obj\""),
              {"scene.toml:10: ", "shape", "positions", "take out one"});
  for (const std::string key : {"velocity", "spin"})
    expect_says(refusal(scene + "[start]\n" + key + " = [0, 0, 0]\nvelocities = \"v.csv\""),
                {"scene.toml:10: ", key, "velocities", "take out one"});
}

TEST_F(SceneRefusals, StartPositionsMustBeOnePerVertex) {
  write("p.obj", "v 0 0 0\nv 1 2 3\n");
  expect_says(refusal(scene + "[start]\npositions = \"p.obj\""),
              {"scene.toml:10: ", "p.obj has 2 vertices", "the cloth has 9"});
  write("p.obj", "v 0 0 0\nv 1 nan 3\n");
  expect_says(refusal(scene + "[start]\npositions = \"p.obj\""), {"p.obj:2: ", "finite numbers"});
  expect_says(refusal(scene + "[start]\npositions = \"q.obj\""),
              {"scene.toml:10: ", "no such file"});
}

TEST_F(SceneRefusals, StartVelocitiesMustBeAHeaderAndOneRowPerVertex) {
  const auto csv = [&](const std::string& text) {
    write("v.csv", text);
    return refusal(scene + "[start]\nvelocities = \"v.csv\"");
  };
  expect_says(csv("0,0,0\n"), {"v.csv:1: ", "header vx,vy,vz"});
  expect_says(csv(""), {"v.csv:1: ", "header vx,vy,vz"});
  expect_says(csv("vx,vy,vz\n0,0,0\n0,0\n"), {"v.csv:3: ", "three finite numbers"});
  expect_says(csv("vx,vy,vz\n0,0,nan\n"), {"v.csv:2: ", "three finite numbers"});
  expect_says(csv("vx,vy,vz\n0,0,1,2\n"), {"v.csv:2: ", "three finite numbers"});
  expect_says(csv("vx,vy,vz\n0,0,1e999\n"), {"v.csv:2: ", "three finite numbers"});
  expect_says(csv("vx,vy,vz\n0,0,1\n"), {"v.csv: 1 rows", "9 vertices", "one row per vertex"});
  std::string long_one = "vx,vy,vz\n";
  for (int i = 0; i < 10; ++i) long_one += "0,0,0\n";
  expect_says(csv(long_one), {"v.csv: 10 rows", "9 vertices"});
}

TEST_F(SceneRefusals, TablesThatCannotBeLeftOutOrDoNotExistAreRefused) {
  for (const std::string name : {"cloth", "time"})
    expect_says(refusal(scene, "step01", {.without = {name}}),
                {"scene.toml: --without " + name, "every scene needs"});
  expect_says(refusal(scene, "step01", {.without = {"gravty"}}),
              {"scene.toml: --without gravty", "did you mean \"gravity\"?", "stretch, shear"});
}

TEST_F(SceneRefusals, ValuesOfTheCommandLineAreCheckedLikeThoseOfTheFile) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Overrides bad[] = {{.h = 0}, {.h = nan}, {.end = -1}, {.frames = 0}, {.cells = 0}};
  const std::string keys[] = {"[time] h", "[time] h", "[time] end", "[time] frames",
                              "[cloth] cells"};
  for (size_t i = 0; i < std::size(bad); ++i)
    expect_says(refusal(scene, "step01", bad[i]),
                {"scene.toml: " + keys[i], "from the command line", "it must be"});
}

// The command line -----------------------------------------------------------------------------

TEST_F(SceneRefusals, ASettingThatIsNoneIsNamed) {
  for (const char* wrong : {"stretch", "stretch.k", ".k=1", "stretch.=1", "stretchk=1", "=1"})
    EXPECT_EQ(refusal(scene, "step01", {.set = {wrong}}),
              std::string("scene.toml: --set ") + wrong +
                  ": it must be TABLE.KEY=VALUE, such as stretch.k=1e4");
  for (const char* wrong :
       {"stretch.k=", "stretch.k=1 2", "stretch.k=[1", "stretch.k=1\nshear = 2"})
    expect_says(refusal(scene, "step01", {.set = {wrong}}),
                {"scene.toml: --set stretch.k=", "a number, \"text\" or a list"});
  const std::string far = refusal(scene, "step01", {.set = {"strech.k=1"}});
  expect_says(far, {"--set strech.k=1: there is no table [strech]", "did you mean \"stretch\"?"});
  EXPECT_EQ(far.find("damping"), far.npos) << "step01 does not teach damping";
}

TEST_F(SceneRefusals, ASettingIsCheckedLikeTheFile) {
  EXPECT_EQ(refusal(scene, "step01", {.set = {"stretch.k=-1"}}),
            "scene.toml: [stretch] k = -1 from the command line is not valid: it must be a number "
            "from 0 to 1e30");
  expect_says(refusal(scene, "step01", {.set = {"stretch.kk=1"}}),
              {"scene.toml: [stretch] has no key kk, which --set names", "did you mean \"k\"?"});
  EXPECT_EQ(refusal(scene, "step04_cg", {.set = {"bend.k=1"}}),
            "scene.toml: step04_cg does not model [bend]; step05_bend does");
  expect_says(refusal(scene, "step01", {.set = {"start.shape=round"}}), {"round", "flat"});
  expect_says(refusal(scene, "step01", {.set = {"start.positions=pose_2.obj"}}),
              {"[start] positions = 'pose_2.obj' from the command line", "no such file"});
}

TEST_F(SceneRefusals, AKeyThatIsSetTwiceIsNamed) {
  EXPECT_EQ(refusal(scene, "step01", {.set = {"stretch.k=1", "stretch.k=2"}}),
            "scene.toml: --set stretch.k=2: the command line sets k of [stretch] twice");
  EXPECT_EQ(refusal(scene, "step01", {.h = 0.01, .set = {"time.h=1"}}),
            "scene.toml: --set time.h=1: the command line sets h of [time] twice");
  EXPECT_EQ(refusal(scene, "step01", {.cells = 4, .set = {"cloth.cells=[4, 4]"}}),
            "scene.toml: --set cloth.cells=[4, 4]: the command line sets cells of [cloth] twice");
  EXPECT_EQ(refusal(scene, "step01", {.without = {"shear"}, .set = {"shear.k=1"}}),
            "scene.toml: --set shear.k=1: the command line leaves out [shear], too");
}

}  // namespace scene_refusals_test
