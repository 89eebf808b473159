#include "explain/explain.h"

#include <cstdio>
#include <stdexcept>

#include "explain/page.h"
#include "program/report.h"

namespace {

// A solver that gives up leaves the cloth where it is: this is not a cloth at rest.
bool every_step_failed(const Options& options, const Survey& s) {
  const long failed = s.baseline.simulation.counters().indefinite;
  return options.method.jacobian == Jacobian::definite && failed >= s.baseline.steps &&
         s.baseline.steps > 0;
}

}  // namespace

int explain(const Options& options, const Scene& scene, const Simulate& simulate) {
  const std::vector<Part> parts = parts_of(scene.cloth);
  print_scene(options, scene);
  std::fflush(stdout);
  const Survey s = survey(options, scene, parts, simulate);
  if (every_step_failed(options, s)) throw std::runtime_error(no_result(s.baseline.steps));
  print_costs(options, scene, parts, s);
  if (options.concepts.implicit)
    print_implicit_limit(scene);
  else
    print_explicit_limit(scene, parts, explicit_limit(scene, parts, simulate, options.method));
  print_error(options, scene, s);
  if (s.times.empty()) return 0;
  if (!parts.empty()) print_left_out(parts, s);
  print_advice(options, parts, s);
  return 0;
}
