// What a trial came to: how wrong its cloth is at the end, and what that has cost.
#pragma once
#include <limits>

#include "tradeoff/reference_motion.h"
#include "tradeoff/trial.h"

namespace tradeoff {

inline constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

struct Score {
  Trial trial;
  int cells = 0;  // cells_of its scene
  double h = 0;   // s

  std::string outcome;  // "done", or what went wrong
  bool done() const { return outcome == "done"; }

  // At the end, relative to the size of the cloth: the RMS distance of the vertices from where the
  // reference has them, and from the exact answer where there is one.
  double error = unknown, total_error = unknown;
  double energy_error =
      unknown;  // |E − E of the reference| / (m g size), without g: / E at the start
  double stretch_error = unknown;  // |largest |w| − that of the reference|

  double energy = unknown, lowest = unknown, stretch = unknown;  // J, m, 1: at the end

  Counts counts;
  int repeats = 0;
  double baselines = unknown;  // the time, in times of the baseline: median of interleaved rounds

  // The error that counts for this scene.
  double judged() const { return total_error == total_error ? total_error : error; }
};

// A fixed piece of work that all times are measured in: 2000 explicit steps of the trampoline.
class Baseline {
 public:
  double seconds();               // does the work
  double median_seconds() const;  // of all so far
 private:
  std::vector<double> times;
};

// Runs the trial once for its error, and again, each time with the baseline before it, for its time:
// three times at least and nine at most, as `patience` s allow; a single run may take twenty `patience`.
Score run_trial(const StudyScene&, const Reference&, const Trial&, double patience, Baseline&);

// Fills in the errors of a state against the reference.
void judge(const StudyScene&, const Reference&, const State&, Score&);

}  // namespace tradeoff
