// What to take, in a sentence; and the commands that do it.
#include <algorithm>

#include "tradeoff/report.h"
#include "tradeoff/text.h"

namespace tradeoff {

namespace {

// The smallest of the errors asked for that explicit and implicit ways both reach, at what cost.
struct Comparison {
  double error;
  Score explicit_way, implicit_way;

  double times() const { return implicit_way.baselines / explicit_way.baselines; }
};

std::optional<Comparison> compare(const Study& study) {
  std::vector<Score> explicit_ways, implicit_ways;
  for (const Score& s : study.scores)
    (s.trial.way.step < 3 ? explicit_ways : implicit_ways).push_back(s);
  std::optional<Comparison> last;
  for (double error : asked_errors) {
    const auto a = cheapest(explicit_ways, error), b = cheapest(implicit_ways, error);
    if (a && b) last = {error, *a, *b};
  }
  return last;
}

std::string way_of(const Score& s) {
  return name_of(s.trial.way);
}

std::string explicit_below(const Study& study, const std::vector<Score>& front, const Score& last) {
  return format(
      "Down to an error of %.1e implicit steps are the cheapest (%s with h = %.3g s, %.3g of "
      "h_crit, "
      "for %.1e); below it explicit ones are, as long as h_crit = %.2g s allows",
      last.judged(), way_of(front.front()).c_str(), front.front().h,
      front.front().h / study.h_crit.front(), front.front().judged(), study.h_crit.front());
}

std::string always_explicit(const Study& study) {
  return format(
      "Take explicit steps for every error: h_crit = %.2g s is no burden to so soft a cloth",
      study.h_crit.front());
}

std::string always_implicit(const Study& study, const std::vector<Score>& front) {
  const bool choice = study.meshes.front().steps.front() < 3;
  return format(
      "%s: %s where an error of %.1e will do, %s down to %.1e",
      choice ? "Take implicit steps for every error" : "No explicit step can simulate this scene",
      way_of(front.front()).c_str(), front.front().judged(), way_of(front.back()).c_str(),
      front.back().judged());
}

std::string from_here(const std::filesystem::path& path) {
  return std::filesystem::proximate(path).string();
}

}  // namespace

std::string advice(const Study& study) {
  const std::vector<Score> front = distinct(pareto_front(study.scores));
  if (!study.can_judge() || front.empty())
    return "No way can be told to be nearer to the truth than another; take the cheapest whose "
           "energy, "
           "lowest point and stretch you can live with.";
  const auto turn = crossover(front);
  if (!turn && front.front().trial.way.step > 2) return always_implicit(study, front) + ".";
  const std::string which =
      turn ? explicit_below(study, front, turn->first) : always_explicit(study);
  const auto both = compare(study);
  if (!both) return which + ".";
  return which +
         format("; at %.0e they take %.3g ms, the best implicit way (%s) %.2g times as long.",
                both->error, 1e3 * study.seconds(both->explicit_way),
                way_of(both->implicit_way).c_str(), both->times());
}

std::string command_of(const Study& study, const Score& s) {
  const auto mesh =
      std::find_if(study.meshes.begin(), study.meshes.end(),
                   [&](const StudyScene& candidate) { return cells_of(candidate) == s.cells; });
  const std::string program = program_of(s.trial.way.step);
  return from_here(std::filesystem::path(PROGRAM_DIRECTORY) / program / program) + " " +
         from_here(mesh->scene.file) + format(" --h %.17g", s.h) + options_of(s.trial.way) +
         mesh->options + " --frames 1 --no-pictures --out " + from_here(study.out / "run");
}

std::string scoring_command_of(const Study& study, const Score& s) {
  return from_here(std::filesystem::path(PROGRAM_DIRECTORY) / "tests/tradeoff/tradeoff") + " " +
         study.arguments + (study.meshes.size() > 1 ? format(" --cells %d", s.cells) : "") +
         " --score " + from_here(study.out / "run");
}

}  // namespace tradeoff
