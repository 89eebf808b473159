// The end of a run whose linear systems failed, and the page of --explain.
#include "program/run.h"

#include "explain/explain.h"
#include "program/run_toml.h"
#include "support/program_runner.h"

namespace run_test {

class RunTest : public ProgramDirectory {
 protected:
  // Two steps, of which so many have a system that failed; what the end says.
  std::string end_of(int failed, Jacobian jacobian) const {
    const StepProgram program = program_called("step04_cg");
    const Scene scene = read_scene(program.square(), program.name,
                                   {.h = 0.01, .end = 0.02, .frames = 1, .cells = 2});
    Options options{.program = program.name, .out = directory / "out", .pictures = false};
    options.concepts.implicit = true;
    options.method.jacobian = jacobian;
    ::Run one(options, scene);
    one.record(0, scene.start);
    Counters counts;
    for (int step = 0; step < 2; ++step) {
      if (step < failed) ++counts.indefinite;
      one.check(scene.start, counts);
    }
    one.record(1, scene.start);
    try {
      one.finish(scene.start);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "done";
  }
};

TEST_F(RunTest, IsNoResultIfTheSystemsOfAllStepsFailed) {
  EXPECT_EQ(end_of(1, Jacobian::definite), "done");
  EXPECT_NE(end_of(2, Jacobian::definite).find("failed in all 2 steps"), std::string::npos);
  EXPECT_EQ(read_table(directory / "out/log.csv").at("frame").size(), 2u);
  EXPECT_EQ(end_of(2, Jacobian::bw98), "done") << "there an indefinite matrix is no failure";
}

TEST_F(RunTest, ExplainTakesNoClothForOneAtRestBecauseItsSystemsFailed) {
  const StepProgram program = program_called("step04_cg");
  const Scene scene =
      read_scene(program.square(), program.name, {.h = 0.01, .end = 0.02, .frames = 1, .cells = 2});
  Options options{.program = program.name};
  options.concepts.implicit = options.concepts.iterative = true;
  const Simulate nothing_but_failures = [](const Cloth& cloth, const Method&) {
    const auto failed = std::make_shared<Counters>();
    return Simulation{.step = [=](double, State&) { ++failed->indefinite; },
                      .forces = [](const State& state) -> const VecX& { return state.v; },
                      .counters = [=] { return *failed; },
                      .memory = [&cloth] { return Memory{.vectors = size_t(cloth.mass.size())}; }};
  };
  try {
    explain(options, scene, nothing_but_failures);
    ADD_FAILURE() << "a page was printed to the end";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("failed in all"), std::string::npos) << error.what();
  }
}

// A list with one empty word would be an argument that no program knows.
TEST(RunToml, OfARunWithoutOptionsHasAnEmptyList) {
  const std::string text = run_toml({.program = "step01_explicit"}, "");
  EXPECT_NE(text.find("\noptions = []\n"), std::string::npos) << text;
}

}  // namespace run_test
