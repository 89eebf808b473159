#include "explain/explain.h"

#include <cstdio>

#include "explain/page.h"

int explain(const Options& options, const Scene& scene, const Simulate& simulate) {
  const std::vector<Part> parts = parts_of(scene.cloth);
  print_scene(options, scene);
  std::fflush(stdout);
  const Survey s = survey(options, scene, parts, simulate);
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
