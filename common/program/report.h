// All sentences that a run prints.
#pragma once
#include "program/options.h"
#include "program/watch.h"

// How far a run has come.
struct RunTotals {
  long steps = 0;
  double seconds = 0;  // of stepping
  double h_crit = 0;   // s, the longest stable step; 0 where the method has none
  Counters counts;
  long failed = 0;  // steps with a linear system that has no solution
};

// The error message of a run in which every step had a linear system without a solution.
std::string no_result(long steps);

class Report {
 public:
  Report(const Options& options_, const Scene& scene_) : options(options_), scene(scene_) {}

  void start() const;
  void critical_step(double h_crit) const;
  void end(const RunTotals&, const Watch&, const State&, bool interrupted) const;

  // `reason`: why motion.mp4 could not be made, or "".
  void video(const std::string& reason, const std::string& command) const;

  // The error message of a run whose cloth has exploded: the step, what was seen, and advice.
  std::string explosion(const RunTotals&, const std::string& seen) const;

 private:
  std::string advice(const RunTotals&) const;
  void iterations(const RunTotals&) const;
  void redone(const RunTotals&) const;
  void warnings(const RunTotals&, const Watch&, const State&) const;
  long collapsed_hinges(const VecX& x) const;

  const Options& options;
  const Scene& scene;
};
