#include "explain/page.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "text/text.h"

namespace {

constexpr size_t page_width = 100;
constexpr double chaos = 1e4;  // growth of a perturbation from which on the motion is chaotic
constexpr double large_error = 0.05;  // of the size

void print_row(const std::string& columns) {
  std::printf("%s\n", columns.substr(0, columns.find_last_not_of(' ') + 1).c_str());
}

void print_wrapped(const std::string& words) {
  std::printf("%s", wrapped(words, page_width).c_str());
}

}  // namespace

// The scene ---------------------------------------------------------------------------------------

namespace {

std::string describe_method(const Options& options) {
  const Method& method = options.method;
  if (!options.concepts.implicit) return "symplectic Euler";
  std::string words = method.newton == 1
                          ? "backward Euler, linearised once"
                          : text("backward Euler, up to %d Newton iterations", method.newton);
  if (method.jacobian == Jacobian::bw98) words += ", --jacobian bw98";
  if (!method.guard) words += ", --guard off";
  if (options.concepts.direct) words += "; " + method.solver;
  if (options.concepts.iterative)
    words += text("; conjugate gradients (%s, tolerance %g)", method.preconditioner.c_str(),
                  method.tolerance);
  return words;
}

}  // namespace

void print_scene(const Options& options, const Scene& scene) {
  print_row(options.program + ": " + scene.name());
  print_wrapped(describe_elements(scene));
  const std::vector<std::string> terms = describe_terms(scene.cloth);
  print_wrapped(terms.empty() ? "no forces" : joined(terms, "; "));
  print_wrapped(
      text("h = %g s, %ld steps to t = %g s; ", scene.time.h, scene.time.steps(), scene.time.end) +
      describe_method(options));
}

void print_duration(const TimeBudget& time, double forecast) {
  const bool is_enough = forecast <= time.length();
  print_wrapped(
      text("measuring takes about %.0f s", std::ceil(is_enough ? forecast : time.length())) +
      (is_enough ? "" : text("; with all runs to the end it would take %.0f s", forecast)));
  std::fflush(stdout);
}

// Costs -------------------------------------------------------------------------------------------

namespace {

struct Cost {
  double seconds;
  size_t bytes;
};

void print_cost(const std::string& name, const Cost& cost, const Cost& whole,
                const std::string& remark) {
  const double share = double(cost.bytes) / double(whole.bytes);
  print_row("    " + padded(name, 19) +
            text("%6s%9s%9s  ", percent(cost.seconds / whole.seconds).c_str(),
                 percent(share).c_str(), bytes(cost.bytes).c_str()) +
            remark);
}

size_t element_and_slot_bytes(const Cloth& cloth, const Simulation& simulation) {
  return element_bytes(cloth) + simulation.memory().slots;
}

size_t bytes_of_step(const Scene& scene, const Survey& s) {
  const Memory memory = s.baseline.simulation.memory();
  const size_t state = 4 * bytes_in(scene.start.x);  // x, v, mass, inverse mass
  return state + memory.vectors + memory.matrices +
         element_and_slot_bytes(scene.cloth, s.baseline.simulation);
}

std::string name_of_solve(const Options& options) {
  if (!options.concepts.implicit) return "integration";
  return options.method.newton > 1 ? "Newton and solve" : "solve";
}

std::string describe_solve(const Options& options, const Survey& s) {
  const Method& method = options.method;
  if (!options.concepts.implicit) return "v += h M⁻¹ f, x += h v";
  if (options.concepts.direct) return method.solver + "; the bytes of its factor are not counted";
  const long iterations = s.baseline.simulation.counters().iterations, steps = s.baseline.steps;
  return (steps > 0 ? text("%.1f iterations; ", double(iterations) / double(steps)) : "") +
         method.preconditioner + "'s own bytes are not counted";
}

// Counts that are not fatal but deserve a warning.
void print_warning(const Options& options, const Survey& s) {
  const Counters counters = s.baseline.simulation.counters();
  std::vector<std::string> warnings;
  const auto warn = [&](long number, const std::string& of_what) {
    if (number > 0) warnings.push_back(std::to_string(number) + of_what);
  };
  warn(counters.indefinite, " systems whose matrix is not positive definite");
  warn(counters.capped, " systems that reached --max-iterations");
  warn(counters.redone, " steps that were taken again, because one linear system gained energy");
  if (options.method.newton > 1)
    warn(counters.unconverged, " steps in which Newton did not converge");
  if (!warnings.empty()) print_wrapped("warning: " + joined(warnings, ", "));
}

}  // namespace

