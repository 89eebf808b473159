// tradeoff [scene]: compares the error and the time of all configurations on one scene.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <iostream>

#include "program/option_checks.h"
#include "support/text.h"
#include "text/text_file.h"
#include "tradeoff/report.h"
#include "tradeoff/small_steps.h"

namespace {

using namespace tradeoff;

struct Arguments {
  Plan plan;
  std::optional<double> budget, seconds;
  std::optional<std::filesystem::path> score;
  bool small_steps = false;
};

std::string scenes_for_help() {
  std::string text = "Built-in scenes:\n";
  for (const BuiltIn& scene : built_in_scenes())
    text += format("  %-15s %-5s %s\n", scene.name, scene.letter, scene.what);
  return text + "Exit code 1: --budget or --seconds has no answer, or the study broke off.\n";
}

// The arguments, as a user would type them again.
std::string arguments_of(const Plan& plan, bool with_out) {
  std::string text =
      is_built_in(plan.choice) ? short_name(plan.choice) : for_shell(plan.choice.scene);
  if (plan.choice.k) text += " --k " + number(*plan.choice.k);
  if (plan.choice.cells) text += " --cells " + std::to_string(*plan.choice.cells);
  if (plan.quick) text += " --quick";
  return with_out ? text + " --out " + for_shell(plan.out) : text;
}

// Each study has a directory of its own.
std::filesystem::path own_directory(const Plan& plan) {
  std::string name = short_name(plan.choice);
  if (plan.choice.k) name += "_k" + number(*plan.choice.k);
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
  std::fflush(stdout);
}

// Judges a run of a step's program by its positions. The energy is not judged: the files do not
// tell whether a fold was wound beyond a half turn.
int score_run(const Arguments& arguments, Study& study) {
  if (study.meshes.size() > 1)
    throw BadInput("--score: this scene has several meshes; name the one of the run with --cells");
  const StudyScene& mesh = study.meshes.front();
  const std::filesystem::path file = *arguments.score / "final.obj";
  const VecX x = read_obj_vertices(file);
  if (x.size() != mesh.scene.start.x.size())
    throw BadInput(file.string() + ": has " + std::to_string(x.size() / 3) +
                   " vertices, but the cloth has " + std::to_string(mesh.scene.cloth.vertices()) +
                   "; it must be a run of this scene");
  find_references(arguments.plan, study);
  if (!study.can_judge()) return 1;
  Score score;
  Cloth cloth = mesh.scene.cloth;
  judge(mesh, study.references.front(), cloth, {x, VecX::Zero(x.size())}, score);
  std::printf("error %.6e of the size; largest stretch wrong by %.3e\n", score.judged(),
              score.stretch_error);
  return 0;
}

// Answers --budget and --seconds. Returns false if the programs of the steps have no answer to one of them.
bool answers(const Arguments& arguments, const Study& study) {
  bool all = true;
  const auto ask = [&](const std::string& question, const Question& best) {
    std::printf("\n%s: %s\n", question.c_str(), answer(study, best).c_str());
    all = all && best(offered(study.scores));
  };
  if (arguments.budget)
    ask(format("The cheapest way to an error of %g", *arguments.budget),
        [&](const auto& scores) { return cheapest(scores, *arguments.budget); });
  if (arguments.seconds)
    ask(format("The most accurate way within %g s", *arguments.seconds), [&](const auto& scores) {
      return most_accurate(scores, *arguments.seconds / study.baseline_seconds);
    });
  return all;
}

int run(Arguments& arguments) {
  Plan& plan = arguments.plan;
  const bool out_is_given = !plan.out.empty();
  if (!out_is_given) plan.out = own_directory(plan);
  Study study = prepare(plan);
  study.arguments = arguments_of(plan, out_is_given);
  print_scene(study);
  if (arguments.score) return score_run(arguments, study);
  find_references(plan, study);
  if (arguments.small_steps && study.can_judge()) compare_small_steps(study);
  if (arguments.small_steps) return study.can_judge() ? 0 : 1;
  if ((arguments.budget || arguments.seconds) && !study.can_judge()) {
    std::printf(
        "so there is no answer to --budget or --seconds; without them, statistics are compared\n");
    return 1;
  }
  run_trials(plan, study);
  print_tables(study);
  draw_plot(study);
  std::printf("\n%s\n", advice(study).c_str());
  return answers(arguments, study) ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  Arguments arguments;
  Plan& plan = arguments.plan;
  plan.choice.scene = "drop";
  CLI::App app(
      "What accuracy costs: every way that the five steps offer, with XPBD and VBD, on one scene");
  app.set_help_flag("--help", "list the options");
  app.footer(scenes_for_help());
  app.add_option("scene", plan.choice.scene, "a built-in scene or a scene.toml; drop if absent");
  app.add_option("--out", plan.out, "where everything goes; out/tradeoff/SCENE if absent")
      ->option_text("DIR");
  app.add_flag("--quick", plan.quick, "fewer ways and steps, under a minute");
  app.add_option("--budget", arguments.budget, "name the cheapest way to this error")
      ->check(positive_number)
      ->option_text("ERROR");
  app.add_option("--seconds", arguments.seconds, "name the most accurate way within this time")
      ->check(positive_number)
      ->option_text("S");
  app.add_option("--k", plan.choice.k, "stiffness of a built-in scene, N/m")
      ->check(positive_number)
      ->option_text("K");
  app.add_option("--cells", plan.choice.cells, "along u")
      ->check(positive_integer)
      ->option_text("N");
  app.add_flag("--small-steps", arguments.small_steps,
               "compare one step of n iterations with n steps of one, and nothing else");
  app.add_option("--score", arguments.score, "judge this run of a step's program, and run nothing")
      ->check(CLI::ExistingDirectory)
      ->option_text("DIR");
  try {
    app.parse(argc, argv);
    return run(arguments);
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    std::cerr << "tradeoff: " << one_line(error.what()) << " (--help lists the options)\n";
    return 2;
  } catch (const BadInput& error) {
    std::cerr << "tradeoff: " << error.what() << "\n";
    return 2;
  } catch (const std::exception& error) {
    std::cerr << "tradeoff: " << error.what() << "\n";
    return 1;
  }
}
