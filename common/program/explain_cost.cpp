// What is in the scene, and what a step of it costs.
#include <cstdio>

#include "program/explain_sections.h"
#include "program/explain_text.h"

namespace {

std::string describe_method(const Options& options) {
  const Method& method = options.method;
  if (!options.concepts.implicit) return "symplectic Euler";
  std::string words = method.newton == 1
                          ? "backward Euler, linearised once"
                          : text("backward Euler, up to %d Newton iterations", method.newton);
  if (method.jacobian == Jacobian::bw98) words += ", --jacobian bw98";
  if (options.concepts.direct) words += "; " + method.solver;
  if (options.concepts.iterative)
    words += text("; conjugate gradients (%s, tolerance %g)", method.preconditioner.c_str(),
                  method.tolerance);
  return words;
}

struct Cost {
  double seconds;
  size_t bytes;
};

void print_cost(const std::string& name, const Cost& cost, const Cost& whole,
                const std::string& why) {
  const double share = double(cost.bytes) / double(whole.bytes);
  std::printf("    %s%6s%12s%10s  %s\n", padded(name, 16).c_str(),
              percent(cost.seconds / whole.seconds).c_str(), percent(share).c_str(),
              bytes(cost.bytes).c_str(), why.c_str());
}

size_t element_and_slot_bytes(const Cloth& cloth, const Simulation& simulation) {
  return element_bytes(cloth) + simulation.held().slots;
}

Cost cost_of_step(const Scene& scene, const Survey& s) {
  const Held held = s.as_is.simulation.held();
  const size_t state = 4 * bytes_in(scene.start.x);  // x, v, mass, inverse mass
  return {step_seconds(s), state + held.vectors + held.matrices +
                               element_and_slot_bytes(scene.cloth, s.as_is.simulation)};
}

std::string describe_solve(const Options& options, const Survey& s) {
  const Method& method = options.method;
  if (!options.concepts.implicit) return "v += h M⁻¹ f, x += h v";
  std::string words = method.newton > 1 ? "Newton's other forces and energies, " : "";
  if (options.concepts.iterative)
    return words + text("%.1f iterations; preconditioner's bytes not counted",
                        double(s.as_is.simulation.counters().iterations) / double(s.as_is.steps));
  return words + method.solver + "; its factor's bytes not counted";
}

}  // namespace

void print_scene(const Options& options, const Scene& scene) {
  std::printf("%s explains %s\n", options.program.c_str(), scene.file.string().c_str());
  std::printf("The scene\n");
  print_wrapped(describe_elements(scene));
  const std::vector<std::string> terms = describe_terms(scene.cloth);
  print_wrapped(terms.empty() ? "no forces" : joined(terms, "; "));
  print_wrapped(
      text("h = %g s, %ld steps to t = %g s; ", scene.time.h, scene.time.steps(), scene.time.end) +
      describe_method(options));
}

double step_seconds(const Survey& s) {
  return (s.as_is.seconds + s.nudged.seconds) / double(s.as_is.steps + s.nudged.steps);
}

// A term costs what the forces take less without it; what stays is the solve.
void print_costs(const Options& options, const Scene& scene, const std::vector<Part>& parts,
                 const Survey& s) {
  const Cost whole = cost_of_step(scene, s);
  const size_t matrices = s.as_is.simulation.held().matrices;
  const size_t elements = element_and_slot_bytes(scene.cloth, s.as_is.simulation);
  std::printf("%s  time       bytes    of %.3g ms and %s (mean of %ld steps)\n",
              padded("A step costs", 18).c_str(), 1000 * whole.seconds, bytes(whole.bytes).c_str(),
              s.as_is.steps);

  Cost shared = {s.forces_seconds, elements};
  Cost solve = {whole.seconds - s.forces_seconds, whole.bytes - elements};
  for (size_t p = 0; p < parts.size(); ++p) {
    if (parts[p].is_damping) continue;
    const Simulation& without = s.left_out[p].simulation;
    const size_t own = elements - element_and_slot_bytes(parts[p].cloth, without);
    const size_t blocks = matrices - without.held().matrices;
    shared = {shared.seconds - s.without_seconds[p], shared.bytes - own};
    solve.bytes -= blocks;
    print_cost(parts[p].name, {s.without_seconds[p], own + blocks}, whole,
               blocks > 0 ? text("%s of it in the matrices", bytes(blocks).c_str()) : "");
  }
  if (scene.cloth.triangles.stretch && scene.cloth.triangles.shear)
    print_cost("triangles", shared, whole, "what stretch and shear share");
  else
    solve = {solve.seconds + shared.seconds, solve.bytes + shared.bytes};
  print_cost(options.concepts.implicit ? "solve" : "integration", solve, whole,
             describe_solve(options, s));
  if (!parts.empty() && parts.back().is_damping) {
    const size_t D = matrices - s.left_out.back().simulation.held().matrices;
    print_cost("of it, damping", {s.without_seconds.back(), D}, whole, "of all terms together");
  }
}
