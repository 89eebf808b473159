// Every bad input: exit code 2, one line that names the place and what would be valid, and nothing
// is written.
#include <algorithm>

#include "support/program_runner.h"

namespace program_refusals_test {

const std::string cloth = R"([cloth]
size = [1.0, 1.0]
cells = [4, 4]
density = 0.2
pins = ["top left"]
)";
const std::string model = "[gravity]\ng = 9.81\n[stretch]\nk = 1000.0\n[shear]\nk = 500.0\n";
const std::string time_table = "[time]\nh = 0.001\nend = 0.01\nframes = 2\n";
const std::string scene = cloth + model + time_table;

std::string replaced(std::string text, const std::string& old, const std::string& by) {
  return text.replace(text.find(old), old.size(), by);
}

const std::string mesh_scene = "[cloth]\nmesh = \"mesh.obj\"\ndensity = 0.2\n" + model + time_table;

const std::string square = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n";

struct BadInputCase {
  std::string name;
  std::string scene;  // none: no scene.toml is written
  Arguments arguments = {};
  std::vector<std::string> says;  // parts of the line
  std::string mesh = {};          // none: no mesh.obj is written
};
void PrintTo(const BadInputCase& bad, std::ostream* out) {
  *out << bad.name;
}

const std::vector<BadInputCase> cases = {
    {"missing_scene", "", {}, {"scene.toml", "no such file"}},
    {"malformed_toml", replaced(scene, "density = 0.2", "density = "), {}, {"scene.toml:4: "}},
    {"unknown_table", scene + "[wind]\nv = 1\n", {}, {"scene.toml:16: ", "[wind]", "gravity"}},
    {"unknown_key",
     replaced(scene, "g = 9.81", "gg = 9.81"),
     {},
     {"scene.toml:7: ", "[gravity]", "gg", "did you mean \"g\""}},
    {"wrong_type",
     replaced(scene, "0.2", "\"light\""),
     {},
     {"scene.toml:4: ", "density", "light", "a number from 1e-30 to 1e30"}},
    {"negative_k",
     replaced(scene, "k = 500.0", "k = -500.0"),
     {},
     {"scene.toml:11: ", "[shear] k = -500", "a number from 0 to 1e30"}},
    {"nan_k",
     replaced(scene, "k = 1000.0", "k = nan"),
     {},
     {"scene.toml:9: ", "[stretch] k = nan", "a number from 0 to 1e30"}},
    {"negative_density",
     replaced(scene, "0.2", "-0.2"),
     {},
     {"scene.toml:4: ", "density = -0.2", "a number from 1e-30 to 1e30"}},
    {"zero_density",
     replaced(scene, "0.2", "0.0"),
     {},
     {"scene.toml:4: ", "density = 0", "a number from 1e-30 to 1e30"}},
    {"infinite_density",
     replaced(scene, "0.2", "inf"),
     {},
     {"scene.toml:4: ", "density = inf", "a number from 1e-30 to 1e30"}},
    {"nan_size",
     replaced(scene, "[1.0, 1.0]", "[nan, 1.0]"),
     {},
     {"scene.toml:2: ", "size", "two numbers from 1e-30 to 1e30"}},
    {"h_is_zero",
     replaced(scene, "h = 0.001", "h = 0"),
     {},
     {"scene.toml:13: ", "[time] h = 0", "a number from 1e-30 to 1e30"}},
    {"h_is_negative",
     replaced(scene, "h = 0.001", "h = -0.001"),
     {},
     {"scene.toml:13: ", "[time] h = -0.001", "a number from 1e-30 to 1e30"}},
    {"unknown_pin",
     replaced(scene, "top left", "topleft"),
     {},
     {"scene.toml:5: ", "pins", "topleft", "\"top left\"?", "from 0 to 24"}},
    {"pin_out_of_range",
     replaced(scene, "\"top left\"", "25"),
     {},
     {"scene.toml:5: ", "pins", "25", "from 0 to 24"}},

    {"mesh_without_faces", mesh_scene, {}, {"mesh.obj", "faces", "f lines"}, square},
    {"zero_area_triangle",
     mesh_scene,
     {},
     {"mesh.obj", "no area", "take it out"},
     square + "v 2 0 0\nf 1 2 3\nf 2 4 3\nf 1 5 2\n"},
    {"non_manifold_triangle",
     mesh_scene,
     {},
     {"mesh.obj", "edge", "more than two faces", "one or two"},
     square + "v 1 1 1\nf 1 2 3\nf 2 4 3\nf 2 5 3\n"},
    {"mesh_index_out_of_range",
     mesh_scene,
     {},
     {"mesh.obj:5: ", "does not exist", "1 to 4"},
     square + "f 1 2 9\n"},

    {"cells_beyond_memory", scene, {"--cells", "100000"}, {"cells", "4000025 MB", "fewer cells"}},

    {"out_below_a_file", scene, {"--out", "scene.toml/out"}, {"--out scene.toml/out", "directory"}},
    {"out_where_nothing_can_be",
     scene,
     {"--out", "/proc/out"},
     {"--out /proc/out", "a directory that can be written"}},
    {"size_zero", scene, {"--size", "0x0"}, {"--size", "0x0", "1 to "}},
    {"size_too_large", scene, {"--size", "99999x99999"}, {"--size", "99999x99999", "1 to "}},
    {"size_of_letters", scene, {"--size", "abc"}, {"--size", "abc", "1280x720"}},
    {"size_with_a_rest", scene, {"--size", "160x90px"}, {"--size", "160x90px", "1280x720"}},
    {"unknown_option", scene, {"--fast"}, {"--fast", "--help"}},
    {"h_longer_than_end", scene, {"--h", "1"}, {"h = 1.0", "longer than end"}},
    {"k_beyond_1e30",
     replaced(scene, "k = 500.0", "k = 1e160"),
     {},
     {"k = 1e+160", "a number from 0 to 1e30"}},
    {"size_beyond_an_int", scene, {"--size", "4294967297x1"}, {"--size", "WIDTHxHEIGHT"}},
    {"size_with_blanks", scene, {"--size", " 10x 10"}, {"--size", "WIDTHxHEIGHT"}},
    {"empty_size", scene, {"--size", ""}, {"--size", "empty"}},
    {"empty_out", scene, {"--out", ""}, {"--out", "empty"}},
    {"another_jacobian", scene, {"--jacobian", "foo"}, {"--jacobian", "bw98 or definite", "foo"}},
    {"jacobian_by_number", scene, {"--jacobian", "1"}, {"--jacobian", "bw98 or definite"}},
    {"mesh_is_no_regular_file",
     replaced(mesh_scene, "mesh.obj", "/dev/zero"),
     {},
     {"/dev/zero", "no regular file"}},
    {"control_characters", scene + "\"a\\nb\\u001b\" = 1\n", {}, {"no key a\\nb\\x1b"}},
    {"key_of_a_megabyte", scene + std::string(1000000, 'k') + " = 1\n", {}, {"no key k", " ... "}},
    {"no_frames", scene, {"--frames", "0"}, {"--frames", "\"0\"", "from 1 on"}},
    {"frames_of_letters", scene, {"--frames", "many"}, {"--frames", "many", "from 1 on"}},
    {"export_of_another_format", scene, {"--export", "stl"}, {"--export", "stl", "{obj,pc2}"}},
    {"motion_without_pictures",
     scene,
     {"--motion", "--no-pictures"},
     {"--motion", "--no-pictures", "excludes"}},
    {"h_option_nan", scene, {"--h", "nan"}, {"--h", "nan", "a number above 0"}},
    {"h_option_zero", scene, {"--h", "0"}, {"--h", "\"0\"", "a number above 0"}},
    {"h_option_negative", scene, {"--h", "-1"}, {"--h", "-1", "a number above 0"}},
    {"end_option_infinite", scene, {"--end", "inf"}, {"--end", "inf", "a number above 0"}},
    {"strain_option_zero", scene, {"--strain", "0"}, {"--strain", "\"0\"", "a number above 0"}},
    {"without_what_there_is_not", scene, {"--without", "wind"}, {"--without wind", "gravity"}},
    {"without_the_cloth", scene, {"--without", "cloth"}, {"--without cloth", "every scene needs"}},
};

