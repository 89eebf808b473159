// Checks the claims of a study: its orders, its crossover, its front, its commands.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "text/text_file.h"
#include "tradeoff/report.h"
#include "tradeoff/small_steps.h"

namespace tradeoff::tradeoff_test {

class TradeOff : public testing::Test {
 protected:
  void SetUp() override {
    directory =
        std::filesystem::temp_directory_path() /
        (std::string("tradeoff_") + testing::UnitTest::GetInstance()->current_test_info()->name());
    std::filesystem::remove_all(directory);
  }
  void TearDown() override { std::filesystem::remove_all(directory); }

  Study study_of(const Choice& choice) {
    Plan plan;
    plan.choice = choice;
    plan.out = directory;
    Study study = prepare(plan);
    find_references(plan, study);
    study.arguments = choice.scene + " --out " + for_shell(directory);
    return study;
  }

  Score run(const Study& study, const Configuration& configuration, long steps, size_t mesh = 0) {
    return run_trial(study.meshes[mesh], study.references[mesh], {configuration, steps}, 0.05,
                     baseline);
  }

  // The order of convergence between runs of `steps` and 2 `steps`.
  double order(const Study& study, const Configuration& configuration, long steps) {
    return std::log2(run(study, configuration, steps).error /
                     run(study, configuration, 2 * steps).error);
  }

