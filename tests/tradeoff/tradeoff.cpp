// tradeoff [scene]: what accuracy costs, and what speed costs in accuracy.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <iostream>

#include "scene/velocities.h"
#include "tradeoff/report.h"

namespace {

using namespace tradeoff;

struct Arguments {
  Plan plan;
  std::optional<double> budget, seconds;
  std::optional<std::filesystem::path> score;
};

std::string scenes_for_help() {
  std::string text = "Built-in scenes:\n";
  for (const BuiltIn& scene : built_in_scenes()) {
    char line[160];
    std::snprintf(line, sizeof line, "  %-15s %-5s %s\n", scene.name, scene.letter, scene.what);
    text += line;
  }
  return text;
}

// As the user would type it again.
std::string arguments_of(const Plan& plan, bool with_out) {
  std::string text = plan.choice.scene;
  if (plan.choice.k) text += " --k " + CLI::detail::to_string(*plan.choice.k);
  if (plan.choice.cells) text += " --cells " + std::to_string(*plan.choice.cells);
  if (plan.quick) text += " --quick";
  return with_out ? text + " --out " + plan.out.string() : text;
}

// Each study has a directory of its own.
std::filesystem::path own_directory(const Plan& plan) {
  std::string name = std::filesystem::path(plan.choice.scene).stem();
  if (plan.choice.k) name += "_k" + CLI::detail::to_string(*plan.choice.k);
  if (plan.choice.cells) name += "_" + std::to_string(*plan.choice.cells);
  if (plan.quick) name += "_quick";
  return std::filesystem::path("out/tradeoff") / name;
}

void print_scene(const Study& study) {
  for (size_t i = 0; i < study.meshes.size(); ++i) {
    const StudyScene& mesh = study.meshes[i];
    std::printf("%s: %d vertices, %g s, h_crit = %.3g s at the start\n", mesh.name.c_str(),
                mesh.scene.cloth.vertices(), mesh.scene.time.end, study.h_crit[i]);
  }
  for (const std::string& reason : study.meshes.front().not_tried)
    std::printf("  not tried: %s\n", reason.c_str());
  print_references(study);
}

// A run of a step's program, judged.
int score_run(const Arguments& arguments, const Study& study) {
  for (size_t i = 0; i < study.meshes.size(); ++i) {
    const StudyScene& mesh = study.meshes[i];
    const State state{
        read_obj_vertices(*arguments.score / "final.obj"),
        read_velocities(*arguments.score / "final_velocities.csv", mesh.scene.cloth.vertices())};
    Score score;
    judge(mesh, study.references[i], state, score);
    if (const std::string refusal = study.references[i].refusal(); !refusal.empty())
      std::printf("no error is told: %s\n", refusal.c_str());
    else
      std::printf("error %.6e of the size; energy %.3e, stretch %.3e\n", score.judged(),
                  score.energy_error, score.stretch_error);
  }
  return 0;
}

// The answer to --budget and --seconds; false where there is none.
bool answer(const Study& study, const std::optional<Score>& best, const std::string& question) {
  if (!best) {
    std::printf("\n%s: none of the ways that were tried\n", question.c_str());
    return false;
  }
  std::printf("\n%s: %s, h = %.3g s; error %.6e, %.3g s\n  %s\n  %s\n", question.c_str(),
              name_of(best->trial.way).c_str(), best->h, best->judged(), study.seconds(*best),
              command_of(study, *best).c_str(), scoring_command_of(study, *best).c_str());
  return true;
}

int run(Arguments& arguments) {
  Plan& plan = arguments.plan;
  const bool own_out = !plan.out.empty();
  if (!own_out) plan.out = own_directory(plan);
  Study study = prepare(plan);
  study.arguments = arguments_of(plan, own_out);
  print_scene(study);
  if (arguments.score) return score_run(arguments, study);
  run_trials(plan, study);
  print_tables(study);
  draw_plot(study);
  std::printf("\n%s\n", advice(study).c_str());
  char question[80];
  bool answered = true;
  if (arguments.budget) {
    std::snprintf(question, sizeof question, "The cheapest way to an error of %g",
                  *arguments.budget);
    answered &= answer(study, cheapest(study.scores, *arguments.budget), question);
  }
  if (arguments.seconds) {
    std::snprintf(question, sizeof question, "The most accurate way within %g s",
                  *arguments.seconds);
    answered &= answer(
        study, most_accurate(study.scores, *arguments.seconds / study.baseline_seconds), question);
  }
  return answered ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  Arguments arguments;
  Plan& plan = arguments.plan;
  plan.choice.scene = "drop";
  CLI::App app("What accuracy costs: every way that the five steps offer, on one scene");
  app.footer(scenes_for_help());
  app.add_option("scene", plan.choice.scene, "a built-in scene or a scene.toml; drop if absent");
  app.add_option("--out", plan.out, "where everything goes; out/tradeoff/SCENE if absent")
      ->option_text("DIR");
  app.add_flag("--quick", plan.quick, "fewer ways and steps, under a minute");
  app.add_option("--budget", arguments.budget, "name the cheapest way to this error")
      ->check(CLI::PositiveNumber)
      ->option_text("ERROR");
  app.add_option("--seconds", arguments.seconds, "name the most accurate way within this time")
      ->check(CLI::PositiveNumber)
      ->option_text("S");
  app.add_option("--k", plan.choice.k, "stiffness of a built-in scene, N/m")
      ->check(CLI::PositiveNumber)
      ->option_text("K");
  app.add_option("--cells", plan.choice.cells, "along u")
      ->check(CLI::PositiveNumber)
      ->option_text("N");
  app.add_option("--score", arguments.score, "judge this run of a step's program, and run nothing")
      ->check(CLI::ExistingDirectory)
      ->option_text("DIR");
  try {
    app.parse(argc, argv);
    return run(arguments);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const BadInput& error) {
    std::cerr << "tradeoff: " << error.what() << "\n";
    return 2;
  } catch (const std::exception& error) {
    std::cerr << "tradeoff: " << error.what() << "\n";
    return 1;
  }
}