// Cost of a term = time of all forces − time without it. The remainder of the forces is shared by
// the terms, the remainder of the step is the solve.
void print_costs(const Options& options, const Scene& scene, const std::vector<Part>& parts,
                 const Survey& s) {
  const Cost whole = {s.median_step, bytes_of_step(scene, s)};
  const size_t matrices = s.baseline.simulation.memory().matrices;
  const size_t elements = element_and_slot_bytes(scene.cloth, s.baseline.simulation);
  print_row(padded("A step costs", 25) + "time    bytes           of " +
            text("%.3g ms (mean of %ld steps) and ", 1000 * s.mean_step(), s.baseline.steps) +
            bytes(whole.bytes));

  Cost shared = {s.median_forces, elements};
  Cost solve = {whole.seconds - s.median_forces, whole.bytes - elements};
  for (size_t p = 0; p < parts.size(); ++p) {
    if (parts[p].is_damping) continue;
    const Simulation& without = s.left_out[p].simulation;
    const size_t own = elements - element_and_slot_bytes(parts[p].cloth, without);
    const size_t blocks = matrices - without.memory().matrices;
    shared = {shared.seconds - s.median_saved[p], shared.bytes - own};
    solve.bytes -= blocks;
    print_cost(parts[p].name, {s.median_saved[p], own + blocks}, whole,
               blocks > 0 ? bytes(blocks) + " of them in the matrices" : "");
  }
  if (const Sharing sharing = sharing_of(scene.cloth); !sharing.terms.empty())
    print_cost(joined(sharing.elements, ", "), shared, whole,
               "shared by " + joined(sharing.terms, " and "));
  else
    solve = {solve.seconds + shared.seconds, solve.bytes + shared.bytes};
  print_cost(name_of_solve(options), solve, whole, describe_solve(options, s));
  if (!parts.empty() && parts.back().is_damping) {
    const size_t D = matrices - s.left_out.back().simulation.memory().matrices;
    print_cost("damping", {s.median_saved.back(), D}, whole,
               "of all terms, contained in the rows above");
  }
  print_warning(options, s);
}

// What sets h -------------------------------------------------------------------------------------

void print_explicit_limit(const Scene& scene, const std::vector<Part>& parts, const Limit& limit) {
  print_row("What sets h");
  if (std::isinf(limit.h_crit))
    return print_wrapped("every h is stable: there is no elastic force");
  print_wrapped(text("stable below h_crit = %.4g s; h is %.2f of it", limit.h_crit,
                     scene.time.h / limit.h_crit));
  std::vector<std::string> without;
  std::string strongest;
  double longest = 1.001 * limit.h_crit;
  for (size_t p = 0; p < limit.without.size(); ++p) {
    const double h = limit.without[p];
    if (std::abs(h / limit.h_crit - 1) > 0.001)
      without.push_back("without " + parts[p].name +
                        (std::isinf(h) ? " every h is stable" : text(" %.4g s", h)));
    if (h <= longest) continue;
    longest = h;
    strongest = parts[p].name;
  }
  if (!strongest.empty())
    print_wrapped(
        "h_crit " + joined(without, ", ") +
        (limit.without.size() == parts.size() ? ": " + strongest + " limits h most" : ""));
}

void print_implicit_limit(const Scene& scene, const Limit& limit) {
  print_row("What sets h");
  if (std::isinf(limit.h_crit))
    return print_wrapped("every h is stable: there is no elastic force");
  print_wrapped(text("h ω_max = %.3g; an explicit method needs h ω_max < 2, so h < h_crit = %.3g s",
                     2 * scene.time.h / limit.h_crit, limit.h_crit));
  print_wrapped("backward Euler has no such limit: the error sets h");
}

// The error of h ----------------------------------------------------------------------------------

namespace {

std::string of_size(double m, const Survey& s) {
  return length(m) + ", " + per_cent(m / s.size) + " of the size";
}

void print_estimated(const Survey& s, size_t stop) {
  print_wrapped(text("t = %.6g s: ", s.times[stop]) + of_size(s.error_at[stop], s) +
                text(" (%s); observed order %.2f", length(s.size).c_str(), s.order_at[stop]));
}

void print_not_estimated(const Survey& s) {
  const size_t last = s.last();
  const double growth = s.perturbed.distance_at[last] / perturbation;
  print_wrapped(text("t = %.6g s: no estimate; the runs with h and h/4 are ", s.times[last]) +
                of_size(s.quarter.distance_at[last], s) +
                text(", apart; observed order %.2f; ", s.order_at[last]) +
                text("a perturbation of %g m has grown %.2g times: ", perturbation, growth) +
                (growth > chaos
                     ? "the motion is chaotic, and every h ends in another place"
                     : "h decides how the cloth folds, and only a much smaller h shows order 1"));
}

void print_tenth_of_error(const Scene& scene, const Survey& s) {
  const StepTimes* tenth = s.step_of_a_tenth();
  const double now = s.mean_step(), then = tenth ? tenth->median() : now;
  const double steps = double(scene.time.steps());
  std::string options = text("--h %g", scene.time.h / 10);
  if (tenth && !tenth->with.options.empty()) options += " " + tenth->with.options;
  print_wrapped("for a tenth of the error (order 1): " + options +
                text("; a step takes %.3g ms, the scene %.3g s instead of %.3g s", 1000 * then,
                     10 * steps * then, steps * now));
}

void print_tenth_of_time(const Options& options, const Survey& s) {
  if (const Trial* best = s.best_cheaper())
    print_wrapped("for a tenth of the time: " + best->options + " takes " +
                  percent(best->seconds_to_stop / s.baseline.seconds_to_stop) +
                  " of the time; error " + of_size(best->distance_at[s.compared_at()], s));
  else
    print_wrapped("for a tenth of the time: no cheaper run was found");
  if (!options.concepts.implicit)
    print_wrapped(
        "for steps longer than h_crit: run this scene in step03_implicit, with --explain");
}

}  // namespace