  std::filesystem::path directory;
  Baseline baseline;
};

const Configuration implicit{4, {.tolerance = 1e-8}};

// The measured order of every method of order 1 must lie between 0.9 and 1.1.
TEST_F(TradeOff, SeesTheOrdersOfItsMethods) {
  for (const char* name : {"T", "C", "D"}) {
    const Study study = study_of({name});
    EXPECT_NEAR(study.references[0].order, 4, 0.2) << name;
    EXPECT_NEAR(order(study, {study.meshes[0].steps.front()}, 800), 1, 0.1) << name;
    EXPECT_NEAR(order(study, implicit, 800), 1, 0.1) << name;
    EXPECT_NEAR(order(study, {3}, 800), 1, 0.1) << name;
    EXPECT_NEAR(order(study, xpbd_of(4), 800), 1, 0.1) << name;
    EXPECT_NEAR(order(study, vbd_of(4), 800), 1, 0.1) << name;
  }
  const Study flap = study_of({"F"});
  EXPECT_EQ(flap.meshes[0].steps, std::vector{5}) << "only step 5 bends";
  for (const Configuration& way : {Configuration{5, {.tolerance = 1e-8}}, xpbd_of(4), vbd_of(4)})
    EXPECT_NEAR(order(flap, way, 800), 1, 0.1);
}

// Where the iterations of a step have converged, four times as many steps have a quarter of its error.
TEST_F(TradeOff, SeesThatSmallStepsAreMoreAccurateForTheSameWork) {
  const Study study = study_of({"curtain"});
  for (const Iterated& method : iterated_methods()) {
    const auto [sixteen, four, one] = small_step_errors(study, 0, method, 2048);
    EXPECT_NEAR(sixteen / four, 4, 0.2) << method.name;
    EXPECT_NEAR(four / one, 4, 0.6) << method.name;
  }
}

// On a stiffer cloth one sweep of VBD is too few: even with h = h_crit/7 it is farther from the truth than
// four sweeps in steps that are four times as long. XPBD and Newton's method do not mind.
TEST_F(TradeOff, SeesThatOneSweepOfVbdIsTooFewForAStiffCloth) {
  const Study study = study_of({"curtain", 1e4});
  for (const Iterated& method : iterated_methods()) {
    const auto [sixteen, four, one] = small_step_errors(study, 0, method, 4096);
    if (method.name == std::string("VBD"))
      EXPECT_GT(one, 2 * four);
    else
      EXPECT_NEAR(four / one, 4, 0.2) << method.name;
    EXPECT_GT(sixteen, 3 * four) << method.name;
  }
}

// The tables of errors in the lessons, which the program tradeoff measures in some minutes.
struct PrintedErrors {
  Configuration configuration;
  std::vector<std::pair<long, double>> of_steps;
};
struct Printed {
  Choice choice;
  std::vector<PrintedErrors> errors;
};

TEST_F(TradeOff, SeesTheErrorsThatTheLessonsPrint) {
  const auto cg = [](double tolerance) { return Configuration{4, {.tolerance = tolerance}}; };
  for (const Printed& printed : {
           Printed{{"curtain"}, {{{1}, {{62, 2.2e-3}, {117, 1.2e-3}, {233, 6.0e-4}}}}},
           Printed{{"damped-curtain"}, {{{2}, {{72, 2.0e-3}, {138, 1.0e-3}, {271, 5.2e-4}}}}},
           Printed{{"curtain", 1e5},
                   {{{3}, {{8, 1.1e-2}, {64, 2.7e-3}}},
                    {cg(1e-1), {{8, 1.3e-2}, {64, 5.0e-3}, {512, 9.7e-4}}},
                    {cg(1e-2), {{8, 1.1e-2}, {64, 2.9e-3}}},
                    {cg(1e-4), {{8, 1.1e-2}, {64, 2.7e-3}, {512, 2.1e-4}}}}},
           Printed{{"flap"},
                   {{{5}, {{8, 7.2e-2}, {16, 2.5e-2}, {32, 8.6e-3}, {64, 3.9e-3}}},
                    {{5, {.newton = 20}}, {{8, 1.4e-2}, {16, 8.4e-3}, {32, 5.6e-3}}}}},
       }) {
    const Study study = study_of(printed.choice);
    for (const auto& [configuration, errors] : printed.errors)
      for (const auto& [steps, error] : errors) {
        const double seen = run(study, configuration, steps).error;
        std::printf("%s, %s, %ld steps: %.2e, printed %.1e\n", printed.choice.scene.c_str(),
                    name_of(configuration).c_str(), steps, seen, error);
        EXPECT_NEAR(seen / error, 1, 0.04);
      }
  }
}

// The numbers come from an independent program, which takes a Runge-Kutta method of
// order 8 as its reference.
TEST_F(TradeOff, SeesTheErrorsOfAnIndependentProgram) {
  const Study study = study_of({"T"});
  EXPECT_NEAR(run(study, {1}, 400).error / 5.3e-5, 1, 0.2);
  EXPECT_NEAR(run(study, {4, {.jacobian = Jacobian::bw98, .tolerance = 1e-8}}, 400).error / 1.28e-3,
              1, 0.02);
}

TEST_F(TradeOff, JudgesTheStripByItsExactMotion) {
  const Study study = study_of({"W"});
  ASSERT_EQ(study.meshes.size(), 3u);
  std::vector<double> total;
  for (size_t mesh = 0; mesh < 3; ++mesh) {
    const Score score = run(study, {1}, 5000L << (3 * mesh / 2), mesh);
    EXPECT_LT(score.error, 0.05 * score.total_error) << "the mesh must cause most of the error";
    total.push_back(score.total_error);
  }
  EXPECT_GT(std::log2(total[0] / total[1]), 1.8) << "the order in the size of a cell must be 2";
  EXPECT_GT(std::log2(total[1] / total[2]), 1.9);
}

// On a soft cloth, at the same h below h_crit, explicit steps are more accurate and cheaper.
TEST_F(TradeOff, ExplicitStepsWinOnSoftClothBelowTheCriticalStep) {
  const Study study = study_of({"T"});
  const double end = study.meshes[0].scene.time.end;
  for (double part : {0.9, 0.5, 0.25}) {
    const long steps = std::lround(std::ceil(end / (part * study.h_crit[0])));
    const Score one = run(study, {1}, steps), four = run(study, implicit, steps);
    EXPECT_LT(10 * one.error, four.error) << part;
    EXPECT_LT(10 * one.counts.bytes, four.counts.bytes) << part;
  }
}

// Costs in bytes that move through memory, so that the test does not depend on a clock.
std::vector<Score> by_bytes(std::vector<Score> scores) {
  for (Score& score : scores) score.baselines = double(score.counts.bytes);
  return scores;
}

// The stiffer the cloth, the smaller the error down to which implicit steps are the cheapest.
TEST_F(TradeOff, FindsWhereExplicitStepsTakeOver) {
  const auto turn_of = [&](const Study& study) {
    std::vector<Score> scores;
    for (const Configuration& configuration :
         {Configuration{1}, Configuration{4, {.tolerance = 1e-2}}})
      for (long steps : step_counts(configuration, study.meshes[0].scene.time.end, study.h_crit[0]))
        scores.push_back(run(study, configuration, steps));
    EXPECT_FALSE(scores.front().done()) << "h = 2 h_crit must explode";
    return crossover(pareto_front(by_bytes(scores)));
  };
  EXPECT_FALSE(turn_of(study_of({"trampoline"}))) << "on a soft cloth explicit steps always win";

  const Study stiff = study_of({"curtain", 1e5});
  const auto turn = turn_of(stiff);
  ASSERT_TRUE(turn);
  EXPECT_GT(turn->first.h, 10 * stiff.h_crit[0]) << "an h that no explicit step survives";
  EXPECT_LT(turn->second.h, stiff.h_crit[0]);
  EXPECT_LT(turn->first.judged(), 2e-2);
  EXPECT_GT(turn->first.judged(), 1e-3);
  EXPECT_LT(turn->second.judged(), 1e-4);
}

// The standard output of a command.
std::string said_by(const std::string& command) {
  std::string text;
  FILE* pipe = popen(command.c_str(), "r");
  for (char line[256]; fgets(line, sizeof line, pipe);) text += line;
  return pclose(pipe) == 0 ? text : "failed: " + command + "\n" + text;
}

TEST_F(TradeOff, ItsCommandsGiveTheErrorsThatItPrints) {
  for (const auto& [scene, configuration, steps] :
       {std::tuple("curtain", Configuration{1}, 80L),
        std::tuple("trampoline", Configuration{4, {.tolerance = 1e-2}}, 50L),
        std::tuple("flap", Configuration{5, {.newton = 20, .preconditioner = "ic"}}, 50L),
        std::tuple("damped-curtain", Configuration{3, {.jacobian = Jacobian::bw98}}, 40L)}) {
    const Study study = study_of({scene});
    const Score printed = run(study, configuration, steps);
    ASSERT_EQ(printed.outcome, "done");
    const std::string said = said_by(command_of(study, printed) + " > /dev/null && " +
                                     scoring_command_of(study, printed));
    double error = 0;
    const size_t at = said.find("\nerror ");
    ASSERT_NE(at, std::string::npos) << said;
    ASSERT_EQ(std::sscanf(said.c_str() + at, " error %lf", &error), 1) << said;
    EXPECT_NEAR(error / printed.error, 1, 1e-5) << said;
  }
}

TEST_F(TradeOff, QuotesPathsForAShell) {
  EXPECT_EQ(for_shell("a/b.toml"), "a/b.toml");
  EXPECT_EQ(for_shell("b.toml"), "./b.toml");
  EXPECT_EQ(for_shell("my dir/b"), "'my dir/b'");
  EXPECT_EQ(for_shell("it's/b"), "'it'\\''s/b'");
}

// A user's file, in a directory whose name needs quotes.
TEST_F(TradeOff, StudiesAFile) {
  const std::filesystem::path file = directory / "my scenes" / "flap's.toml";
  std::filesystem::create_directories(file.parent_path());
  write_text(file, R"([cloth]
size = [0.5, 0.25]
cells = [4, 2]
diagonals = "same"
density = 0.2
pins = ["left"]
[gravity]
g = 9.81
[stretch]
k = 100.0
[shear]
k = 50.0
[time]
h = 0.001
end = 0.1
frames = 1
)");
  const Study study = study_of({file.string(), {}, 8});
  ASSERT_TRUE(study.can_judge());
  EXPECT_EQ(cells_of(study.meshes[0]), 8);
  EXPECT_EQ(study.meshes[0].steps, (std::vector{1, 3, 4}));
  const Score score = run(study, {1}, 200);
  EXPECT_EQ(said_by(command_of(study, score)).find("failed"), std::string::npos);
}

// A flap that is thrown round its edge, by more than a half turn. Each run of the reference begins
// with the folds of the start, not with those of the run before.
TEST_F(TradeOff, ItsReferenceForgetsTheFoldsOfTheRunBefore) {
  std::filesystem::create_directories(directory);
  const std::filesystem::path file = directory / "thrown.toml";
  write_text(directory / "v.csv", "vx,vy,vz\n0,0,0\n0,0,0\n0,4,0\n0,0,0\n0,0,0\n0,4,0\n");
  write_text(file, R"([cloth]
size = [1, 0.5]
cells = [2, 1]
density = 0.2
pins = [0, 1, 3, 4]
[stretch]
k = 1000
[shear]
k = 500
[bend]
k = 0.005
[start]
velocities = "v.csv"
[time]
h = 0.001
end = 0.5
frames = 1
)");
  const Study study = study_of({file.string()});
  ASSERT_TRUE(study.can_judge());
  const Score coarse = run(study, {5}, 1000), fine = run(study, {5}, 4000);
  EXPECT_LT(fine.error, 0.3 * coarse.error);
  EXPECT_LT(fine.energy_error, 0.3 * coarse.energy_error) << "the energy error must fall";
}

Score invented(double error, double cost, int step = 1) {
  Score score;
  score.trial.configuration.step = step;
  score.outcome = "done";
  score.error = error;
  score.baselines = cost;
  return score;
}

TEST_F(TradeOff, NothingOnTheFrontIsDominatedAndNothingElseIsNot) {
  std::vector<Score> scores;
  for (int i = 0; i < 200; ++i)
    scores.push_back(
        invented(0.3 * std::exp(std::sin(12.9898 * i)), std::exp(std::sin(78.233 * i))));
  scores.push_back(invented(unknown, 1e-9));
  scores.push_back(invented(1e-9, 1e-9));
  scores.back().outcome = "exploded in step 3 of 8";
  const auto dominates = [](const Score& a, const Score& b) {
    return a.error <= b.error && a.baselines <= b.baselines &&
           (a.error < b.error || a.baselines < b.baselines);
  };
  const std::vector<Score> front = pareto_front(scores);
  EXPECT_GT(front.size(), 3u);
  for (const Score& s : scores) {
    if (!s.done() || s.error != s.error) continue;
    const bool dominated = std::any_of(scores.begin(), scores.end(), [&](const Score& other) {
      return other.done() && dominates(other, s);
    });
    const bool on_front = std::any_of(front.begin(), front.end(), [&](const Score& other) {
      return other.error == s.error && other.baselines == s.baselines;
    });
    EXPECT_NE(dominated, on_front) << s.error << ", " << s.baselines;
  }
}

TEST_F(TradeOff, AnswersWhatIsCheapestAndWhatIsMostAccurate) {
  const std::vector<Score> scores = {invented(1e-1, 1, 3), invented(1e-2, 5, 3),
                                     invented(1e-3, 4, 1)};
  EXPECT_EQ(cheapest(scores, 0.05)->baselines, 4);
  EXPECT_EQ(cheapest(scores, 0.5)->baselines, 1);
  EXPECT_FALSE(cheapest(scores, 1e-4));
  EXPECT_EQ(most_accurate(scores, 3)->error, 1e-1);
  EXPECT_EQ(most_accurate(scores, 30)->error, 1e-3);
  EXPECT_FALSE(most_accurate(scores, 0.5));
  EXPECT_EQ(crossover(pareto_front(scores))->second.error, 1e-3);
}

// XPBD and VBD stand beside the steps: on the front, but in no answer that a program should repeat.
TEST_F(TradeOff, OffersOnlyWhatAProgramOfAStepHas) {
  Study study;
  study.meshes.push_back(make_study_scene({"curtain"}, directory));
  study.h_crit = {5e-3};
  study.references.resize(1);
  study.references[0].self_check = 1e-9;
  study.baseline_seconds = 1;
  study.out = directory;
  study.scores = {invented(1e-1, 1, 3), invented(1e-3, 4, 1), invented(1e-2, 2, 1)};
  study.scores[2].trial.configuration = xpbd_of(4);
  EXPECT_EQ(offered(study.scores).size(), 2u);
  EXPECT_EQ(pareto_front(study.scores).size(), 3u);
  for (Score& s : study.scores) s.cells = 6;

  const auto answer_to = [&](double error) {
    return answer(study, [&](const auto& scores) { return cheapest(scores, error); });
  };
  EXPECT_EQ(answer_to(0.5).find("xpbd"), std::string::npos) << "step 3 is the cheapest of all";
  const std::string said = answer_to(0.05);
  EXPECT_EQ(said.rfind("step01, ", 0), 0u) << said;
  EXPECT_NE(said.find("step01_explicit/step01_explicit"), std::string::npos) << said;
  EXPECT_NE(said.find("in no step's program: xpbd 4, "), std::string::npos) << said;
  EXPECT_EQ(answer_to(1e-4), "none of the ways that were tried");
  study.scores = {study.scores[2]};
  EXPECT_EQ(answer_to(0.05).rfind("none of the ways that were tried\n  Better", 0), 0u);
  EXPECT_EQ(advice(study), "No way that was tried came to a useful end; take smaller steps.");
}

TEST_F(TradeOff, NamesXpbdAndVbdByTheirSweeps) {
  EXPECT_EQ(name_of(xpbd_of(4)), "xpbd 4");
  EXPECT_EQ(name_of(vbd_of(16)), "vbd 16");
  EXPECT_EQ(kind_of(vbd_of(16)), "vbd");
  EXPECT_EQ(options_of(xpbd_of(4)), "");
  const std::vector<Configuration> few = configurations_of({1}, true);
  ASSERT_EQ(few.size(), 5u);
  EXPECT_EQ(name_of(few[1]) + name_of(few.back()), "xpbd 1vbd 4");
  EXPECT_EQ(step_counts(xpbd_of(4), 0.3, 5e-3), step_counts(implicit, 0.3, 5e-3));
}

// The stiffer the drop, the earlier it crumples.
TEST_F(TradeOff, RefusesToJudgeWhatItsReferenceCannotTell) {
  Study study;
  study.meshes.push_back(make_study_scene({"drop", 1e5}, directory));
  study.references.push_back(find_reference(study.meshes[0], 3));
  EXPECT_NE(study.references[0].refusal(), "");
  const Score score = run(study, {4}, 50);
  EXPECT_EQ(score.outcome, "done");
  EXPECT_NE(score.error, score.error) << "the error must be NaN";
  EXPECT_LT(score.lowest, -0.1);
  EXPECT_FALSE(study.can_judge());
}

TEST_F(TradeOff, GoesOnWhereItWasInterrupted) {
  std::filesystem::create_directories(directory);
  const std::filesystem::path file = directory / "tradeoff.csv";
  Score score = invented(1.25e-3, 17.5, 4);
  score.trial = {{4, {.newton = 20, .preconditioner = "ic", .tolerance = 1e-2}}, 64};
  score.cells = 6;
  score.counts.bytes = 123456789012;
  Score swept = score;
  swept.trial = {vbd_of(16), 64};
  {
    Record record(file, "one");
    EXPECT_EQ(record.found(), 0u);
    record.add(score, 0.01);
    record.add(swept, 0.01);
  }
  { Record(file, "another").add(invented(1, 1), 1); }
  std::ofstream(file, std::ios::app) << "one,step01,6,1";  // an incomplete row
  const Record again(file, "one");
  EXPECT_EQ(again.found(), 2u);
  EXPECT_TRUE(again.find(6, swept.trial));
  EXPECT_FALSE(again.find(6, {vbd_of(4), 64}));
  const Score* found = again.find(6, score.trial);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->error, 1.25e-3);
  EXPECT_EQ(found->baselines, 17.5);
  EXPECT_EQ(found->counts.bytes, 123456789012);
  EXPECT_EQ(found->outcome, "done");
  EXPECT_FALSE(again.find(6, {{4}, 64}));
  EXPECT_FALSE(again.find(8, score.trial));
  EXPECT_EQ(Record(file, "another").found(), 1u);
}

TEST_F(TradeOff, RefusesScenesThatItDoesNotKnow) {
  const auto refusal = [&](const Choice& choice) {
    try {
      make_study_scene(choice, directory);
    } catch (const BadInput& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(refusal({"nonsense"}).find("trampoline, curtain, flap"), std::string::npos);
  EXPECT_NE(refusal({"trampoline", {}, 12}).find("the trampoline has 6"), std::string::npos);
}

}  // namespace tradeoff::tradeoff_test
