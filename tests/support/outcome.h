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

  // The largest E − E_0, J, and the largest rise of E in a step, of the sum of the energies' sizes.
  double gain = -std::numeric_limits<double>::infinity(), rise = gain;

  double peak = 0, last = 0;  // the largest stretch, of all steps and after the last
  long indefinite = 0;        // steps whose matrix was not definite
  State end;
};

// As many steps as `seconds` need, at least `fewest`.
inline int steps_for(double seconds, double h, int fewest) {
  return std::max(fewest, int(std::lround(seconds / h)));
}

// Ends early where a position is not finite. The scene is a copy, because step 5 stores θ in its hinges.
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

// By step 3.
Outcome watch(const TestScene&, double h, int steps, const Method& = {});

// The cloth at rest in the end: Newton's method at h = 10 s, where inertia is next to nothing, with the
// velocity set to zero before every step, until a step moves no vertex by 1 µm. From 1e6 N/m on and
// where the cloth lies in folds that no force resists it creeps on; its stretch has settled long before
// the last of 20 steps.
State hanging(const TestScene&);

double static_stretch(const TestScene&);

}  // namespace extremes
