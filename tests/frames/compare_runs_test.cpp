// The program compare_runs, and what it writes.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "contact_sheet.h"
#include "made_up_run.h"
#include "picture/compare.h"
#include "picture/png.h"
#include "report_json.h"
#include "sheet_of_runs.h"
#include "support/program_runner.h"
#include "test_scene.h"

namespace compare_runs_test {

using Json = nlohmann::json;

class CompareRuns : public ProgramDirectory {
 protected:
  Outcome compare(const Arguments& arguments) const {
    return Running(COMPARE_RUNS, arguments, directory).wait(60);
  }
  MadeUpRun run_with(const std::string& name, int left, double h = 0.01) const {
    MadeUpRun run(directory / name);
    run.toml(h).frame(0).picture(cloth_on_the_wall(10)).mesh(triangle);
    run.frame(0.5)
        .picture(cloth_on_the_wall(left))
        .mesh({{0, 0, left / 1e4}, {1, 0, 0}, {0, 1, 0}});
    return run;
  }
};

TEST_F(CompareRuns, ExitCodeIsTheVerdict) {
  run_with("a", 20);
  run_with("same", 20);
  run_with("other", 25);
  EXPECT_EQ(compare({"a", "same"}).code, 0);
  EXPECT_EQ(compare({"a", "other"}).code, 1);
  EXPECT_EQ(compare({"a", "same", "other"}).code, 1);
  EXPECT_EQ(compare({"a", "absent"}).code, 2);
  EXPECT_EQ(compare({"a"}).code, 2);
  EXPECT_EQ(compare({}).code, 2);
  EXPECT_EQ(compare({"--help"}).code, 0);
  EXPECT_EQ(compare({"a", "same", "--diff"}).code, 2) << "without --sheet";
  EXPECT_EQ(compare({"a", "same", "--json", "no/such/directory.json"}).code, 2);
}

TEST_F(CompareRuns, SaysInOneLineWhatIsNoRun) {
  run_with("a", 20);
  const Outcome outcome = compare({"a", "absent"});
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(outcome.err, "compare_runs: absent: is no directory; name the --out of a run\n");
}

TEST_F(CompareRuns, PrintsInputsFirstThenARowForEachFrameThenTheFirstDifference) {
  run_with("a", 20);
  run_with("b", 25, 0.02);
  const std::vector<std::string> lines = lines_of(compare({"a", "b"}).out);
  ASSERT_EQ(lines.size(), 8u);
  EXPECT_EQ(lines[0], "A: a");
  EXPECT_EQ(lines[1], "B: b");
  EXPECT_EQ(lines[2], "time.h: 0.01 | 0.02");
  EXPECT_NE(lines[5].find("0  identical    0 of 400"), std::string::npos) << lines[5];
  EXPECT_NE(lines[6].find("0.5  different    200 of 500"), std::string::npos) << lines[6];
  EXPECT_NE(lines[7].find("frame 1, t = 0.5 s"), std::string::npos) << lines[7];
  EXPECT_NE(lines[7].find("vertex 0 is 0.5 mm away"), std::string::npos) << lines[7];
}

TEST_F(CompareRuns, JsonHasTheFormThatTheReportReads) {
  run_with("a", 20);
  run_with("b", 25, 0.02).frame(0.7, NAN);
  const Outcome outcome = compare({"a", "b", "--json", "-"});
  const Json all = Json::parse(outcome.out);
  EXPECT_EQ(all.at("version"), 1);
  ASSERT_EQ(all.at("pairs").size(), 1u);
  const Json& pair = all["pairs"][0];
  EXPECT_EQ(pair.at("verdict"), "different");
  EXPECT_EQ(pair.at("inputs"), Json::parse(R"([{"key": "time.h", "values": ["0.01", "0.02"]}])"));
  EXPECT_EQ(pair.at("notes"), Json::parse(R"(["A has no frame at t = 0.7 s"])"));
  EXPECT_EQ(pair.at("first_difference"), 1);
  EXPECT_FALSE(pair.at("summary").get<std::string>().empty());

  const Json& b = pair.at("runs").at(1);
  EXPECT_EQ(b.at("name"), "b");
  EXPECT_EQ(b.at("program"), "step03_implicit");
  EXPECT_EQ(b.at("directory"), (std::filesystem::canonical(directory) / "b").string());
  EXPECT_TRUE(b.at("reproduce")
                  .get<std::string>()
                  .ends_with("step03_implicit/step03_implicit b/run.toml --out ./b"))
      << b.at("reproduce");
  EXPECT_TRUE(pair.at("accept").get<std::string>().ends_with("b/run.toml --out ./a"));
  EXPECT_EQ(b.at("frames").at(1), Json::parse(R"({"number": 1, "time": 0.5, "energy": -0.5,
    "picture": "frame_0001.png", "elastic": 0.25, "stretch": 1.5, "lowest": -0.5, "iterations": 7})"));
  EXPECT_EQ(b["frames"].at(2).at("picture"), nullptr);
  EXPECT_EQ(b["frames"][2].at("energy"), nullptr) << "JSON has no nan";

  Json frame = pair.at("frames").at(1);
  EXPECT_NEAR(frame.at("rms_mm").get<double>(), 0.5 / std::sqrt(3), 1e-12);
  EXPECT_NEAR(frame.at("worst_mm").get<double>(), 0.5, 1e-12);
  frame.erase("rms_mm");
  frame.erase("worst_mm");
  EXPECT_EQ(frame, Json::parse(R"({"time": 0.5, "numbers": [1, 1], "verdict": "different",
    "pixels": 200, "of": 500, "largest": 168, "window": 80, "worst_vertex": 0})"));
}

TEST_F(CompareRuns, WithoutMeshesAndPicturesTheirNumbersAreNull) {
  MadeUpRun(directory / "a").frame(0);
  MadeUpRun(directory / "b").frame(0);
  const Json frame = Json::parse(compare({"a", "b", "--json", "-"}).out)["pairs"][0]["frames"][0];
  for (const char* key :
       {"pixels", "of", "largest", "window", "rms_mm", "worst_mm", "worst_vertex"})
    EXPECT_EQ(frame.at(key), nullptr) << key;
}

TEST_F(CompareRuns, NamesMayHaveAnyCharacters) {
  const std::string name = "it's \"my\" <b> & 100% \xff run\n";
  run_with("a", 20);
  run_with(name, 25);
  const Outcome outcome = compare({"a", name, "--json", "x y.json", "--sheet", "x y.png"});
  EXPECT_EQ(outcome.code, 1) << outcome.err;
  EXPECT_EQ(lines_of(outcome.out)[1], "B: it's \"my\" <b> & 100% \xff run");
  const Json b = Json::parse(read_all(directory / "x y.json"))["pairs"][0]["runs"][1];
  EXPECT_EQ(b["name"], "it's \"my\" <b> & 100% \xef\xbf\xbd run\n");
  EXPECT_NE(b["reproduce"].get<std::string>().find("'it'\\''s \"my\" <b>"), std::string::npos);
}

// run.toml may come from anywhere: only a step's program is put into a command.
TEST_F(CompareRuns, ProgramOfNoStepGivesNoCommand) {
  run_with("a", 20);
  run_with("b", 20).file("run.toml", "[run]\nprogram = 'x; rm -r /'\n");
  const Json pair = Json::parse(compare({"a", "b", "--json", "-"}).out)["pairs"][0];
  EXPECT_EQ(pair["runs"][1]["reproduce"], "");
  EXPECT_EQ(pair["accept"], "");
}

// --- contact sheets

bool contains(const Image& sheet, const Colour& colour) {
  for (size_t i = 0; i < sheet.rgb.size(); i += 3)
    if (std::equal(colour.begin(), colour.end(), &sheet.rgb[i])) return true;
  return false;
}

// The script has the numbers of both runs; a column that no run changes has no panel.
TEST_F(CompareRuns, PlotLogDrawsTheColumnsThatChange) {
  run_with("a", 20);
  run_with("b_c", 25);
  const Outcome outcome = Running(PLOT_LOG, {"a", "b_c", "--out", "p/log.png"}, directory).wait(60);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const std::string script = read_all(directory / "p/log.gp");
  EXPECT_NE(script.find("\"b_c\" noenhanced"), std::string::npos) << script;
  EXPECT_NE(script.find("total energy, J"), std::string::npos);
  EXPECT_EQ(script.find("iterations"), std::string::npos);
  EXPECT_NE(script.find("\n0.5,"), std::string::npos) << "time and values of the second frame";
  const bool is_drawn = outcome.out.find("gnuplot is missing") == std::string::npos;
  EXPECT_TRUE(!is_drawn || read_png(directory / "p/log.png").width == 900);
  EXPECT_EQ(Running(PLOT_LOG, {"absent"}, directory).wait(60).code, 2);
}

TEST(ContactSheet, HasARowPerRunAndAPlaceForWhatIsMissing) {
  const Colour green = {0, 200, 0}, blue = {0, 0, 200};
  const Image a = filled_image(640, 360, green), b = filled_image(320, 180, blue);
  const Image sheet =
      contact_sheet({"1 s", "2 s"}, {{"first", {a, a}}, {"second", {b, std::nullopt}}});
  EXPECT_NEAR(sheet.width, 1290, 10);
  const int column = sheet.width / 2, row = sheet.height / 2;
  EXPECT_EQ(pixel(sheet, column / 2, row / 2), green);
  EXPECT_EQ(pixel(sheet, column + column / 2, row / 2), green);
  EXPECT_EQ(pixel(sheet, 100, row + row / 4), blue) << "not enlarged";
  EXPECT_EQ(pixel(sheet, column / 2 + 50, row + row / 4), (Colour{255, 255, 255}));
  EXPECT_FALSE(contains(contact_sheet({"1 s"}, {{"", {std::nullopt}}}), green));
}

TEST(ContactSheet, OnePixelThatDiffersIsSeenInASmallDifference) {
  const Image a = filled_image(640, 360, wall);
  Image b = a;
  b.rgb[pixel_at(b, 333, 111)] = 0;
  const Image small = small_difference(a, b, 6);
  ASSERT_LT(small.width, 215);
  int strong = 0;
  for (size_t i = 0; i < small.rgb.size(); i += 3) strong += small.rgb[i] > small.rgb[i + 2] + 50;
  EXPECT_EQ(strong, 1);
}

class SheetOfRuns : public CompareRuns {};

TEST_F(SheetOfRuns, ShowsSixMomentsThatAllRunsHave) {
  MadeUpRun a(directory / "a"), b(directory / "b");
  for (int k = 0; k <= 24; ++k) a.frame(k).picture(filled_image(300, 200, {10, 200, 10}));
  for (int k = 0; k <= 24; k += 3) b.frame(k).picture(filled_image(300, 200, {10, 10, 200}));
  ASSERT_EQ(compare({"a", "b", "--sheet", "s.png", "--diff"}).code, 1);
  const Image sheet = read_png(directory / "s.png");
  const int column = sheet.width / 6, row = (sheet.height - 26) / 3;
  for (int c = 0; c < 6; ++c) {
    const int x = c * column + column / 2;
    EXPECT_EQ(pixel(sheet, x, 26 + row / 2), (Colour{10, 200, 10})) << c;
    EXPECT_EQ(pixel(sheet, x, 26 + row + row / 2), (Colour{10, 10, 200})) << c;
    EXPECT_EQ(pixel(sheet, x, 26 + 2 * row + row / 2), (Colour{120, 0, 0})) << c;
  }
}

}  // namespace compare_runs_test
