// A trial: one way to simulate the scene, with one length of step.
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

// What the trial has in common with others of another h: "step04 block 1e-4 bw98 newton".
std::string name_of(const Configuration&);

// The same without its tolerance: "step04 block bw98 newton".
std::string kind_of(const Configuration&);

// The options of the program that make it this way; the others are at their defaults.
std::string options_of(const Configuration&);

// Every way that the steps offer, in the order of the steps: solvers or preconditioners × tolerances ×
// Jacobians × plain or Newton steps. `few`: of solvers and tolerances the most telling.
std::vector<Configuration> configurations_of(const std::vector<int>& steps, bool few);

// The numbers of steps to try. Explicit: around end/h_crit, where h = h_crit, and on to 1/32 of it.
// Implicit: 8, 16, 32, … until h is an eighth of h_crit, at most nine.
std::vector<long> step_counts(const Configuration&, double end, double h_crit);

}  // namespace tradeoff
