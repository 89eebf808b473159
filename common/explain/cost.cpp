// What is in the scene, and what a step of it costs.
#include <cstdio>

#include "explain/page_layout.h"
#include "explain/sections.h"

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
  print_row(text("    %s%6s%9s%9s  %s", padded(name, 19).c_str(),
                 percent(cost.seconds / whole.seconds).c_str(), percent(share).c_str(),
                 bytes(cost.bytes).c_str(), why.c_str()));
}

size_t element_and_slot_bytes(const Cloth& cloth, const Simulation& simulation) {
  return element_bytes(cloth) + simulation.held().slots;
}

size_t bytes_of_step(const Scene& scene, const Survey& s) {
  const Held held = s.as_is.simulation.held();
  const size_t state = 4 * bytes_in(scene.start.x);  // x, v, mass, inverse mass
  return state + held.vectors + held.matrices +
         element_and_slot_bytes(scene.cloth, s.as_is.simulation);
}

std::string describe_solve(const Options& options, const Survey& s) {
  const Method& method = options.method;
  if (!options.concepts.implicit) return "v += h M⁻¹ f, x += h v";
  if (options.concepts.direct) return method.solver + "; the bytes of its factor are not counted";
  const long iterations = s.as_is.simulation.counters().iterations;
  return text("%.1f iterations; ", double(iterations) / double(s.as_is.steps)) +
         method.preconditioner + "'s own bytes are not counted";
}

// What went wrong on the way without ending it.
void print_doubts(const Options& options, const Survey& s) {
  const Counters counters = s.as_is.simulation.counters();
  std::vector<std::string> doubts;
  const auto doubt = [&](long number, const std::string& what) {
    if (number > 0) doubts.push_back(text("%ld ", number) + what);
  };
  doubt(counters.indefinite, std::string(options.concepts.iterative ? "systems" : "steps") +
                                 " whose matrix is not positive definite");
  doubt(counters.capped, "systems that reached --max-iterations");
  doubt(counters.unconverged, "steps in which Newton did not converge");
  if (!doubts.empty()) print_wrapped("worth a doubt: " + joined(doubts, ", "));
}

}  // namespace

void print_scene(const Options& options, const Scene& scene) {
  const std::filesystem::path directory = absolute(scene.file).parent_path().filename();
  print_row(options.program + ": " + (directory / scene.file.filename()).string());
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
  const Cost whole = {s.round_seconds, bytes_of_step(scene, s)};
  const size_t matrices = s.as_is.simulation.held().matrices;
  const size_t elements = element_and_slot_bytes(scene.cloth, s.as_is.simulation);
  print_row(padded("A step costs", 25) + "time    bytes           of " +
            text("%.3g ms (mean of %ld steps) and ", 1000 * step_seconds(s), s.as_is.steps) +
            bytes(whole.bytes));

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
  if (const auto sharing = sharing_terms(scene.cloth); !sharing.empty())
    print_cost("triangles", shared, whole, "what " + joined(sharing, " and ") + " share");
  else
    solve = {solve.seconds + shared.seconds, solve.bytes + shared.bytes};
  const char* rest = options.method.newton > 1   ? "Newton and solve"
                     : options.concepts.implicit ? "solve"
                                                 : "integration";
  print_cost(rest, solve, whole, describe_solve(options, s));
  if (!parts.empty() && parts.back().is_damping) {
    const size_t D = matrices - s.left_out.back().simulation.held().matrices;
    print_cost("of it, damping", {s.without_seconds.back(), D}, whole, "of all terms together");
  }
  print_doubts(options, s);
}
