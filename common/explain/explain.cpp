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

int explain(const Options& options, const Scene& scene, const Simulate& simulate,
            const TimeBudget& time) {
  const std::vector<Part> parts = parts_of(scene.cloth);
  print_scene(options, scene);
  const Trials trials(options, scene, parts, simulate, time);
  print_duration(time, trials.forecast());
  const Survey s = survey(trials);
  if (every_step_failed(options, s)) throw std::runtime_error(no_result(s.baseline.steps));
  print_costs(options, scene, parts, s);
  if (options.concepts.implicit)
    print_implicit_limit(scene, s.limit);
  else
    print_explicit_limit(scene, parts, s.limit);
  print_error(options, scene, s);
  if (!s.times.empty() && !parts.empty()) print_left_out(parts, s);
  if (!s.not_measured.empty()) print_not_measured(time, s);
  if (!s.times.empty()) print_advice(options, parts, s);
  return 0;
}
