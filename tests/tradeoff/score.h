// What a trial came to: how wrong its cloth is at the end, and what that has cost.
#pragma once
#include <limits>

#include "tradeoff/reference_motion.h"
#include "tradeoff/trial.h"

namespace tradeoff {

inline constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

struct Score {
  Trial trial;
  int cells = 0;  // along u; 0 for a mesh that is no grid
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

  // Did it come to an end that has something to do with the truth: less than the size away from it?
  bool is_answer() const { return done() && judged() < 1; }

  // The error that counts for this scene.
  double judged() const { return total_error == total_error ? total_error : error; }
};

// A fixed piece of work that all times are measured in: 2000 explicit steps of the trampoline.
class Baseline {
 public:
  double run();                   // s
  double median_seconds() const;  // of all so far
 private:
  std::vector<double> times;
};

// Runs the trial once for its error, and again, each time with the baseline before it, for its time: nine
// times at most, as often as fits into `patience` s, but three times unless that takes ten times as long. A
// single run may take twenty `patience`. An error that is smaller than the reference can tell is as large.
Score run_trial(const StudyScene&, const Reference&, const Trial&, double patience, Baseline&);

// Fills in the errors of a cloth at the end, which may remember folds, against the reference.
void judge(const StudyScene&, const Reference&, Cloth&, const State&, Score&);

}  // namespace tradeoff
