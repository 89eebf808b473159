#include "tradeoff/report.h"

#include <algorithm>
#include <cstdio>

#include "support/text.h"

namespace tradeoff {

namespace {

std::vector<std::string> kinds_of(const std::vector<Score>& scores) {
  std::vector<std::string> kinds;
  for (const Score& score : scores)
    if (std::find(kinds.begin(), kinds.end(), kind_of(score.trial.configuration)) == kinds.end())
      kinds.push_back(kind_of(score.trial.configuration));
  return kinds;
}

std::vector<Score> of_kind(const std::vector<Score>& scores, const std::string& kind) {
  std::vector<Score> kept;
  for (const Score& score : scores)
    if (kind_of(score.trial.configuration) == kind) kept.push_back(score);
  return kept;
}

void print_kinds(const Study& study) {
  std::printf(
      "\nMilliseconds to an error of at most …, by the cheapest h, tolerance%s of each way\n\n",
      study.meshes.size() > 1 ? " and mesh" : "");
  std::printf("  %-34s", "");
  for (double error : asked_errors) std::printf("%9.0e", error);
  std::printf("%12s\n", "smallest");
  for (const std::string& kind : kinds_of(study.scores)) {
    const std::vector<Score> scores = of_kind(study.scores, kind);
    std::printf("  %-34s", kind.c_str());
    for (double error : asked_errors) {
      const auto best = cheapest(scores, error);
      std::printf("%9s", best ? format("%.3g", 1e3 * study.seconds(*best)).c_str() : "-");
    }
    const auto finest = most_accurate(scores, 1e300);
    std::printf("%12s\n", finest ? format("%.1e", finest->judged()).c_str() : "-");
  }
}

void print_front(const Study& study) {
  const bool exact = study.knows_exact();
  std::printf(
      "\nThe Pareto front: nothing else is as accurate for less (what gains less than a tenth on "
      "the one "
      "before is left out;\nMB moved: without the inside of preconditioners and factors%s)\n\n",
      exact ? "; total: against the exact motion, by which all is judged" : "");
  std::printf("  %9s %9s %9s%s %9s %9s  %-30s %8s %8s %8s %9s%s\n", "error", "energy", "stretch",
              exact ? "     total" : "", "ms", "h", "way", "forces", "systems", "products",
              "MB moved", exact ? "  cells" : "");
  for (const Score& s : distinct(pareto_front(study.scores))) {
    std::printf("  %9.1e %9.1e %9.1e", s.error, s.energy_error, s.stretch_error);
    if (exact) std::printf(" %9.1e", s.total_error);
    std::printf(" %9.3g %9.3g  %-30s %8ld %8ld %8ld %9.3g", 1e3 * study.seconds(s), s.h,
                name_of(s.trial.configuration).c_str(), s.counts.forces, s.counts.assemblies,
                s.counts.products, 1e-6 * double(s.counts.bytes));
    if (exact) std::printf("%7d", s.cells);
    std::printf("\n");
  }
}

// XPBD and VBD stand in the tables beside what the steps offer.
void print_key() {
  std::printf(
      "\n  xpbd, vbd: with so many sweeps per step; they are in tests/ways, and no step's program "
      "has them\n");
}

// For scenes whose positions cannot be compared: the longest and the shortest time step of each
// kind of configuration that reached the end.
void print_statistics(const Study& study) {
  std::printf(
      "\nNo error can be told, so only what the cloth is like at the end, of each way for the "
      "largest\n");
  std::printf("and the smallest h that came to an end\n\n  %-30s %10s %10s %10s %10s %10s\n", "way",
              "h", "ms", "energy/J", "lowest/m", "stretch");
  const auto print = [&](const Score& s) {
    std::printf("  %-30s %10.3g %10.3g %10.4f %10.4f %10.4f\n",
                name_of(s.trial.configuration).c_str(), s.h, 1e3 * study.seconds(s), s.energy,
                s.lowest, s.stretch);
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

// Counts the runs that failed and those that deserve a warning: none is left out silently.
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
  const auto lost = [](const Score& s) { return s.done() && s.judged() >= 1; };
  say("ended farther from the truth than the cloth is wide",
      std::count_if(study.scores.begin(), study.scores.end(), lost));
  say("met a matrix that was not positive definite",
      sum([](const Counts& c) { return c.indefinite; }));
  say("left a system unsolved at --max-iterations", sum([](const Counts& c) { return c.capped; }));
  say("had steps in which Newton's method did not converge",
      sum([](const Counts& c) { return c.unconverged; }));
  if (study.left_out > 0)
    std::printf(
        "  %zu more were left out, the longest, for lack of time; the same command goes on with "
        "them\n",
        study.left_out);
}

}  // namespace

void print_tables(const Study& study) {
  if (study.can_judge()) {
    print_kinds(study);
    print_front(study);
  } else {
    print_statistics(study);
  }
  print_key();
  print_failures(study);
}

}  // namespace tradeoff
