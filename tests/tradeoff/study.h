// A study: every way to simulate a scene, judged and timed.
#pragma once
#include "tradeoff/record.h"

namespace tradeoff {

struct Plan {
  Choice choice = {};
  std::filesystem::path out = {};
  bool quick = false;  // fewer ways and less patience

  // For the references of all meshes, and for all trials.
  double reference_seconds() const { return quick ? 15 : 100; }
  double trial_seconds() const { return quick ? 40 : 450; }
};

struct Study {
  std::vector<StudyScene> meshes;  // one; several where the answer without a mesh is known
  std::vector<double> h_crit;      // s, of each mesh
  std::vector<Reference> references;
  std::vector<Score> scores;
  size_t left_out = 0;  // trials for which there was no time
  double baseline_seconds = unknown;
  std::filesystem::path out;
  std::string arguments;  // that this study was asked with

  bool can_judge() const;  // do all references say that they can?
  bool knows_exact() const { return bool(meshes.front().exact); }
  double seconds(const Score& s) const { return s.baselines * baseline_seconds; }
  double h_crit_of(const Score&) const;  // s, of its mesh
};

// Reads the scene, or writes it into plan.out. Throws BadInput for a scene that cannot be studied, and where
// plan.out cannot be written.
Study prepare(const Plan&);

// What the trials are to be judged by; prints how it converges.
void find_references(const Plan&, Study&);

// Runs what tradeoff.csv in plan.out does not hold yet, the shortest trials first, with a progress bar, and
// ends when the plan's time is over. Throws std::runtime_error where its results cannot be kept.
void run_trials(const Plan&, Study&);

}  // namespace tradeoff
