#include "tradeoff/trial.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace tradeoff {

namespace {

const Method defaults;

// 1e-4
std::string power_of_ten(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "1e%ld", std::lround(std::log10(value)));
  return text;
}

std::string describe(const Way& way, const std::string& tolerance) {
  std::string name = std::string(program_of(way.step)).substr(0, 6);
  const Method& m = way.method;
  if (way.step == 3) name += " " + m.solver;
  if (way.step > 3) name += " " + m.preconditioner + tolerance;
  if (way.step > 2 && m.jacobian == Jacobian::bw98) name += " bw98";
  if (way.step > 2 && m.newton > 1) name += " newton";
  return name;
}

// The choices of the implicit steps, each multiplied with those so far.
template <class Choices, class Set>
void cross(std::vector<Way>& ways, const Choices& choices, const Set& set) {
  std::vector<Way> all;
  for (const Way& way : ways)
    for (const auto& choice : choices) {
      all.push_back(way);
      set(all.back().method, choice);
    }
  ways = all;
}

std::vector<Way> implicit_ways(int step, bool few) {
  using Names = std::vector<std::string>;
  std::vector<Way> ways = {{step}};
  if (step == 3)
    cross(ways, few ? Names{"ldlt"} : Names{"ldlt", "cholmod", "inverse"},
          [](Method& m, const std::string& name) { m.solver = name; });
  else {
    cross(ways,
          few ? Names{"block", "multigrid"} : Names{"none", "jacobi", "block", "ic", "multigrid"},
          [](Method& m, const std::string& name) { m.preconditioner = name; });
    cross(ways, few ? std::vector{1e-2, 1e-4} : std::vector{1e-1, 1e-2, 1e-4, 1e-8},
          [](Method& m, double tolerance) { m.tolerance = tolerance; });
  }
  cross(ways, std::vector{Jacobian::definite, Jacobian::bw98},
        [](Method& m, Jacobian jacobian) { m.jacobian = jacobian; });
  cross(ways, std::vector{1, 20}, [](Method& m, int newton) { m.newton = newton; });
  if (few)
    std::erase_if(ways, [](const Way& way) {
      return way.method.newton > 1 && way.method.jacobian == Jacobian::bw98;
    });
  return ways;
}

}  // namespace

std::string name_of(const Way& way) {
  return describe(way, way.step > 3 ? " " + power_of_ten(way.method.tolerance) : "");
}

std::string kind_of(const Way& way) {
  return describe(way, "");
}

std::string options_of(const Way& way) {
  std::string options;
  const Method& m = way.method;
  if (way.step == 3 && m.solver != defaults.solver) options += " --solver " + m.solver;
  if (way.step > 3 && m.preconditioner != defaults.preconditioner)
    options += " --preconditioner " + m.preconditioner;
  if (way.step > 3 && m.tolerance != defaults.tolerance)
    options += " --tolerance " + power_of_ten(m.tolerance);
  if (way.step > 2 && m.jacobian != defaults.jacobian) options += " --jacobian bw98";
  if (way.step > 2 && m.newton != defaults.newton)
    options += " --newton " + std::to_string(m.newton);
  return options;
}

std::vector<Way> ways_of(const std::vector<int>& steps, bool few) {
  std::vector<Way> ways;
  for (int step : steps) {
    const std::vector<Way> more = step < 3 ? std::vector<Way>{{step}} : implicit_ways(step, few);
    ways.insert(ways.end(), more.begin(), more.end());
  }
  return ways;
}

std::vector<long> step_counts(const Way& way, double end, double h_crit) {
  std::vector<long> counts;
  if (way.step < 3)
    for (double part : {2.0, 0.95, 0.5, 0.25, 0.125, 0.0625, 0.03125})
      counts.push_back(std::max(1L, std::lround(std::ceil(end / (part * h_crit)))));
  else
    for (long n = 8; counts.size() < 9 && (n == 8 || end / double(n) >= h_crit / 8); n *= 2)
      counts.push_back(n);
  return counts;
}

}  // namespace tradeoff
