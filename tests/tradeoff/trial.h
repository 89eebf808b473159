// A trial: one configuration, with one time step.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "ways/simulator.h"

namespace tradeoff {

struct Trial {
  Configuration configuration;
  long steps = 0;  // h = end/steps

  double h(double end) const { return end / double(steps); }
};

// The name of a configuration at any h: "step04 block 1e-4 bw98 newton", or "xpbd 4" with its sweeps.
std::string name_of(const Configuration&);

// The same without its tolerance or sweeps: "step04 block bw98 newton", "xpbd".
std::string kind_of(const Configuration&);

// The options that select this configuration in its program. Options at
// their defaults are left out. XPBD and VBD have no program.
std::string options_of(const Configuration&);

// Every configuration that the steps offer, in the order of the steps: solvers or
// preconditioners × tolerances × Jacobians × plain or Newton steps; then XPBD and VBD with 1, 4, 16 and 64
// sweeps per step. `few`: only the most telling solvers, tolerances and sweeps.
std::vector<Configuration> configurations_of(const std::vector<int>& steps, bool few);

// The numbers of steps to try. Explicit: from h = 2 h_crit down to h_crit/32. All others: 8, 16, 32,
// … until h is an eighth of h_crit, at most nine numbers.
std::vector<long> step_counts(const Configuration&, double end, double h_crit);

}  // namespace tradeoff
