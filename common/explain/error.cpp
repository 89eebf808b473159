// How large the error of h is, and what a tenth of it, or of the time, would take.
#include <algorithm>

#include "explain/page_layout.h"
#include "explain/sections.h"

namespace {

constexpr double chaos = 1e4;  // how often a nudge has grown by then

// Where errors are compared: as late as they can be told.
size_t compared_at(const Survey& s) {
  return s.told().value_or(s.last());
}

std::string of_size(double m, const Survey& s) {
  return length(m) + ", " + per_cent(m / s.size) + " of the size";
}

void print_told(const Survey& s, size_t stop) {
  print_wrapped(text("t = %.6g s: ", s.times[stop]) + of_size(s.error_at[stop], s) +
                text(" (%s); order seen: %.2f", length(s.size).c_str(), s.order_at[stop]));
}

void print_not_told(const Survey& s) {
  const size_t last = s.last();
  const double growth = s.nudged.distance_at[last] / nudge;
  print_wrapped(text("t = %.6g s: cannot be told. h and h/4 are ", s.times[last]) +
                of_size(s.quarter.distance_at[last], s) +
                text(", apart; order seen: %.2f; ", s.order_at[last]) +
                text("a nudge of %g m has grown %.2g-fold: ", nudge, growth) +
                (growth > chaos
                     ? "chaos, no h ends where another does"
                     : "h decides how it folds, and only a far smaller h shows order 1"));
}

// A tenth of the tolerance as well, where a tenth of the error would drown in what the tolerance does.
const Probe* step_of_a_tenth(const Survey& s) {
  if (s.tenth_h.empty()) return nullptr;
  const size_t stop = compared_at(s);
  const bool tight = s.tighter && s.tighter->distance_at[stop] > 0.03 * s.error_of_h(stop);
  return &s.tenth_h[tight ? 1 : 0];
}

void print_tenth_of_error(const Scene& scene, const Survey& s) {
  const Probe* probe = step_of_a_tenth(s);
  const double now = step_seconds(s), then = probe ? probe->median() : now;
  const double steps = double(scene.time.steps());
  std::string options = text("--h %g", scene.time.h / 10);
  if (probe && !probe->way.options.empty()) options += " " + probe->way.options;
  print_wrapped("a tenth of the error (order 1): " + options +
                text(", %.3g ms a step, %.3g s instead of %.3g s for the scene", 1000 * then,
                     10 * steps * then, steps * now));
}

// Of those that take a tenth of the time the most accurate, or else the fastest.
const Trial* best_cheaper(const Survey& s) {
  const size_t stop = compared_at(s);
  const auto better = [&](const Trial& a, const Trial& b) {
    const bool a_fits = a.seconds < 0.1 * s.as_is.seconds,
               b_fits = b.seconds < 0.1 * s.as_is.seconds;
    if (a_fits != b_fits) return a_fits;
    return a_fits ? a.distance_at[stop] < b.distance_at[stop] : a.seconds < b.seconds;
  };
  const Trial* best = nullptr;
  for (const Trial& trial : s.cheaper)
    if (trial.ended.empty() && (!best || better(trial, *best))) best = &trial;
  return best;
}

void print_tenth_of_time(const Options& options, const Survey& s) {
  if (const Trial* best = best_cheaper(s))
    print_wrapped("a tenth of the time: " + best->options + " takes " +
                  percent(best->seconds / s.as_is.seconds) + " of it, error " +
                  of_size(best->distance_at[compared_at(s)], s));
  else
    print_wrapped("a tenth of the time: of the ways tried none gets there");
  if (!options.concepts.implicit)
    print_wrapped("longer steps than h_crit: step03_implicit, with this scene and --explain");
}

}  // namespace

const Probe* better_method(const Survey& s, double tolerance) {
  const Probe* best = nullptr;
  for (const Probe& probe : s.other_methods)
    if (probe.way.method.tolerance <= tolerance && (!best || probe.median() < best->median()))
      best = &probe;
  return best && best->median() < 0.8 * step_seconds(s) ? best : nullptr;
}

void print_error(const Options& options, const Scene& scene, const Survey& s) {
  if (s.nothing_moves())
    return print_wrapped(
        text("none until t = %.6g s: nothing moves that h could change", s.times[s.last()]));
  const std::optional<size_t> told = s.told();
  if (told) print_told(s, *told);
  if (told != s.last()) print_not_told(s);
  if (s.tighter)
    print_wrapped(text("the tolerance %g alone changes ", options.method.tolerance) +
                  length(s.tighter->distance_at[compared_at(s)]));
  print_tenth_of_error(scene, s);
  print_tenth_of_time(options, s);
}
