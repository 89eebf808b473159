// The results of a run: its log and its last state, which depend on nothing but the scene.
#include <cmath>

#include "picture/png.h"
#include "scene/mesh.h"
#include "scene/velocities.h"
#include "support/program_runner.h"
#include "text/text.h"

namespace program_results_test {

// All columns but the last, the milliseconds.
std::string without_milliseconds(const std::string& csv) {
  std::string text;
  for (const std::string& line : lines_of(csv)) text += line.substr(0, line.rfind(',')) + "\n";
  return text;
}

// The default run of a program until 0.25 s, as g++ 12 computes it; clang 14 gives the same
// bits. The tolerance of 1e-9 leaves room for sums in another order.
struct Golden {
  std::string program;
  struct Probe {
    int vertex;
    Vec3 x;  // m
  };
  std::vector<Probe> probes;
  double kinetic, elastic;  // J
};
const std::vector<Golden> goldens = {
    {"step01_explicit",
     {{20, {0.50000000000000044, -0.3068077500000011, -0.10976831668979747}},
      {415, {0.12497375629164519, -0.30680774999994864, -0.35965817521393995}},
      {840, {0.50000000000000022, -0.30487318740591501, -0.60997390988924194}}},
     0.472217007732,
     0.00331253885466},
    {"step02_damping",
     {{20, {0.49999999999999972, -0.3068077500000011, -0.10976230221015397}},
      {415, {0.12497363936237049, -0.30680774999994864, -0.35965421092051852}},
      {840, {0.49999999999999989, -0.30487291687562651, -0.60996905372572863}}},
     0.472199814944,
     0.00331662046894},
    {"step03_implicit",
     {{20, {0.49999999999999906, -0.3188249999424877, -0.10680830882189694}},
      {415, {0.12501129050439796, -0.31881429681304119, -0.35692183946524492}},
      {840, {0.5, -0.29913746737706087, -0.60576976030791974}}},
     0.433482421124,
     0.00768746252014},
    {"step04_cg",
     {{20, {0.49999999740015755, -0.31788005307775802, -0.10683993429350865}},
      {415, {0.12501425884424439, -0.31881541676134528, -0.35691083149109676}},
      {840, {0.49999999927699407, -0.29918805566093892, -0.60577579813895521}}},
     0.433475738216,
     0.00769342407104},
    {"step05_bend",
     {{48, {1.4328799516353008, 0.018260306723656514, -0.00082062913013921626}},
      {824, {1.1597859094332812, 0.5058555584579798, 0.014999831263412268}},
      {1595, {0.75216946648087069, 0.99627966495555853, -0.00720711502204361}}},
     0.0190470244948,
     0.00675133057579},
};

const Golden* golden_of(const StepProgram& program) {
  for (const Golden& golden : goldens)
    if (golden.program == program.name) return &golden;
  return nullptr;
}

TEST_P(ProgramTest, LogsARowPerFrameAndLeavesTheLastState) {
  const double h = 0.0002, end = 0.1;
  const int steps = 500, frames = 7;
  expect_done(small_square(
      8, {"--frames", "7", "--end", "0.1", "--h", "0.0002", "--no-pictures", "--out", "out"}));
  EXPECT_EQ(files_in(directory / "out"),
            (std::vector<std::string>{"final.obj", "final_velocities.csv", "log.csv", "run.toml"}));

  std::string columns = "frame,time,kinetic,elastic,gravitational,total,max_stretch,lowest,";
  columns += GetParam().number() < 5 ? "stretch,shear" : "stretch,shear,bend";
  columns += ",iterations,indefinite,capped,gained,redone,unconverged,milliseconds";
  EXPECT_EQ(lines_of(read_all(directory / "out/log.csv"))[0], columns);

  const Table log = read_table(directory / "out/log.csv");
  ASSERT_EQ(log.at("frame").size(), size_t(frames + 1));
  for (int frame = 0; frame <= frames; ++frame) {
    const auto at = [&](const char* column) { return log.at(column)[size_t(frame)]; };
    EXPECT_EQ(at("frame"), frame);
    EXPECT_NEAR(at("time"), double(std::lround(double(frame) * steps / frames)) * h, 1e-12);
    EXPECT_NEAR(at("total"), at("kinetic") + at("elastic") + at("gravitational"), 1e-11);
    EXPECT_GE(at("max_stretch"), 1 - 1e-9);
  }
  EXPECT_NEAR(log.at("time").back(), end, 1e-12);
  EXPECT_LT(log.at("lowest").back(), -0.01) << "it falls";

  const Mesh last = read_obj(directory / "out/final.obj");
  EXPECT_EQ(last.vertices(), 81);
  EXPECT_EQ(last.faces.size(), 128u);
  EXPECT_EQ(read_velocities(directory / "out/final_velocities.csv", 81).size(), 3 * 81);
  double lowest = 0;
  for (int i = 0; i < 81; ++i) lowest = std::min(lowest, last.x[3 * i + 1]);
  EXPECT_NEAR(log.at("lowest").back(), lowest, 1e-11) << "log and final.obj show one state";
}

TEST_P(ProgramTest, ComputesTheGoldenNumbersOfItsDefaultRun) {
  const Golden* golden = golden_of(GetParam());
  ASSERT_TRUE(golden) << "measure them for " << GetParam().name;
  expect_done({"--end", "0.25", "--no-pictures", "--out", "out"});
  const VecX x = read_obj_vertices(directory / "out/final.obj");
  for (const auto& [vertex, expected] : golden->probes) {
    const Vec3 there = x.segment<3>(3 * vertex);
    EXPECT_LT((there - expected).norm(), 1e-9 * expected.norm())
        << text("{%d, {%.17g, %.17g, %.17g}}", vertex, there.x(), there.y(), there.z());
  }
  const Table log = read_table(directory / "out/log.csv");
  EXPECT_NEAR(log.at("kinetic").back(), golden->kinetic, 1e-8 * golden->kinetic);
  EXPECT_NEAR(log.at("elastic").back(), golden->elastic, 1e-8 * golden->elastic);
}

// Weight times size is 2.8 J, and no pin moves. The energy of symplectic Euler oscillates by an
// amount proportional to h, here 3e-4 J, and does not grow. Damping may lose more.
TEST_P(ProgramTest, GainsNoEnergyWhileItFalls) {
  expect_done({GetParam().square(), "--no-pictures", "--out", "out"});
  const Table log = read_table(directory / "out/log.csv");
  const std::vector<double>& total = log.at("total");
  for (const double energy : total) {
    EXPECT_LT(energy, total[0] + 1e-3);
    if (GetParam().number() == 1) {
      EXPECT_GT(energy, total[0] - 1e-3);
    }
  }
  EXPECT_EQ(log.at("gained").back(), 0);
}

TEST_P(ProgramTest, RunTwiceGivesTheSameBytes) {
  for (const char* out : {"a", "b"})
    expect_done(
        small_square(8, {"--frames", "3", "--end", "0.3", "--size", "160x90", "--out", out}));
  const std::vector<std::string> files = files_in(directory / "a");
  EXPECT_EQ(files,
            (std::vector<std::string>{"film.png", "final.obj", "final_velocities.csv",
                                      "frame_0000.png", "frame_0001.png", "frame_0002.png",
                                      "frame_0003.png", "log.csv", "run.toml", "still.png"}));
  EXPECT_EQ(files_in(directory / "b"), files);
  for (const std::string& file : files) {
    std::string a = read_all(directory / "a" / file), b = read_all(directory / "b" / file);
    if (file == "log.csv") {
      a = without_milliseconds(a);
      b = without_milliseconds(b);
    }
    EXPECT_TRUE(a == b) << file << " differs";
  }
}

// A step depends on the state alone, and 17 significant digits keep the state. Equal up to
// rounding, as the reader of OBJ files may miss the last bit.
TEST_P(ProgramTest, ContinuedFromItsLastStateEndsWhereOneRunEnds) {
  write("continued.toml", read_all(GetParam().square()) +
                              "[start]\npositions = \"half/final.obj\"\n"
                              "velocities = \"half/final_velocities.csv\"\n");
  expect_done(small_square(8, {"--end", "0.2", "--no-pictures", "--out", "whole"}));
  expect_done(small_square(8, {"--end", "0.1", "--no-pictures", "--out", "half"}));
  expect_done({"continued.toml", "--cells", "8", "--end", "0.1", "--no-pictures", "--out", "rest"});
  const auto x = [&](const char* out) { return read_obj_vertices(directory / out / "final.obj"); };
  const auto v = [&](const char* out) {
    return read_velocities(directory / out / "final_velocities.csv", 81);
  };
  EXPECT_LT((x("rest") - x("whole")).norm(), 1e-13 * x("whole").norm());
  EXPECT_LT((v("rest") - v("whole")).norm(), 1e-12 * v("whole").norm());
  EXPECT_GT((x("half") - x("whole")).norm(), 1e-2 * x("whole").norm()) << "it moves on";
}

// run.toml is a scene, and its [run] brings the options: it makes the same run again.
TEST_P(ProgramTest, RunTomlMakesTheSameRunAgain) {
  std::filesystem::create_directory(directory / "start");
  write("start/mesh.obj", "v 0 0 0\nv 1 0 0\nv 0 0 -1\nv 1 0.1 -1\nf 1 2 3\nf 2 4 3\n");
  write("start/scene.toml",
        "[cloth]\nmesh = 'mesh.obj'\ndensity = 0.2\npins = [2]\n[gravity]\ng = 9.81\n"
        "[stretch]\nk = 10\n[shear]\nk = 5.0\n[time]\nh = 0.001\nend = 1\n"
        "[start]\npositions = 'mesh.obj'\n[camera]\nstill = 0.01\n");
  Arguments first = {"start/scene.toml", "--h",       "0.0005", "--end",        "0.02",
                     "--frames",         "2",         "--size", "80x45",        "--wireframe",
                     "--caption",        "--without", "shear",  "--strain=0.1", "--export=obj",
                     "--export=pc2"};
  const int step = GetParam().number();
  if (step >= 3) first.insert(first.end(), {"--newton", "3", "--guard=off"});
  if (step == 3) first.insert(first.end(), {"--solver=inverse"});
  if (step >= 4) first.insert(first.end(), {"--preconditioner=ic", "--tolerance=1e-6"});
  first.insert(first.end(), {"--out", "one"});
  expect_done(first);
  expect_done({"one/run.toml", "--out", "two"});
  ASSERT_EQ(files_in(directory / "two"), files_in(directory / "one"));
  for (const std::string& name : files_in(directory / "one"))
    if (name != "log.csv" && !name.ends_with(".png")) {
      EXPECT_EQ(read_all(directory / "two" / name), read_all(directory / "one" / name)) << name;
    }
  EXPECT_EQ(read_png(directory / "two/frame_0002.png").width, 80);

  expect_done({"one/run.toml", "--out", "three", "--frames", "1", "--size", "40x20"});
  EXPECT_EQ(read_png(directory / "three/frame_0001.png").width, 40)
      << "the command line goes before [run]";
}

INSTANTIATE_TEST_SUITE_P(Programs, ProgramTest, testing::ValuesIn(programs()), name_of);

// A step that is also a frame counts once. With the matrix as the paper prints it this cloth
// explodes, and from then on every step has more energy than the start.
TEST_F(ProgramDirectory, CountsAStepWithMoreEnergyThanTheStartOnce) {
  const std::string steps = "38";
  write("scene.toml",
        "[cloth]\nsize = [1.0, 1.0]\ncells = [12, 12]\ndiagonals = \"same\"\ndensity = 0.2\n"
        "pins = [\"top left\", \"top right\"]\n[gravity]\ng = 9.81\n"
        "[stretch]\nk = 3000.0\n[shear]\nk = 3000.0\n"
        "[time]\nh = 0.016666666666666666\nend = 0.6333333333333333\n");
  const auto gained = [&](const std::string& frames) {
    const Outcome outcome = run(
        program_called("step03_implicit"),
        {"scene.toml", "--jacobian", "bw98", "--frames", frames, "--no-pictures", "--out", frames});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return read_table(directory / frames / "log.csv").at("gained");
  };
  const std::vector<double> every_step = gained(steps), only_the_last = gained("1");
  ASSERT_EQ(every_step.size(), 39u);
  for (size_t step = 1; step < every_step.size(); ++step)
    EXPECT_LE(every_step[step], every_step[step - 1] + 1) << "step " << step;
  EXPECT_EQ(every_step.back(), only_the_last.back());
  EXPECT_GT(every_step.back(), 10) << "the energy does rise";
}

}  // namespace program_results_test
