#include "tradeoff/report.h"

#include <algorithm>
#include <cstdio>

#include "tradeoff/text.h"

namespace tradeoff {

namespace {

const std::vector<double> asked = {1e-1, 1e-2, 1e-3, 1e-4, 1e-5};  // errors

// A kind: a way, whatever its tolerance.
std::string kind_of(Way way) {
  way.method.tolerance = Method{}.tolerance;
  std::string name = name_of(way);
  if (const size_t at = name.find(" 1e-4"); at != std::string::npos) name.erase(at, 5);
  return name;
}

std::vector<std::string> kinds_of(const std::vector<Score>& scores) {
  std::vector<std::string> kinds;
  for (const Score& score : scores)
    if (std::find(kinds.begin(), kinds.end(), kind_of(score.trial.way)) == kinds.end())
      kinds.push_back(kind_of(score.trial.way));
  return kinds;
}

std::vector<Score> of_kind(const std::vector<Score>& scores, const std::string& kind) {
  std::vector<Score> kept;
  for (const Score& score : scores)
    if (kind_of(score.trial.way) == kind) kept.push_back(score);
  return kept;
}

void print_kinds(const Study& study) {
  std::printf(
      "\nMilliseconds to an error of at most …, by the cheapest h, tolerance%s of each way\n\n",
      study.meshes.size() > 1 ? " and mesh" : "");
  std::printf("  %-34s", "");
  for (double error : asked) std::printf("%9.0e", error);
  std::printf("%12s\n", "smallest");
  for (const std::string& kind : kinds_of(study.scores)) {
    const std::vector<Score> scores = of_kind(study.scores, kind);
    std::printf("  %-34s", kind.c_str());
    for (double error : asked) {
      const auto best = cheapest(scores, error);
      std::printf("%9s", best ? format("%.3g", 1e3 * study.seconds(*best)).c_str() : "-");
    }
    const auto finest = most_accurate(scores, 1e300);
    std::printf("%12s\n", finest ? format("%.1e", finest->judged()).c_str() : "-");
  }
}

void print_front(const Study& study) {
  const bool meshes = study.meshes.size() > 1;
  std::printf(
      "\nThe Pareto front: nothing else is as accurate for less%s\n\n"
      "  %9s %9s %9s %9s %9s  %-30s %8s %8s %8s %9s%s\n",
      meshes ? "; errors against the exact motion" : "", "error", "energy", "stretch", "ms", "h",
      "way", "forces", "systems", "products", "MB moved", meshes ? "  cells" : "");
  double last = 1e300;
  for (const Score& s : pareto_front(study.scores)) {
    if (s.judged() > 0.9 * last) continue;  // as good as the one before
    last = s.judged();
    std::printf("  %9.1e %9.1e %9.1e %9.3g %9.3g  %-30s %8ld %8ld %8ld %9.3g", s.judged(),
                s.energy_error, s.stretch_error, 1e3 * study.seconds(s), s.h,
                name_of(s.trial.way).c_str(), s.counts.forces, s.counts.assemblies,
                s.counts.products, 1e-6 * double(s.counts.bytes));
    if (meshes) std::printf("%7d", s.cells);
    std::printf("\n");
  }
}

// Every way at its shortest step that came to an end, where positions cannot be compared.
void print_statistics(const Study& study) {
  std::printf(
      "\nNo error can be told, so only what the cloth is like at the end: of each way the largest "
      "and "
      "the\nsmallest h that came to an end\n\n  %-30s %10s %10s %10s %10s %10s\n",
      "way", "h", "ms", "energy/J", "lowest/m", "stretch");
  const auto print = [&](const Score& s) {
    std::printf("  %-30s %10.3g %10.3g %10.4f %10.4f %10.4f\n", name_of(s.trial.way).c_str(), s.h,
                1e3 * study.seconds(s), s.energy, s.lowest, s.stretch);
  };
  for (const std::string& kind : kinds_of(study.scores)) {
    std::vector<Score> done;
    for (const Score& score : of_kind(study.scores, kind))
      if (score.done()) done.push_back(score);
    if (done.empty()) continue;
    const auto by_h = [](const Score& a, const Score& b) { return a.h < b.h; };
    const auto [finest, coarsest] = std::minmax_element(done.begin(), done.end(), by_h);
    print(*coarsest);
    if (finest->h < coarsest->h) print(*finest);
  }
}

// What broke off, counted: nothing is left out in silence.
void print_failures(const Study& study) {
  std::vector<std::pair<std::string, int>> reasons;
  for (const Score& score : study.scores) {
    if (score.done()) continue;
    const std::string reason = score.outcome.substr(0, score.outcome.find(" in step"));
    auto found = std::find_if(reasons.begin(), reasons.end(),
                              [&](const auto& r) { return r.first == reason; });
    if (found == reasons.end()) found = reasons.insert(reasons.end(), {reason, 0});
    ++found->second;
  }
  const auto sum = [&](auto of) {
    long total = 0;
    for (const Score& score : study.scores) total += of(score.counts) > 0;
    return total;
  };
  std::printf("\n");
  for (const auto& [reason, count] : reasons)
    std::printf("  %d of %zu runs: %s\n", count, study.scores.size(), reason.c_str());
  const auto say = [&](const char* what, long count) {
    if (count > 0) std::printf("  %ld of %zu runs %s\n", count, study.scores.size(), what);
  };
  say("met a matrix that was not positive definite",
      sum([](const Counts& c) { return c.indefinite; }));
  say("left a system unsolved at --max-iterations", sum([](const Counts& c) { return c.capped; }));
  say("had steps in which Newton's method did not converge",
      sum([](const Counts& c) { return c.unconverged; }));
}

std::string from_here(const std::filesystem::path& path) {
  return std::filesystem::proximate(path).string();
}

std::string h_beside_h_crit(const Study& study, const Score& s) {
  return format("h = %.3g s, %.3g of h_crit", s.h, s.h / study.h_crit.front());
}

}  // namespace

void print_references(const Study& study) {
  for (size_t i = 0; i < study.meshes.size(); ++i) {
    const Reference& r = study.references[i];
    std::printf("  reference: %ld and %ld steps of order 4 end %.1e of the size apart", r.steps / 2,
                r.steps, r.self_check);
    if (r.order == r.order) std::printf(" (order seen: %.2f)", r.order);
    std::printf(";\n  what begins 1 nm elsewhere ends %.3g nm elsewhere\n", r.growth);
    if (const std::string refusal = r.refusal(); !refusal.empty())
      std::printf("  no error is told: %s\n", refusal.c_str());
    else
      std::printf("  errors from %.0e of the size on can be told (%.1f s)\n", r.floor(), r.seconds);
  }
}

void print_tables(const Study& study) {
  if (study.can_judge()) {
    print_kinds(study);
    print_front(study);
  } else {
    print_statistics(study);
  }
  print_failures(study);
}

std::string advice(const Study& study) {
  const std::vector<Score> front = pareto_front(study.scores);
  if (!study.can_judge() || front.empty())
    return "No way can be told to be nearer to the truth than another; take the cheapest whose "
           "energy, "
           "lowest point and stretch you can live with.";
  std::vector<Score> steps12, steps345;
  for (const Score& s : study.scores) (s.trial.way.step < 3 ? steps12 : steps345).push_back(s);
  const auto both_at = [&](double error) {
    return std::pair(cheapest(steps12, error), cheapest(steps345, error));
  };
  // The smallest error that both kinds reach.
  std::optional<double> common;
  for (double error : asked)
    if (const auto [a, b] = both_at(error); a && b) common = error;
  const auto times = [&](const Score& dear, const Score& cheap) {
    return format("%.2g", dear.baselines / cheap.baselines);
  };
  if (const auto turn = crossover(front))
    return format(
               "Down to an error of %.1e implicit steps are the cheapest (%s, %s); below it "
               "explicit ones "
               "are (%s, as long as h_crit = %.2g s allows)",
               turn->first.judged(), name_of(front.front().trial.way).c_str(),
               h_beside_h_crit(study, front.front()).c_str(),
               name_of(turn->second.trial.way).c_str(), study.h_crit.front()) +
           (common
                ? format(": %s times cheaper at %.0e.",
                         times(*both_at(*common).second, *both_at(*common).first).c_str(), *common)
                : ".");
  if (front.front().trial.way.step < 3)
    return format(
               "Take explicit steps (%s) for every error: h_crit = %.2g s is no burden to so soft "
               "a cloth",
               name_of(front.front().trial.way).c_str(), study.h_crit.front()) +
           (common ? ", and at " + format("%.0e", *common) + " they are " +
                         times(*both_at(*common).second, *both_at(*common).first) +
                         " times cheaper than the best implicit way, " +
                         name_of(both_at(*common).second->trial.way) + "."
                   : ".");
  return "Take implicit steps for every error: " + name_of(front.front().trial.way) + " where " +
         format("%.1e", front.front().judged()) + " will do, " + name_of(front.back().trial.way) +
         " down to " + format("%.1e", front.back().judged()) + ".";
}

std::string command_of(const Study& study, const Score& s) {
  const auto mesh =
      std::find_if(study.meshes.begin(), study.meshes.end(), [&](const StudyScene& candidate) {
        return !candidate.scene.cloth.grid || candidate.scene.cloth.grid->cells[0] == s.cells;
      });
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
