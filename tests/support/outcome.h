// The outcome of a run: energies, stretches, and the counts of the solver.
#pragma once
#include <algorithm>
#include <limits>

#include "math/method.h"
#include "program/diagnostics.h"
#include "support/extreme_scenes.h"

namespace extremes {

struct Outcome {
  int steps = 0;
  bool finite = true;  // every position

  // The largest E − E_0, J, and the largest rise of E in a step, relative to the sum of
  // the sizes of the energies.
  double gain = -std::numeric_limits<double>::infinity(), rise = gain;

  double peak = 0, last = 0;  // the largest stretch in all steps, and after the last step
  long indefinite = 0;        // steps whose matrix was not definite
  State end;
};

// The number of steps that `seconds` take, at least `fewest`.
inline int steps_for(double seconds, double h, int fewest) {
  return std::max(fewest, int(std::lround(seconds / h)));
}

// Ends early if a position is not finite. The scene is a copy, because
// step 5 stores θ in its hinges.
template <class System, class Step>
Outcome watch(TestScene scene, double h, int steps, System& system, const Step& step) {
  Outcome o;
  o.end = scene.start;
  const double E_start = energies(scene.cloth, o.end).total();
  while (o.steps < steps && o.finite) {
    const Energies before = energies(scene.cloth, o.end);
    step(scene.cloth, h, o.end, system);
    ++o.steps;
    o.finite = o.end.x.allFinite();
    const double E = energies(scene.cloth, o.end).total();
    o.gain = std::max(o.gain, E - E_start);
    o.rise = std::max(o.rise, (E - before.total()) / (before.kinetic + before.elastic() +
                                                      std::abs(before.gravitational)));
    o.last = max_stretch(scene.mesh, o.end.x);
    o.peak = std::max(o.peak, o.last);
  }
  o.indefinite = system.counts.indefinite;
  return o;
}

// Runs step 3.
Outcome watch(const TestScene&, double h, int steps, const Method& = {});

// The hanging cloth at rest: Newton's method at h = 10 s, where inertia is negligible, with the
// velocity set to zero before every step, until a step moves no vertex by 1 µm. From 1e6 N/m on,
// and if the cloth lies in folds that no force resists, the cloth creeps on. Its stretch has
// settled long before the last of 20 steps.
State hanging(const TestScene&);

double static_stretch(const TestScene&);

}  // namespace extremes
