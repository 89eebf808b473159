// Runs a scene at every time step and every stiffness, and prints a table with counts.
#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <vector>

#include "support/outcome.h"

namespace extremes {

inline const std::vector<double> all_h = {1e-4, 1e-3, 1e-2, 1.0 / 60, 1.0 / 30, 0.1};
inline const std::vector<double> all_k = {1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8};

struct Run {
  double h, k;
  double static_stretch;  // NaN for k < 1e2, where the cloth hangs several metres down
  Outcome outcome;
};

inline void print_run(const Run& run) {
  const Outcome& o = run.outcome;
  std::printf("%8.4f %6.0e %6d  %10.2e %9.4f %9.4f %9.4f%s\n", run.h, run.k, o.steps, o.gain,
              o.peak, o.last, run.static_stretch, o.finite ? "" : "  not finite");
}

inline void print_counts(const std::vector<Run>& runs) {
  const auto count = [&](auto holds) { return std::count_if(runs.begin(), runs.end(), holds); };
  const auto gained = [&](double joule) {
    return count([&](const Run& run) { return run.outcome.gain > joule; });
  };
  const auto beyond = [&](double stretch) {
    return count([&](const Run& run) { return run.k >= 1e2 && run.outcome.peak > stretch; });
  };
  std::printf("of %zu runs %td gained energy, %td more than 0.1 J, %td more than 1e3 J;\n",
              runs.size(), gained(0), gained(0.1), gained(1e3));
  std::printf("from 1e2 N/m on, %td were at some moment stretched beyond 2, %td beyond 20\n\n",
              beyond(2), beyond(20));
}

// `at_rest` is the scene whose hanging cloth this scene must reach.
// seconds(h) is the time of a run.
template <class Seconds>
std::vector<Run> run_table(const char* title, MakeScene make, MakeScene at_rest,
                           const Seconds& seconds, int fewest) {
  std::printf("%s: energy gained at most, largest stretch of all, after the last step, at rest\n",
              title);
  std::printf("%8s %6s %6s  %10s %9s %9s %9s\n", "h/s", "k", "steps", "gain/J", "peak", "last",
              "rest");
  std::vector<double> rest;
  for (double k : all_k)
    rest.push_back(k < 1e2 ? std::numeric_limits<double>::quiet_NaN() : static_stretch(at_rest(k)));
  std::vector<Run> runs;
  for (double h : all_h)
    for (size_t i = 0; i < all_k.size(); ++i) {
      runs.push_back(
          {h, all_k[i], rest[i], watch(make(all_k[i]), h, steps_for(seconds(h), h, fewest))});
      print_run(runs.back());
    }
  print_counts(runs);
  return runs;
}

}  // namespace extremes
