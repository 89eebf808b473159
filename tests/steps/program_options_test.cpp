// Every option does what --help says.
#include <cmath>
#include <regex>
#include <set>

#include "picture/png.h"
#include "scene/mesh.h"
#include "support/program_runner.h"

namespace program_options_test {

class OptionsTest : public ProgramTest {
 protected:
  // Runs the square metre on few cells for a short time, in a directory of its own.
  std::filesystem::path results(const std::string& out, int cells, const Arguments& more) const {
    Arguments arguments = small_square(cells, {"--end", "0.05", "--out", out});
    arguments.insert(arguments.end(), more.begin(), more.end());
    expect_done(arguments);
    return directory / out;
  }
};

// The left two thirds: the legend of --strain stands in the rest.
std::vector<unsigned char> left_part(const Image& image) {
  std::vector<unsigned char> rgb;
  for (int y = 0; y < image.height; ++y) {
    const auto row = image.rgb.begin() + long(pixel_at(image, 0, y));
    rgb.insert(rgb.end(), row, row + 2 * image.width);
  }
  return rgb;
}

// The names that follow the dashes in a text of --help: letters of short flags, words of long ones.
std::set<std::string> flags(const std::string& help, const std::string& dashes) {
  const std::regex flag("(^|[\\s,])" + dashes + "([A-Za-z][A-Za-z-]*)");
  std::set<std::string> names;
  for (std::sregex_iterator match(help.begin(), help.end(), flag), end; match != end; ++match)
    names.insert((*match)[2]);
  return names;
}

TEST_P(OptionsTest, HelpListsEveryOption) {
  const Outcome help = run({"--help"});
  EXPECT_EQ(help.code, 0);
  EXPECT_EQ(help.err, "");
  for (const char* option : {"scene.toml", "--out DIR", "--frames N", "--h S", "--end S",
                             "--cells N", "--size WxH", "--without TABLE", "--set TABLE.KEY=VALUE",
                             "--explain ", "--no-pictures ", "--export obj|pc2", "--motion ",
                             "--wireframe", "--caption", "--strain S", "--help", "--version"})
    EXPECT_NE(help.out.find(option), std::string::npos) << option << " is not in\n" << help.out;
  EXPECT_EQ(files_in(directory), std::vector<std::string>{});
}

// CLI11 2.4 takes -h and --h for the same option and refuses the second one: no program would start.
TEST_P(OptionsTest, NoShortFlagHasTheNameOfALongOne) {
  const std::string help = run({"--help"}).out;
  const std::set<std::string> long_flags = flags(help, "--");
  EXPECT_TRUE(long_flags.contains("h")) << help;
  for (const std::string& letter : flags(help, "-"))
    EXPECT_FALSE(long_flags.contains(letter)) << "-" << letter << " and --" << letter;
}

// CLI11 gives every program the flag -h unless the flag of the help is named first.
TEST(OptionsOfEveryProgram, BeginWithTheFlagOfTheHelp) {
  int sources = 0;
  for (const char* folder : {"common", "tests"})
    for (const auto& entry : std::filesystem::recursive_directory_iterator(
             std::filesystem::path(SOURCE_DIRECTORY) / folder)) {
      if (entry.path().extension() != ".cpp") continue;
      const std::string text = read_all(entry.path());
      const size_t first_option = text.find("\n  app.add_");
      if (first_option == std::string::npos) continue;
      EXPECT_LT(text.find("\n  app.set_help_flag(\"--help\""), first_option) << entry.path();
      ++sources;
    }
  EXPECT_GE(sources, 4);
}

TEST_P(OptionsTest, VersionIsOneLineWithTheNameOfTheProgram) {
  const Outcome version = run({"--version"});
  EXPECT_EQ(version.code, 0);
  EXPECT_TRUE(
      std::regex_match(version.out, std::regex(GetParam().name + R"( \(Large Steps [0-9.]+\)\n)")))
      << version.out;
}

TEST_P(OptionsTest, ResultsGoToADirectoryNamedAfterTheProgram) {
  expect_done(small_square(4, {"--end", "0.01", "--no-pictures"}));
  EXPECT_EQ(files_in(directory), std::vector<std::string>{"out"});
  EXPECT_EQ(files_in(directory / "out"), std::vector<std::string>{GetParam().name});
}

TEST_P(OptionsTest, ExportWritesOneMeshPerFrame) {
  const std::filesystem::path out =
      results("out", 6, {"--frames", "4", "--export", "obj", "--no-pictures"});
  EXPECT_EQ(count_starting(files_in(out), "frame_", ".obj"), 5);
  double y_before = 1;
  for (int frame = 0; frame <= 4; ++frame) {
    const Mesh mesh = read_obj(out / ("frame_000" + std::to_string(frame) + ".obj"));
    EXPECT_EQ(mesh.vertices(), 49);
    EXPECT_EQ(mesh.faces.size(), 72u);
    EXPECT_LT(mesh.x[1], y_before) << "the free corner falls";
    y_before = mesh.x[1];
  }
  EXPECT_EQ(read_all(out / "frame_0004.obj"), read_all(out / "final.obj"));
}

TEST_P(OptionsTest, FramesEndAndCellsReplaceThoseOfTheScene) {
  expect_done(small_square(5, {"--frames", "3", "--end", "0.02", "--no-pictures", "--out", "out"}));
  const Table log = read_table(directory / "out/log.csv");
  EXPECT_EQ(log.at("frame"), (std::vector<double>{0, 1, 2, 3}));
  EXPECT_NEAR(log.at("time").back(), 0.02, 1e-12);
  EXPECT_EQ(read_obj(directory / "out/final.obj").vertices(), 36);
}

// --set and --without take one word each: the scene may follow them.
TEST_P(OptionsTest, SetsAValueOfTheScene) {
  const std::string scene = GetParam().scene().string();
  expect_done({"--end", "0.02", "--no-pictures", "--out", "out", "--set", "cloth.cells=[5, 5]",
               "--set", "gravity.g=0", "--without", "start", "--set", "cloth.pins=[]", scene});
  EXPECT_NEAR(read_table(directory / "out/log.csv").at("lowest").back(), 0, 1e-12);
  const std::string again = read_all(directory / "out/run.toml");
  EXPECT_NE(again.find("cells = [5, 5]"), std::string::npos) << again;
  EXPECT_NE(again.find("g = 0\n"), std::string::npos) << again;
}

TEST_P(OptionsTest, HReplacesThatOfTheScene) {
  const auto said = [&](const char* h) {
    return run(small_square(5, {"--end", "0.02", "--h", h, "--no-pictures"})).out;
  };
  EXPECT_NE(said("0.0001").find("h = 0.0001 s, 200 steps"), std::string::npos);
  EXPECT_NE(said("0.00005").find("h = 5e-05 s, 400 steps"), std::string::npos);
}

TEST_P(OptionsTest, WithoutGravityAFlatClothStaysWhereItIs) {
  const std::filesystem::path out = results("out", 5, {"--without", "gravity", "--no-pictures"});
  const Table log = read_table(out / "log.csv");
  EXPECT_NEAR(log.at("lowest").back(), 0, 1e-12);
  EXPECT_EQ(log.at("gravitational").back(), 0);
}

TEST_P(OptionsTest, WithoutATermItsColumnIsGone) {
  const std::filesystem::path out = results("out", 5, {"--no-pictures", "--without", "shear"});
  const Table log = read_table(out / "log.csv");
  EXPECT_EQ(log.count("shear"), 0u);
  EXPECT_EQ(log.count("stretch"), 1u);
}

TEST_P(OptionsTest, EachStyleDrawsAnotherPictureOfTheGivenSize) {
  const std::vector<Arguments> styles = {
      {}, {"--strain", "0.1"}, {"--wireframe"}, {"--caption"}, {"--strain", "0.01"}};
  std::vector<Image> frames, stills;
  for (size_t style = 0; style < styles.size(); ++style) {
    Arguments arguments = {"--frames", "2", "--size", "160x90"};
    arguments.insert(arguments.end(), styles[style].begin(), styles[style].end());
    const std::filesystem::path out = results("style" + std::to_string(style), 8, arguments);
    EXPECT_TRUE(exists(out / "film.png"));
    frames.push_back(read_png(out / "frame_0002.png"));
    stills.push_back(read_png(out / "still.png"));
    EXPECT_EQ(count_starting(files_in(out), "frame_", ".png"), 3);
    EXPECT_EQ(count_starting(files_in(out), "", ".part"), 0);
  }
  for (const std::vector<Image>& pictures : {frames, stills})
    for (size_t a = 0; a < pictures.size(); ++a) {
      EXPECT_EQ(pictures[a].width, 160);
      EXPECT_EQ(pictures[a].height, 90);
      for (size_t b = 0; b < a; ++b)
        EXPECT_TRUE(left_part(pictures[a]) != left_part(pictures[b]))
            << "styles " << b << " and " << a;
    }
}

// The film shows the start, the end and the frames between: more of the picture than one frame.
TEST_P(OptionsTest, FilmHoldsAllFramesOfAShortRun) {
  const std::filesystem::path out = results("out", 8, {"--frames", "3", "--size", "160x90"});
  const Image film = read_png(out / "film.png");
  EXPECT_GE(film.width, 4 * 160);
  EXPECT_LT(film.height, 2 * 90);
}

// … and neither when nor where: on one machine, the same run gives the same bytes on every day and in
// every directory.
TEST_P(OptionsTest, PicturesSayWhatMadeThem) {
  const std::filesystem::path out =
      results("out", 8, {"--frames", "2", "--h", "0.0001", "--size", "160x90", "--caption"});
  const std::vector<std::pair<std::string, std::string>> pictures = {
      {"frame_0001.png", "0.025 s"}, {"frame_0002.png", "0.05 s"}, {"film.png", "0.05 s"}};
  for (const auto& [file, time] : pictures) {
    const PngText expected = {{"Software", "Large Steps, " + GetParam().name},
                              {"Scene", GetParam().name + "/scene.toml"},
                              {"TimeStep", "0.0001 s"},
                              {"Time", time}};
    EXPECT_EQ(read_png_text(out / file), expected) << file;
    const std::string bytes = read_all(out / file);
    for (const std::string& never :
         {std::string("tIME"), directory.string(), std::string(SOURCE_DIRECTORY)})
      EXPECT_EQ(bytes.find(never), std::string::npos) << file << " holds " << never;
  }
}

INSTANTIATE_TEST_SUITE_P(Programs, OptionsTest, testing::ValuesIn(programs()), name_of);

}  // namespace program_options_test