void print_error(const Options& options, const Scene& scene, const Survey& s) {
  if (s.times.empty())
    return print_wrapped("the cloth " +
                         (s.baseline.ended.empty() ? "had no time to move" : s.baseline.ended) +
                         ": no error can be estimated");
  print_row("The error of h, RMS over the vertices");
  if (s.nothing_moves())
    return print_wrapped(text("no error until t = %.6g s: nothing moves", s.times[s.last()]));
  const std::optional<size_t> reliable = s.last_reliable_stop();
  if (reliable) print_estimated(s, *reliable);
  if (reliable != s.last()) print_not_estimated(s);
  if (s.tighter && s.tighter->ended.empty())
    print_wrapped(
        text("a tenth of the tolerance %g changes the result by ", options.method.tolerance) +
        length(s.tighter->distance_at[s.compared_at()]));
  print_tenth_of_error(scene, s);
  print_tenth_of_time(options, s);
}

// What could be left out, and advice --------------------------------------------------------------

namespace {

void print_one_left_out(const Part& part, const Trial& trial, const Survey& s) {
  std::string result = trial.ended;
  if (result.empty()) {
    const double change = trial.distance_at[s.last()];
    result = padded(length(change), 12) + padded(per_cent(change / s.size), 10) +
             padded(percent(1 - trial.seconds_to_stop / s.mean_seconds()), 6) +
             (s.is_below_error(trial) ? "below the error of h" : "");
  }
  print_row("    " + padded(part.name, 20) + padded(part.option, 27) + result);
}

// All damping as a whole stands for the damping of every term.
std::vector<std::string> names_below_error(const std::vector<Part>& parts, const Survey& s) {
  std::vector<std::string> names;
  for (size_t p = 0; p < parts.size(); ++p)
    if (s.is_below_error(s.left_out[p])) names.push_back(parts[p].name);
  if (!names.empty() && names.back() == "all damping")
    std::erase_if(names, [](const std::string& name) { return name.starts_with("damping of"); });
  return names;
}

}  // namespace

void print_left_out(const std::vector<Part>& parts, const Survey& s) {
  print_row(padded("What could be left out", 51) + "change      of size   time  " +
            text("until t = %.6g s", s.times[s.last()]));
  for (size_t p = 0; p < parts.size(); ++p) print_one_left_out(parts[p], s.left_out[p], s);
  print_wrapped(
      text("change: of the positions, RMS over the vertices; time: saved; two equal runs "
           "differ by %s",
           percent(s.timing_noise()).c_str()));
}

void print_not_measured(const TimeBudget& time, const Survey& s) {
  print_row(text("Not measured in %.0f s", time.length()));
  print_wrapped(joined(s.not_measured, "; "));
}

void print_advice(const Options& options, const std::vector<Part>& parts, const Survey& s) {
  print_row("Advice");
  if (s.nothing_moves()) return print_wrapped("Nothing moves: every h gives the same result.");
  std::vector<std::string> advice;
  const double error = s.error_of_h(s.compared_at());
  if (error > large_error * s.size)
    advice.push_back("First take a smaller h: the error is " + per_cent(error / s.size) +
                     " of the size.");
  if (const auto names = names_below_error(parts, s); !names.empty())
    advice.push_back("With this h, " + joined(names, " and ") +
                     " can be left out: the change is below the error of h.");
  if (const StepTimes* other = s.better_method(options.method.tolerance))
    advice.push_back(text("With %s a step takes %.3g ms, at the same tolerance.",
                          other->with.options.c_str(), 1000 * other->median()));
  if (s.last_reliable_stop() != s.last())
    advice.push_back("Compare final states by energies and the lowest point, not by positions.");
  if (advice.empty())
    advice.push_back("Each part that was left out changes the result by more than the error of h.");
  advice.resize(std::min<size_t>(advice.size(), 2));
  print_wrapped(joined(advice, " "));
}
