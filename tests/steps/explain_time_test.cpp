// --explain says how long it takes, keeps to it, and names what it did not measure. The clock of these tests is
// not real: it goes on by the same time in every step.
#include <gtest/gtest.h>

#include "explain/explain.h"
#include "scene/scene.h"

namespace explain_time_test {

// A cloth that only falls, and how long a step of it takes.
class ExplainTime : public testing::Test {
 protected:
  std::string page(double budget, double seconds_of_step_) {
    seconds_of_step = seconds_of_step_;
    now = 100;
    testing::internal::CaptureStdout();
    const int code = explain(options, scene, simulate, TimeBudget(budget, [this] { return now; }));
    const std::string said = testing::internal::GetCapturedStdout();
    EXPECT_EQ(code, 0) << said;
    return said;
  }
  double taken() const { return now - 100; }

  const std::filesystem::path file =
      std::filesystem::path(SOURCE_DIRECTORY) / "step02_damping/scene.toml";
  const Scene scene = read_scene(file, "step02_damping", {.h = 0.01, .end = 1, .cells = 4});
  const Options options{.program = "step02_damping", .scene = file};
  double now = 0, seconds_of_step = 0;  // s

  const Simulate simulate = [this](const Cloth& of, const Method&) {
    const auto cloth = std::make_shared<Cloth>(of);
    const auto f = std::make_shared<VecX>();
    const auto gravity = [=](const State& state) -> const VecX& {
      f->setZero(state.x.size());
      if (cloth->gravity)
        for (int i = 0; i < cloth->vertices(); ++i)
          f->segment<3>(3 * i) = cloth->mass[3 * i] * *cloth->gravity;
      return *f;
    };
    return Simulation{.step =
                          [=, this](double h, State& state) {
                            now += seconds_of_step;
                            state.v += h * cloth->inverse_mass.cwiseProduct(gravity(state));
                            state.x += h * state.v;
                          },
                      .forces = gravity,
                      .counters = [] { return Counters(); },
                      .memory = [] { return Memory(); }};
  };
};

bool has(const std::string& page, const std::string& words) {
  return page.find(words) != std::string::npos;
}

// 100 steps of the scene are, with 8 runs and 6 parts, 1400 steps of 0.01 s, and a third more.
TEST_F(ExplainTime, IsSaidAtTheStart) {
  EXPECT_TRUE(has(page(20, 0.0001), "\n    measuring takes about 1 s\n"));
  EXPECT_TRUE(has(page(20, 0.01), "\n    measuring takes about 19 s\n"));
  EXPECT_TRUE(
      has(page(20, 1),
          "\n    measuring takes about 20 s; with all runs to the end it would take 1867 s\n"));
}

TEST_F(ExplainTime, IsAboutWhatWasForecast) {
  page(100, 0.01);
  EXPECT_GT(taken(), 12);
  EXPECT_LT(taken(), 19);
}

TEST_F(ExplainTime, IsKeptToHoweverLongAStepTakes) {
  for (const double step : {0.002, 0.02, 0.2, 2.0}) {
    const std::string said = page(20, step);
    EXPECT_LE(taken(), 20 + 3 * step) << said;
    EXPECT_EQ(has(said, "\nNot measured in 20 s\n") && has(said, "the motion"), step > 0.01)
        << said;
  }
}

TEST_F(ExplainTime, OfNothingLeavesTheCostsAndWhatSetsH) {
  const std::string said = page(0, 0);
  EXPECT_TRUE(has(said, "\nA step costs ")) << said;
  EXPECT_TRUE(has(said, "\nWhat sets h\n")) << said;
  EXPECT_TRUE(has(said, "the cloth had no time to move: no error can be estimated\n")) << said;
  EXPECT_TRUE(has(said,
                  "\nNot measured in 0 s\n"
                  "    6 of 6 values of h_crit without a part; 1 of 1 cheaper runs; the motion\n"))
      << said;
  EXPECT_FALSE(has(said, "nan")) << said;
}

// The first stop comes after one step. The runs that tell the error take eight steps to it, from 0.22 s to 0.66 s
// of the 0.7 s that all runs have; then there is time for one more.
TEST_F(ExplainTime, IsSpentOnTheErrorBeforeTheParts) {
  const std::string said = page(1, 0.055);
  EXPECT_TRUE(has(said, "    t = 0.01 s: ")) << said;
  EXPECT_TRUE(has(said, "--without gravity          0.941 mm")) << said;
  for (const std::string part : {"stretch", "shear", "damping"})
    EXPECT_TRUE(has(said, "--without " + part + std::string(17 - part.size(), ' ') +
                              "not measured: no time was left\n"))
        << said;
  EXPECT_TRUE(has(said,
                  "\nNot measured in 1 s\n    6 of 6 values of h_crit without a part; the motion "
                  "after t = 0.01 s\n"))
      << said;
}

}  // namespace explain_time_test
