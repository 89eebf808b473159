// What --explain measures. All runs advance together, from stop to stop, so that a busy machine slows
// all of them alike, and end together: with the scene, or after a few seconds.
#pragma once
#include <optional>

#include "explain/trials.h"

constexpr double nudge = 1e-9;  // m

// What a step costs at the stops, in another way.
struct Probe {
  NamedMethod way;
  std::vector<double> seconds = {};
  double median() const;
};

struct Survey {
  double size = 0;  // m, the diagonal of the cloth's box at the start
  std::vector<double> times =
      {};  // s, of the stops; empty where the cloth explodes before the first
  std::vector<VecX> best_at = {};  // 2 x(h/4) − x(h/2) at the stops: Richardson's guess at h = 0
  std::vector<double> error_at = {};  // RMS distance of x(h) to it, m
  std::vector<double> order_at = {};  // log2 |x(h) − x(h/2)| / |x(h/2) − x(h/4)|

  Trial as_is;
  Trial half, quarter;  // h/2, h/4
  Trial nudged;         // how small changes grow
  std::optional<Trial> tighter;
  std::vector<Trial> left_out;  // every part
  std::vector<Trial> cheaper;   // compared with best_at

  std::vector<Probe> tenth_h;        // with steps of h/10
  std::vector<Probe> other_methods;  // with the same h

  // In interleaved rounds at the stops, medians:
  double round_seconds = 0;                  // of a step
  double forces_seconds = 0;                 // of one evaluation
  std::vector<double> without_seconds = {};  // what it takes less without each part

  bool nothing_moves() const { return quarter.distance_at.back() < 1e-12 * size; }
  size_t last() const { return times.size() - 1; }
  // The last stop until which the order is near 1, so that the error is what error_at says.
  std::optional<size_t> told() const;
  // What h changes at a stop: the error, or where that cannot be told |x(h) − x(h/4)|, which is less.
  double error_of_h(size_t stop) const;
};

// Throws BadInput where the memory does not suffice for all of the runs.
Survey survey(const Options&, const Scene&, const std::vector<Part>&, const Simulate&);