std::string bad_name(const testing::TestParamInfo<std::tuple<StepProgram, BadInputCase>>& info) {
  return std::get<0>(info.param).name + "_" + std::get<1>(info.param).name;
}

void expect_one_line(const Outcome& outcome, const std::vector<std::string>& says) {
  EXPECT_EQ(outcome.code, 2);
  EXPECT_TRUE(lines_of(outcome.err).size() == 1 && outcome.err.ends_with('\n')) << outcome.err;
  for (const std::string& part : says)
    EXPECT_NE(outcome.err.find(part), std::string::npos) << "\"" << part << "\" is not in\n"
                                                         << outcome.err;
}

using BadInput = std::tuple<StepProgram, BadInputCase>;
class BadInputTest : public ProgramDirectory, public testing::WithParamInterface<BadInput> {};

TEST_P(BadInputTest, IsRefusedInOneLineAndNothingIsWritten) {
  const auto& [program, bad] = GetParam();
  if (!bad.scene.empty()) write("scene.toml", bad.scene);
  if (!bad.mesh.empty()) write("mesh.obj", bad.mesh);
  const std::vector<std::string> before = files_in(directory);
  Arguments arguments = {"scene.toml"};
  if (std::find(bad.arguments.begin(), bad.arguments.end(), "--out") == bad.arguments.end())
    arguments.insert(arguments.end(), {"--out", "out"});
  arguments.insert(arguments.end(), bad.arguments.begin(), bad.arguments.end());

  expect_one_line(run(program, arguments), bad.says);
  EXPECT_EQ(files_in(directory), before);
}

