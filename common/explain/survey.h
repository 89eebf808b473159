// What --explain measures. All runs advance together, from stop to stop, so that a busy machine
// slows all of them alike. They end with the scene, or with their share of the time budget.
#pragma once
#include <optional>

#include "explain/trials.h"

constexpr double perturbation = 1e-9;  // m

// The time of one step at every stop, with another method.
struct StepTimes {
  NamedMethod with;
  std::vector<double> seconds = {};
  double median() const;
};

// The longest stable explicit step at the start: 2/ω_max without damping.
struct Limit {
  double h_crit = 0;            // s; infinite without an elastic force
  std::vector<double> without;  // s, without each part; of an explicit step only
};

struct Survey {
  double size = 0;  // m, the diagonal of the cloth's box at the start
  Limit limit = {};

  // Of the stops. Empty where the cloth explodes, or the time ends, before the first.
  std::vector<double> times;          // s
  std::vector<VecX> extrapolated_at;  // 2 x(h/4) − x(h/2): Richardson's estimate of h → 0
  std::vector<double> error_at;       // m, RMS distance from x(h) to it
  std::vector<double> order_at;       // log2 |x(h) − x(h/2)| / |x(h/2) − x(h/4)|

  Trial baseline;       // the scene as it stands
  Trial half, quarter;  // h/2, h/4
  Trial perturbed;      // shows how small changes grow
  std::optional<Trial> tighter;
  std::vector<Trial> left_out;  // one for every part
  std::vector<Trial> cheaper;   // compared with extrapolated_at

  std::vector<StepTimes> tenth_h;        // with steps of h/10
  std::vector<StepTimes> other_methods;  // with the same h

  // Medians of interleaved timings at all stops, s:
  double median_step = 0;
  double median_forces = 0;          // one evaluation of all forces
  std::vector<double> median_saved;  // by an evaluation without each part

  std::vector<std::string> not_measured;  // for lack of time

  bool nothing_moves() const { return quarter.distance_at.back() < 1e-12 * size; }
  size_t last() const { return times.size() - 1; }
  double mean_seconds() const;  // of the baseline and the perturbed run, which do the same work
  double mean_step() const;     // s
  double timing_noise() const;  // relative difference of the two

  // The last stop where the observed order is near 1, so that error_at estimates the error.
  std::optional<size_t> last_reliable_stop() const;
  // Errors are compared there, or where there is none at the last stop.
  size_t compared_at() const { return last_reliable_stop().value_or(last()); }
  // The error of h at a stop, m. Where it cannot be estimated: |x(h) − x(h/4)|, which is less.
  double error_of_h(size_t stop) const;
  bool is_below_error(const Trial&) const;  // does leaving out this part change less than h does?

  // A step of h/10: with a tenth of the tolerance as well, where the tolerance would otherwise be
  // most of the error. Nothing for an explicit method, whose steps cost the same.
  const StepTimes* step_of_a_tenth() const;
  // Of the cheaper runs that take a tenth of the time the most accurate; where none does, the
  // fastest.
  const Trial* best_cheaper() const;
  // Of the methods that solve as accurately the cheapest; nothing where it saves less than a fifth.
  const StepTimes* better_method(double tolerance) const;
};

// The cheapest measurements come first. Throws BadInput where the memory does not suffice for all of
// the runs.
Survey survey(const Trials&);
