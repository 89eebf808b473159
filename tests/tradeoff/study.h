// A study: every way to simulate a scene, judged and timed.
#pragma once
#include "tradeoff/record.h"

namespace tradeoff {

struct Plan {
  Choice choice = {};
  std::filesystem::path out = {};
  bool quick = false;  // a dozen ways, every other h, less patience
};

struct Study {
  std::vector<StudyScene> meshes;  // one; several where the answer without a mesh is known
  std::vector<Reference> references;
  std::vector<double> h_crit;  // s, of each mesh
  std::vector<Score> scores;
  double baseline_seconds = unknown;
  std::filesystem::path out;
  std::string arguments;  // that this study was asked with

  double seconds(const Score& s) const { return s.baselines * baseline_seconds; }
  bool can_judge() const;  // is there a reference that does not refuse?
};

// Reads the scene, or writes it into plan.out, and finds what it is to be judged by.
Study prepare(const Plan&);

// Runs what tradeoff.csv in plan.out does not hold yet, with a progress bar. Throws BadInput for a scene
// that cannot be studied, std::runtime_error where its results cannot be kept.
void run_trials(const Plan&, Study&);

}  // namespace tradeoff
