// Watches the cloth of a run: has it exploded, has it gained energy?
#pragma once
#include "program/diagnostics.h"
#include "scene/scene.h"

// The measures of a state.
struct Sample {
  Energies energies;
  double max_stretch = 1;
  double lowest = 0;  // m

  bool exploded() const { return has_exploded(max_stretch); }
};

// Changes of energy are compared with this: the weight of the cloth times its size at the start, or
// without gravity the energy at the start.
struct EnergyScale {
  double joule;
  bool is_weight_times_size;
};

class Watch {
 public:
  explicit Watch(const Scene&);

  // The state after so many steps. A second call for the same step returns the same sample, so that
  // every step counts once.
  const Sample& sample(long step, const State&);

  const Scene& scene;
  const Energies start;
  const EnergyScale scale;

  double most_stretch = 0;  // of all samples
  double most_gained = 0;   // J, above the energy at the start
  long gained = 0;  // samples with more energy than the start, by over 1e-3 of the scale; none
                    // where a pin moves, which does work
 private:
  Sample latest;
  long latest_step = -1;
};
