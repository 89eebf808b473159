// The simulators give the bits of the steps themselves, and their counts are right.
#include <gtest/gtest.h>

#include "step02_damping/time_step.h"
#include "step05_bend/time_step.h"
#include "support/scenes.h"
#include "ways/simulator.h"

namespace simulator_test {

TestScene damped_sheet() {
  TestScene scene = sheet(6, Held::by_two_corners, 1000, 500, Gravity::on);
  scene.cloth.term<StretchTerm>()->kd = 0.02;
  return scene;
}

struct Result {
  State state;
  Counts counts;
};

Result run(const Configuration& configuration, TestScene scene, double h, int steps) {
  const auto simulator = make_simulator(configuration, scene.cloth);
  for (int i = 0; i < steps; ++i) simulator->step(h, scene.start);
  return {scene.start, simulator->counts()};
}

TEST(Simulators, AreTheStepsToTheLastBit) {
  TestScene scene = damped_sheet();
  State state = scene.start;
  step02::System two(scene.cloth);
  for (int i = 0; i < 30; ++i) step02::time_step(scene.cloth, 1e-4, state, two);
  EXPECT_EQ(run({2}, scene, 1e-4, 30).state.x, state.x);

  state = scene.start;
  step05::System five(scene.cloth);
  for (int i = 0; i < 30; ++i) step05::time_step(scene.cloth, 0.01, state, five);
  const Result configuration = run({5}, scene, 0.01, 30);
  EXPECT_EQ(configuration.state.x, state.x);
  EXPECT_EQ(configuration.counts.iterations, five.counts.iterations);
}

TEST(Simulators, CountForcesOfExplicitSteps) {
  const TestScene scene = sheet(6, Held::by_two_corners, 1000, 500, Gravity::on);
  const Result once = run({1}, scene, 1e-4, 1), often = run({1}, scene, 1e-4, 30);
  EXPECT_EQ(often.counts.forces, 30);
  EXPECT_EQ(often.counts.assemblies, 0);
  EXPECT_EQ(often.counts.products, 0);
  EXPECT_EQ(often.counts.bytes, 30 * once.counts.bytes);
  const long n = 7 * 7, triangles = 2 * 6 * 6;
  EXPECT_EQ(once.counts.bytes,
            24 * n * (1 + 3 + 7) + triangles * (long(sizeof(Triangle)) + 9 * 24));
}

// The products of a step: K v, and A Δv once before the first iteration and once in each.
TEST(Simulators, CountWhatAPlainImplicitStepDoes) {
  for (int step : {3, 4, 5}) {
    const Counts c = run({step}, damped_sheet(), 0.01, 10).counts;
    EXPECT_EQ(c.forces, 10);
    EXPECT_EQ(c.assemblies, 10);
    EXPECT_EQ(c.energies, 11) << "by the guard: after each step, and at the start of the first";
    EXPECT_EQ(c.redone, 0);
    EXPECT_EQ(c.products, step == 3 ? 10 : 20 + c.iterations);
    EXPECT_EQ(c.iterations > 0, step > 3);
  }
}

TEST(Simulators, CountTheEnergiesOfNewtonsMethod) {
  const Counts c = run({3, {.newton = 20}}, damped_sheet(), 0.01, 10).counts;
  EXPECT_GT(c.assemblies, 20);              // several iterations per step
  EXPECT_GE(c.energies, 1 + c.assemblies);  // at the start, and after each iteration …
  EXPECT_LE(c.energies, 3 * c.assemblies);
  // … each time with vᵀ D v. That is computed before each iteration, too, and D v for b.
  EXPECT_EQ(c.products, c.energies - 1 + 2 * c.assemblies);
}

TEST(Simulators, MoreMovesMoreBytes) {
  const auto bytes = [](const Configuration& configuration) {
    return run(configuration, damped_sheet(), 0.01, 10).counts.bytes;
  };
  EXPECT_LT(bytes({2}), bytes({3}));
  EXPECT_LT(bytes({3}), bytes({4, {.tolerance = 1e-1}}));
  EXPECT_LT(bytes({4, {.tolerance = 1e-1}}), bytes({4, {.tolerance = 1e-6}}));
  EXPECT_EQ(bytes({4}), bytes({5}));  // nothing bends
}

// Two corners hold a square metre: 3.5337/Δx √(k/ρ) is the largest frequency of the sheet at rest.
TEST(Simulators, KnowTheCriticalStep) {
  for (int step : {1, 5}) {
    TestScene scene = sheet(6, Held::by_two_corners, 1000, 1000, Gravity::on);
    const auto simulator = make_simulator({step}, scene.cloth);
    EXPECT_NEAR(critical_step(*simulator, scene.cloth, scene.start), 2 / 1499.23, 2e-6);
  }
}

}  // namespace simulator_test
