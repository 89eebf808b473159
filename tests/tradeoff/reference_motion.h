// The reference by which trials are judged: the same mesh, moved by the Runge-Kutta method of
// order 4. Its step is halved until two runs agree. The reference knows how far it can be trusted.
#pragma once
#include <functional>
#include <limits>

#include "tradeoff/study_scene.h"

namespace tradeoff {

struct Reference {
  State state;        // at the end
  double energy = 0;  // J, at the end
  long steps = 0;     // of the last run
  double self_check =
      1e300;  // RMS distance to the run with half as many steps, relative to the size
  double order = std::numeric_limits<double>::quiet_NaN();  // measured in the last two halvings
  double growth = 1;  // the factor by which a perturbation of 1e-9 m grows
  double seconds = 0;

  // The smallest error that it can measure: a thousand times its own uncertainty.
  double floor() const { return 1e3 * self_check * std::max(1.0, growth); }

  // Why the reference cannot judge trials; empty if it can.
  std::string refusal() const;
};

inline constexpr double worst_floor =
    1e-3;  // of the size: a reference with a larger floor is refused

// Halves the step until the reference can measure an error of 1e-6, for about `patience` seconds at
// most. Calls `report` after every halving.
Reference find_reference(const StudyScene&, double patience,
                         const std::function<void(const Reference&)>& report = {});

// The total energy of a cloth, J. First updates the angles θ that its hinges store.
double energy_of(Cloth&, const State&);

}  // namespace tradeoff
