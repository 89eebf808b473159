#include "tradeoff/trial.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace tradeoff {

namespace {

const Method defaults;

// Writes 0.0001 as 1e-4.
std::string power_of_ten(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "1e%ld", std::lround(std::log10(value)));
  return text;
}

// XPBD and VBD have sweeps where conjugate gradients have a tolerance.
const char* local_name(const Configuration& configuration) {
  return configuration.scheme == Scheme::xpbd ? "xpbd" : "vbd";
}

std::string describe(const Configuration& configuration, const std::string& tolerance) {
  if (!is_of_step(configuration)) return local_name(configuration) + tolerance;
  std::string name = std::string(program_of(configuration.step)).substr(0, 6);
  const Method& m = configuration.method;
  if (configuration.step == 3) name += " " + m.solver;
  if (configuration.step > 3) name += " " + m.preconditioner + tolerance;
  if (configuration.step > 2 && m.jacobian == Jacobian::bw98) name += " bw98";
  if (configuration.step > 2 && m.newton > 1) name += " newton";
  return name;
}

// Combines every configuration so far with every choice.
template <class Choices, class Set>
void cross(std::vector<Configuration>& configurations, const Choices& choices, const Set& set) {
  std::vector<Configuration> all;
  for (const Configuration& configuration : configurations)
    for (const auto& choice : choices) {
      all.push_back(configuration);
      set(all.back().method, choice);
    }
  configurations = all;
}

std::vector<Configuration> implicit_configurations(int step, bool few) {
  using Names = std::vector<std::string>;
  std::vector<Configuration> configurations = {{step}};
  if (step == 3)
    cross(configurations, few ? Names{"ldlt"} : Names{"ldlt", "cholmod", "inverse"},
          [](Method& m, const std::string& name) { m.solver = name; });
  else {
    cross(configurations,
          few ? Names{"block", "multigrid"} : Names{"none", "jacobi", "block", "ic", "multigrid"},
          [](Method& m, const std::string& name) { m.preconditioner = name; });
    cross(configurations, few ? std::vector{1e-2, 1e-4} : std::vector{1e-1, 1e-2, 1e-4, 1e-8},
          [](Method& m, double tolerance) { m.tolerance = tolerance; });
  }
  cross(configurations, std::vector{Jacobian::definite, Jacobian::bw98},
        [](Method& m, Jacobian jacobian) { m.jacobian = jacobian; });
  cross(configurations, std::vector{1, 20}, [](Method& m, int newton) { m.newton = newton; });
  if (few)
    std::erase_if(configurations, [](const Configuration& configuration) {
      return configuration.method.newton > 1 && configuration.method.jacobian == Jacobian::bw98;
    });
  return configurations;
}

}  // namespace

std::string name_of(const Configuration& configuration) {
  if (!is_of_step(configuration))
    return describe(configuration, " " + std::to_string(configuration.sweeps));
  return describe(configuration,
                  configuration.step > 3 ? " " + power_of_ten(configuration.method.tolerance) : "");
}

std::string kind_of(const Configuration& configuration) {
  return describe(configuration, "");
}

std::string options_of(const Configuration& configuration) {
  if (!is_of_step(configuration)) return {};
  std::string options;
  const Method& m = configuration.method;
  if (configuration.step == 3 && m.solver != defaults.solver) options += " --solver " + m.solver;
  if (configuration.step > 3 && m.preconditioner != defaults.preconditioner)
    options += " --preconditioner " + m.preconditioner;
  if (configuration.step > 3 && m.tolerance != defaults.tolerance)
    options += " --tolerance " + power_of_ten(m.tolerance);
  if (configuration.step > 2 && m.jacobian != defaults.jacobian) options += " --jacobian bw98";
  if (configuration.step > 2 && m.newton != defaults.newton)
    options += " --newton " + std::to_string(m.newton);
  return options;
}

std::vector<Configuration> configurations_of(const std::vector<int>& steps, bool few) {
  std::vector<Configuration> configurations;
  for (int step : steps) {
    const std::vector<Configuration> more =
        step < 3 ? std::vector<Configuration>{{step}} : implicit_configurations(step, few);
    configurations.insert(configurations.end(), more.begin(), more.end());
  }
  const std::vector<int> sweeps = few ? std::vector{1, 4} : std::vector{1, 4, 16, 64};
  for (int n : sweeps) configurations.push_back(xpbd_of(n));
  for (int n : sweeps) configurations.push_back(vbd_of(n));
  return configurations;
}

std::vector<long> step_counts(const Configuration& configuration, double end, double h_crit) {
  std::vector<long> counts;
  if (is_explicit(configuration))
    for (double part : {2.0, 0.95, 0.5, 0.25, 0.125, 0.0625, 0.03125})
      counts.push_back(std::max(1L, std::lround(std::ceil(end / (part * h_crit)))));
  else
    for (long n = 8; counts.size() < 9 && (n == 8 || end / double(n) >= h_crit / 8); n *= 2)
      counts.push_back(n);
  return counts;
}

}  // namespace tradeoff