// All programs read scenes and options by the same libraries: one program meets every case, the others
// one case of each kind.
std::vector<BadInput> bad_inputs() {
  const std::vector<std::string> kinds = {"missing_scene",
                                          "unknown_table",
                                          "mesh_index_out_of_range",
                                          "cells_beyond_memory",
                                          "out_below_a_file",
                                          "unknown_option",
                                          "h_option_nan",
                                          "without_what_there_is_not"};
  std::vector<BadInput> all;
  for (const StepProgram& program : programs())
    for (const BadInputCase& bad : cases)
      if (program.number() == 5 || std::count(kinds.begin(), kinds.end(), bad.name) == 1)
        all.emplace_back(program, bad);
  if (all.size() != cases.size() + (programs().size() - 1) * kinds.size())
    throw std::logic_error("a kind of bad input is not the name of a case");
  return all;
}

INSTANTIATE_TEST_SUITE_P(Programs, BadInputTest, testing::ValuesIn(bad_inputs()), bad_name);

// Otherwise the cases above could be refused for another reason than their own.
TEST_P(ProgramTest, AcceptsTheSceneThatTheBadOnesAreMadeFrom) {
  write("scene.toml", scene);
  expect_done({"scene.toml", "--no-pictures"});
  write("scene.toml", mesh_scene);
  write("mesh.obj", square + "f 1 2 3\nf 2 4 3\n");
  expect_done({"scene.toml", "--no-pictures"});
}

TEST_P(ProgramTest, TakesTablesOfPinsOnlyWhereConjugateGradientsFilterThem) {
  write("pins.toml",
        replaced(scene, "[\"top left\"]", "[\"top left\", {vertex = 4, fix = \"y\"}]"));
  if (GetParam().is_iterative()) return expect_done({"pins.toml", "--no-pictures"});
  const Outcome refused = run({"pins.toml", "--out", "out"});
  expect_one_line(refused,
                  {"pins.toml:5: " + GetParam().name + " does not model pins", "step04_cg"});
  EXPECT_EQ(files_in(directory), std::vector<std::string>{"pins.toml"});
}

TEST_P(ProgramTest, NamesTheStepThatTeachesATableAndRunsWithoutIt) {
  struct Later {
    std::string table, first_step, text;
  };
  for (const auto& [table, first_step, text] :
       {Later{"damping", "step02_damping", "[damping]\nstretch = 0.01\nshear = 0.01\n"},
        Later{"bend", "step05_bend", "[bend]\nk = 0.001\n"}}) {
    if (GetParam().number() >= first_step[5] - '0') continue;
    write("later.toml", scene + text);
    const Outcome refused = run({"later.toml", "--out", "out"});
    EXPECT_EQ(refused.code, 2);
    EXPECT_EQ(refused.err, "later.toml:16: " + GetParam().name + " does not model [" + table +
                               "]; " + first_step + " does. --without " + table +
                               " runs the scene without it\n");
    EXPECT_EQ(files_in(directory), std::vector<std::string>{"later.toml"});
    expect_done({"later.toml", "--no-pictures", "--out", "out", "--without", table});
    std::filesystem::remove_all(directory / "out");
  }
}

}  // namespace program_refusals_test
