// What trials are judged by: the same mesh, moved by the Runge-Kutta method of order 4, with steps halved
// until two runs agree. It says itself how far it can be trusted.
#pragma once
#include <functional>
#include <limits>

#include "tradeoff/study_scene.h"

namespace tradeoff {

struct Reference {
  State state;        // at the end
  double energy = 0;  // J, there
  long steps = 0;     // of the last run
  double self_check =
      1e300;  // RMS distance to the run with half as many steps, relative to the size
  double order = std::numeric_limits<double>::quiet_NaN();  // seen in the last two halvings
  double growth = 1;  // of 1e-9 m, by which another run begins elsewhere
  double seconds = 0;

  // The smallest error that it can tell: a thousand times what it does not know of itself.
  double floor() const { return 1e3 * self_check * std::max(1.0, growth); }

  // Why there is nothing to be judged by; empty where there is.
  std::string refusal() const;
};

inline constexpr double worst_floor =
    1e-3;  // of the size: a reference that cannot tell this is refused

// Halves its step until it can tell 1e-6, for no longer than about `patience` seconds; `report` hears of
// every halving.
Reference find_reference(const StudyScene&, double patience,
                         const std::function<void(const Reference&)>& report = {});

// E of a cloth that remembers its folds, J.
double energy_of(Cloth&, const State&);

}  // namespace tradeoff
