// The result of a trial: the error of its cloth at the end, and the cost.
#pragma once
#include <limits>

#include "tradeoff/reference_motion.h"
#include "tradeoff/trial.h"

namespace tradeoff {

inline constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

struct Score {
  Trial trial;
  int cells = 0;  // along u; 0 if the mesh is not a grid
  double h = 0;   // s

  std::string outcome;  // "done", or the reason for the failure
  bool done() const { return outcome == "done"; }

  // At the end, relative to the size of the cloth: the RMS distance of the vertices to the
  // reference, and to the exact solution if there is one.
  double error = unknown, total_error = unknown;
  double energy_error =
      unknown;  // |E − E_ref| / (m g size); without gravity: |E − E_ref| / E_start
  double stretch_error = unknown;  // |largest |w| − largest |w| of the reference|

  double energy = unknown, lowest = unknown, stretch = unknown;  // J, m, 1: at the end

  Counts counts;
  int repeats = 0;
  double baselines = unknown;  // time / time of the baseline: the median of interleaved rounds

  // True if the run reached the end, less than the size of the cloth away from the truth.
  bool is_answer() const { return done() && judged() < 1; }

  // The error by which this scene is judged: total_error if it is known, else error.
  double judged() const { return total_error == total_error ? total_error : error; }
};

// The unit of all times: 2000 explicit steps of the trampoline.
class Baseline {
 public:
  double run();                   // s
  double median_seconds() const;  // of all runs so far
 private:
  std::vector<double> times;
};

// Runs the trial three to nine times, each time after the baseline. The first run gives the error,
// all runs give the time. After three runs it stops when `patience` seconds are spent; before that,
// when ten times as many are. A single run may take 20 times `patience`. An error below the floor
// of the reference is set to the floor.
Score run_trial(const StudyScene&, const Reference&, const Trial&, double patience, Baseline&);

// The error of one run, without its time; NaN if it did not come to an answer.
double error_of(const StudyScene&, const Reference&, const Trial&);

// Compares a cloth at the end with the reference and fills in the errors. Updates
// the angles in its hinges.
void judge(const StudyScene&, const Reference&, Cloth&, const State&, Score&);

}  // namespace tradeoff
