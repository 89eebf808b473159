#include "program/report.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "text/text.h"

namespace {

// Another method that may not explode, where the method can be to blame.
std::string other_method(const Options& options) {
  const Method& method = options.method;
  if (!options.concepts.implicit) return "";
  if (method.jacobian == Jacobian::bw98) return "--jacobian definite, or ";
  if (!method.guard && method.newton == 1) return "--guard on, or ";
  if (method.newton == 1) return "--newton 20, or ";
  return options.concepts.iterative ? "a smaller --tolerance, or " : "";
}

// 0.85 or 1.2e+77
std::string fraction(double part) {
  return part >= 0.01 && part < 1000 ? text("%.2f", part) : text("%.2g", part);
}

void warn(const std::string& words) {
  std::printf("  warning: %s\n", words.c_str());
}

}  // namespace

std::string no_result(long steps) {
  return "the linear systems failed in all " + count(steps, "step") +
         ", so this is no result: the numbers of the scene are too far apart; "
         "check k, density, size and h";
}

void Report::start() const {
  std::printf("%s: %s, %d vertices, %zu triangles, h = %g s, %s to t = %.6g s\n",
              options.program.c_str(), scene.file.string().c_str(), scene.cloth.vertices(),
              scene.mesh.faces.size(), scene.time.h, count(scene.time.steps(), "step").c_str(),
              double(scene.time.steps()) * scene.time.h);
  std::fflush(stdout);  // h_crit of a large cloth takes seconds
}

void Report::critical_step(double h_crit) const {
  const double h = scene.time.h;
  if (std::isinf(h_crit)) {
    std::printf("  every h is stable: there is no elastic force\n");
    return;
  }
  std::printf("  stable below h_crit = %.4g s; h is %s of it\n", h_crit,
              fraction(h / h_crit).c_str());
  std::fflush(stdout);
  if (h > 0.9 * h_crit)
    std::fprintf(stderr, "warning: h = %g s is beyond 0.9 h_crit: the cloth %s; try --h %.2g\n", h,
                 h > h_crit ? "will explode" : "may become unstable", 0.8 * h_crit);
}

std::string Report::explosion(const RunTotals& run, const std::string& seen) const {
  std::string words = text("the cloth exploded in step %ld (t = %.6g s): ", run.steps,
                           double(run.steps) * scene.time.h) +
                      seen;
  if (run.counts.indefinite > 0)
    words += ", after " + count(run.counts.indefinite, "system") +
             " whose matrix was not positive definite";
  return words + "; " + advice(run);
}

std::string Report::advice(const RunTotals& run) const {
  const double h = scene.time.h, h_crit = run.h_crit;
  if (h_crit == 0) return "try " + other_method(options) + text("a smaller h than %g s", h);
  return text("h = %g s is %s of the stable step: try --h %.2g, a smaller k or fewer cells", h,
              fraction(h / h_crit).c_str(),
              h > h_crit ? 0.8 * h_crit : std::min(0.8 * h_crit, 0.5 * h));
}

void Report::end(const RunTotals& run, const Watch& watch, const State& state,
                 bool interrupted) const {
  // A flat cloth has rounding for an energy: that is zero.
  const auto joule = [&](double energy) {
    return std::abs(energy) < 1e-12 * watch.scale.joule ? 0 : energy;
  };
  std::printf(
      "%s: %ld steps in %.3g s (%.3g ms each), largest stretch %.4f, energy %.4g J at the "
      "start, %.4g J at the end\n",
      interrupted ? "stopped" : "done", run.steps, run.seconds,
      1000 * run.seconds / double(std::max(run.steps, 1L)), watch.most_stretch,
      joule(watch.start.total()), joule(energies(scene.cloth, state).total()));
  iterations(run);
  redone(run);
  warnings(run, watch, state);
  std::printf("  see %s\n", (options.out / (options.pictures ? "film.png" : "log.csv")).c_str());
  if (interrupted)
    std::printf("  final.obj and final_velocities.csv hold the cloth at t = %.6g s\n",
                double(run.steps) * scene.time.h);
}

void Report::video(const std::string& reason, const std::string& command) const {
  std::printf("  see %s", (options.out / "motion.png").c_str());
  if (reason.empty())
    std::printf(" and motion.mp4\n");
  else
    std::printf("; motion.mp4 was not made: %s. This command makes it:\n  %s\n", reason.c_str(),
                command.c_str());
}

void Report::iterations(const RunTotals& run) const {
  if (!options.concepts.iterative) return;
  std::printf("  %.1f iterations of conjugate gradients per %s (%s, tolerance %g)\n",
              double(run.counts.iterations) / double(std::max(run.steps, 1L)),
              options.method.newton == 1 && run.counts.redone == 0 ? "system" : "step",
              options.method.preconditioner.c_str(), options.method.tolerance);
}

void Report::redone(const RunTotals& run) const {
  const long redone = run.counts.redone;
  if (redone == 0) return;
  std::printf(
      "  took %ld of %ld steps again, by Newton's method: one linear system would have gained "
      "energy\n",
      redone, run.steps);
  if (2 * redone > run.steps)
    warn("one linear system is not enough for most steps: try a smaller h, or --newton 20");
}

long Report::collapsed_hinges(const VecX& x) const {
  const std::vector<Hinge>& hinges = scene.cloth.hinges.elements;
  return std::count_if(hinges.begin(), hinges.end(), [&](const Hinge& hinge) {
    return !has_angle(gather(hinge, x), hinge.lowest);
  });
}

// Counts that do not end a run but make its result doubtful.
void Report::warnings(const RunTotals& run, const Watch& watch, const State& state) const {
  const Counters& counts = run.counts;
  const bool iterative = options.concepts.iterative;
  if (watch.gained > 0)
    warn(text("the cloth had up to %.3g J more than at the start, %.2g times %s", watch.most_gained,
              watch.most_gained / watch.scale.joule,
              watch.scale.is_weight_times_size ? "weight × size" : "that energy"));
  if (counts.indefinite > 0 && iterative)
    warn(
        "conjugate gradients met cᵀA c ≤ 0, or a value that is not a number, and stopped early "
        "in " +
        count(counts.indefinite, "system"));
  if (counts.indefinite > 0 && !iterative)
    warn("the matrix was not positive definite in " + count(counts.indefinite, "system"));
  if (counts.capped > 0)
    warn("conjugate gradients stopped at " + count(options.method.max_iterations, "iteration") +
         " in " + count(counts.capped, "system") +
         ": the cloth moves as if it were stiffer; raise --max-iterations or take another "
         "--preconditioner");
  if (const long lines = collapsed_hinges(state.x); lines > 0)
    warn(count(lines, "hinge") + (lines == 1 ? " has" : " have") +
         " a flap that is pressed to a line, and cannot bend: where bending is stiffer than the "
         "threads, triangles collapse instead of unfolding");
  if (counts.unconverged > 0 && options.method.newton > 1)
    warn("Newton did not converge in " + count(counts.unconverged, "step"));
}
