// The advice of a study, in one sentence, and the commands that repeat its runs.
#include <algorithm>

#include "support/text.h"
#include "tradeoff/report.h"

namespace tradeoff {

namespace {

// The smallest of the asked errors that both explicit and implicit steps reach, and their costs.
struct Comparison {
  double error;
  Score explicit_way, implicit_way;

  double times() const { return implicit_way.baselines / explicit_way.baselines; }
};

std::optional<Comparison> compare(const Study& study) {
  std::vector<Score> explicit_scores, implicit_scores;
  for (const Score& s : offered(study.scores))
    (is_explicit(s.trial.configuration) ? explicit_scores : implicit_scores).push_back(s);
  std::optional<Comparison> last;
  for (double error : asked_errors) {
    const auto a = cheapest(explicit_scores, error), b = cheapest(implicit_scores, error);
    if (a && b) last = {error, *a, *b};
  }
  return last;
}

std::string way_of(const Score& s) {
  return name_of(s.trial.configuration);
}

bool takes_explicit_steps(const Score& s) {
  return is_explicit(s.trial.configuration);
}

// The front starts with implicit configurations, starts with explicit ones, or has
// only one of the two kinds.
std::string which(const Study& study, const std::vector<Score>& front) {
  const Score &cheap = front.front(), &best = front.back();
  if (const auto turn = crossover(front))
    return format(
        "Down to an error of %.1e implicit steps are the cheapest (%s with h = %.3g s, %.3g "
        "h_crit); below "
        "it explicit ones are, as long as h_crit = %.2g s allows",
        turn->first.judged(), way_of(turn->first).c_str(), turn->first.h,
        turn->first.h / study.h_crit_of(turn->first), study.h_crit_of(turn->second));
  if (std::all_of(front.begin(), front.end(), takes_explicit_steps))
    return format(
        "Take explicit steps for every error: h_crit = %.2g s is no burden to so soft a cloth",
        study.h_crit_of(cheap));
  if (takes_explicit_steps(cheap)) {
    const auto last = std::find_if_not(front.begin(), front.end(), takes_explicit_steps) - 1;
    return format("Explicit steps are the cheapest down to an error of %.1e; %s comes to %.1e",
                  last->judged(), way_of(best).c_str(), best.judged());
  }
  const bool choice = study.meshes.front().steps.front() < 3;
  return format(
      "%s: %s where an error of %.1e will do, %s down to %.1e",
      choice ? "Take implicit steps for every error" : "No explicit step can simulate this scene",
      way_of(cheap).c_str(), cheap.judged(), way_of(best).c_str(), best.judged());
}

}  // namespace

std::string advice(const Study& study) {
  if (!study.can_judge())
    return "No way can be told to be nearer to the truth than another; take the cheapest whose "
           "energy, lowest "
           "point and stretch you can live with.";
  const std::vector<Score> front = distinct(pareto_front(offered(study.scores)));
  if (front.empty()) return "No way that was tried came to a useful end; take smaller steps.";
  const auto turn = crossover(front);
  const auto both = compare(study);
  std::string text = which(study, front);
  if (both && takes_explicit_steps(front.back()) && (!turn || both->error < turn->first.judged()))
    text += format("; at %.0e they take %.3g ms, the best implicit way (%s) %.2g times as long",
                   both->error, 1e3 * study.seconds(both->explicit_way),
                   way_of(both->implicit_way).c_str(), both->times());
  return text + ".";
}

std::string answer(const Study& study, const Question& best) {
  const auto said = [&](const Score& s) {
    return format("%s, h = %.3g s; error %.6e, %.3g s of stepping", way_of(s).c_str(), s.h,
                  s.judged(), study.seconds(s));
  };
  const auto of_step = best(offered(study.scores)), of_all = best(study.scores);
  std::string text = "none of the ways that were tried";
  if (of_step)
    text = said(*of_step) + "\n  " + command_of(study, *of_step) + " && \\\n  " +
           scoring_command_of(study, *of_step);
  if (of_all && !is_of_step(of_all->trial.configuration))
    text += "\n  Better, but in tests/ways and in no step's program: " + said(*of_all);
  return text;
}

std::string command_of(const Study& study, const Score& s) {
  const auto mesh =
      std::find_if(study.meshes.begin(), study.meshes.end(),
                   [&](const StudyScene& candidate) { return cells_of(candidate) == s.cells; });
  const std::string program = program_of(s.trial.configuration.step);
  return for_shell(std::filesystem::path(PROGRAM_DIRECTORY) / program / program) + " " +
         for_shell(mesh->scene.file) + " --h " + number(s.h) + options_of(s.trial.configuration) +
         mesh->options + " --frames 1 --no-pictures --out " + for_shell(study.out / "run");
}

std::string scoring_command_of(const Study& study, const Score& s) {
  return for_shell(std::filesystem::path(PROGRAM_DIRECTORY) / "tests/tradeoff/tradeoff") + " " +
         study.arguments + (study.meshes.size() > 1 ? format(" --cells %d", s.cells) : "") +
         " --score " + for_shell(study.out / "run");
}

}  // namespace tradeoff
