// A study: every configuration that can simulate a scene, judged and timed.
#pragma once
#include "tradeoff/record.h"

namespace tradeoff {

struct Plan {
  Choice choice = {};
  std::filesystem::path out = {};
  bool quick = false;  // fewer configurations, less time

  // The time for the references of all meshes, and for all trials.
  double reference_seconds() const { return quick ? 15 : 100; }
  double trial_seconds() const { return quick ? 40 : 450; }
};

struct Study {
  std::vector<StudyScene> meshes;  // one, or several if the exact solution is known
  std::vector<double> h_crit;      // s, of each mesh
  std::vector<Reference> references;
  std::vector<Score> scores;
  size_t left_out = 0;  // trials for which there was no time
  double baseline_seconds = unknown;
  std::filesystem::path out;
  std::string arguments;  // of the command that asked for this study

  bool can_judge() const;  // true if no reference refuses
  bool knows_exact() const { return bool(meshes.front().exact); }
  double seconds(const Score& s) const { return s.baselines * baseline_seconds; }
  double h_crit_of(const Score&) const;  // s, of its mesh
};

// Reads the scene; a built-in one it first writes into plan.out. Throws BadInput if the scene
// cannot be studied or plan.out cannot be written.
Study prepare(const Plan&);

// Computes the references of the trials and prints how they converge.
void find_references(const Plan&, Study&);

// Runs the trials that tradeoff.csv in plan.out does not have yet, shortest first, with
// a progress line. Ends when the time of the plan is over. Throws std::runtime_error if
// the results cannot be saved.
void run_trials(const Plan&, Study&);

}  // namespace tradeoff
