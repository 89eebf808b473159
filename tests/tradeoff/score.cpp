#include "tradeoff/score.h"

#include <algorithm>

#include "program/diagnostics.h"
#include "support/cpu_time.h"
#include "support/reference.h"
#include "support/scenes.h"

namespace tradeoff {

namespace {

struct Motion {
  Cloth cloth;  // its hinges store their angles
  State state;
  Counts counts;
  double seconds;
  std::string outcome;
};

std::string in_step(const char* what, long n, long of) {
  return std::string(what) + " in step " + std::to_string(n) + " of " + std::to_string(of);
}

// Why the run cannot continue; empty if it can.
std::string trouble(const StudyScene& study, const State& state, long n, long steps) {
  if (!state.x.allFinite()) return in_step("exploded", n, steps);
  if (has_exploded(max_stretch(study.scene.mesh, state.x))) return in_step("exploded", n, steps);
  return {};
}

// Only the steps are timed, not the preparation before the first step.
Motion move(const StudyScene& study, const Trial& trial, double patience) {
  Motion motion{study.scene.cloth, study.scene.start, {}, 0, ""};
  const auto simulator = make_simulator(trial.configuration, motion.cloth);
  const double h = trial.h(study.scene.time.end);
  const long between_looks = std::max(1L, trial.steps / 20);
  for (long n = 0; n < trial.steps && motion.outcome.empty();) {
    const long until = std::min(n + between_looks, trial.steps);
    motion.seconds += seconds([&] {
      for (; n < until; ++n) simulator->step(h, motion.state);
    });
    motion.outcome = trouble(study, motion.state, n, trial.steps);
    if (motion.outcome.empty() && n < trial.steps && motion.seconds > patience)
      motion.outcome = in_step("given up", n, trial.steps);
  }
  motion.counts = simulator->counts();
  if (motion.outcome.empty()) motion.outcome = "done";
  return motion;
}

double lowest_point(const VecX& x) {
  return x.reshaped(3, x.size() / 3).row(1).minCoeff();
}

double energy_scale(const StudyScene& study) {
  const Cloth& cloth = study.scene.cloth;
  if (!cloth.gravity) return std::max(energies(cloth, study.scene.start).total(), 1e-12);
  return cloth.mass.sum() / 3 * cloth.gravity->norm() * study.size;
}

}  // namespace

double Baseline::run() {
  static const TestScene scene = trampoline();
  Cloth cloth = scene.cloth;
  const auto simulator = make_simulator({1}, cloth);
  State state = scene.start;
  times.push_back(seconds([&] {
    for (int n = 0; n < 2000; ++n) simulator->step(1e-4, state);
  }));
  return times.back();
}

double Baseline::median_seconds() const {
  return median(times);
}

void judge(const StudyScene& study, const Reference& reference, Cloth& cloth, const State& state,
           Score& score) {
  score.energy = energy_of(cloth, state);
  score.lowest = lowest_point(state.x);
  score.stretch = max_stretch(study.scene.mesh, state.x);
  if (!reference.refusal().empty()) return;
  const auto distance = [&](const VecX& x) { return rms_distance(cloth, state.x, x) / study.size; };
  score.error = std::max(distance(reference.state.x), reference.floor());
  if (study.exact) score.total_error = distance(study.exact(study.scene.time.end));
  score.energy_error = std::abs(score.energy - reference.energy) / energy_scale(study);
  score.stretch_error = std::abs(score.stretch - max_stretch(study.scene.mesh, reference.state.x));
}

Score run_trial(const StudyScene& study, const Reference& reference, const Trial& trial,
                double patience, Baseline& baseline) {
  Score score;
  score.trial = trial;
  score.h = trial.h(study.scene.time.end);
  score.cells = cells_of(study);
  std::vector<double> ratios;
  double spent = 0;
  try {
    while (ratios.size() < 3 || (ratios.size() < 9 && spent < patience)) {
      const double unit = baseline.run();
      Motion motion = move(study, trial, 20 * patience);
      spent += motion.seconds;
      ratios.push_back(motion.seconds / unit);
      if (ratios.size() == 1) {
        score.outcome = motion.outcome;
        score.counts = motion.counts;
        if (!score.done()) break;
        judge(study, reference, motion.cloth, motion.state, score);
      }
      if (spent > 10 * patience) break;
    }
  } catch (const std::invalid_argument& cannot) {
    score.outcome = cannot.what();
    std::replace(score.outcome.begin(), score.outcome.end(), ',', ';');  // one cell of the CSV file
    return score;
  }
  score.repeats = int(ratios.size());
  score.baselines = median(ratios);
  return score;
}

double error_of(const StudyScene& study, const Reference& reference, const Trial& trial) {
  Score score;
  Motion motion = move(study, trial, 1e300);
  score.outcome = motion.outcome;
  if (score.done()) judge(study, reference, motion.cloth, motion.state, score);
  return score.is_answer() ? score.error : unknown;
}

}  // namespace tradeoff
