#include "tradeoff/reference_motion.h"

#include "program/diagnostics.h"
#include "support/cpu_time.h"
#include "support/reference.h"
#include "support/text.h"
#include "ways/simulator.h"

namespace tradeoff {

namespace {

constexpr double moved = 1e-9;   // m
constexpr double enough = 1e-6;  // of the size: less than the error of any trial

// The Runge-Kutta method of order 4 on the forces of a step that has all of them. The filter of a
// pin removes the held part of a force. Every run begins with the folds of the start.
class FineMotion {
 public:
  explicit FineMotion(const StudyScene& study_)
      : study(study_), cloth(study.scene.cloth),
        simulator(make_simulator({std::max(2, first_step_of(cloth))}, cloth)) {}

  Reference run(long steps, double by = 0) {
    struct {
      VecX f;
    } system;
    const auto forces = [&](const Cloth&, const State& state, auto& to) {
      to.f = simulator->forces(state);
      for (const Pin& pin : cloth.pins) {
        const Vec3 f = to.f.template segment<3>(3 * pin.vertex);
        to.f.template segment<3>(3 * pin.vertex) = pin.S * f;
      }
    };
    const Stepper step = rk4(cloth, forces, system);
    Reference run;
    run.steps = steps;
    run.state = begun_elsewhere(by);
    cloth.hinges = study.scene.cloth.hinges;
    follow(cloth.hinges.elements, run.state.x);
    for (long n = 0; n < steps; ++n) {
      step(study.scene.time.end / double(steps), run.state);
      follow(cloth.hinges.elements, run.state.x);
    }
    run.energy = energy_of(cloth, run.state);
    return run;
  }

  // The start with every vertex perturbed by up to `by` m, irregularly and alike on every machine.
  State begun_elsewhere(double by) const {
    State state = study.scene.start;
    VecX away(state.x.size());
    for (int i = 0; i < away.size(); ++i) away[i] = by * std::sin(12.9898 * i);
    for (const Pin& pin : cloth.pins) {
      const Vec3 a = away.segment<3>(3 * pin.vertex);
      away.segment<3>(3 * pin.vertex) = pin.S * a;
    }
    state.x += away;
    return state;
  }

  double distance(const State& a, const State& b) const { return rms_distance(cloth, a.x, b.x); }

  // The number of steps of the first run. Its h is half of the longest step of symplectic Euler.
  long coarsest() {
    const double h = critical_step(*simulator, cloth, study.scene.start);
    return std::max(8L, std::lround(std::ceil(study.scene.time.end / (0.5 * h))));
  }

  // The distance of two runs at the end, divided by their distance at the start.
  double growth(const Reference& from) {
    const double grown = distance(run(from.steps, moved).state, from.state) /
                         distance(begun_elsewhere(moved), begun_elsewhere(0));
    return std::isfinite(grown) ? grown : 1e300;
  }

 private:
  const StudyScene& study;
  Cloth cloth;
  std::unique_ptr<Simulator> simulator;
};

}  // namespace

double energy_of(Cloth& cloth, const State& state) {
  follow(cloth.hinges.elements, state.x);
  return energies(cloth, state).total();
}

std::string Reference::refusal() const {
  if (floor() <= worst_floor) return {};
  if (!state.x.allFinite())
    return format("the reference exploded even with %ld steps of order 4", steps);
  if (self_check >= 1e300)
    return format("there is no time for a reference: %ld steps of order 4 take %.0f s", steps,
                  seconds);
  if (!(1e3 * self_check <= worst_floor))
    return format(
        "the reference is not converged: %ld and %ld steps of order 4 end %.1e of the size apart, "
        "and it would take %.0e",
        steps / 2, steps, self_check, 1e-3 * worst_floor);
  return format(
      "what begins 1 nm elsewhere ends %.0f nm elsewhere, and so no error below %.0e can be told "
      "while two references differ by %.1e",
      growth, floor(), self_check);
}

Reference find_reference(const StudyScene& study, double patience,
                         const std::function<void(const Reference&)>& report) {
  FineMotion motion(study);
  const double begin = cpu_seconds();
  Reference last = motion.run(motion.coarsest());
  last.seconds = cpu_seconds() - begin;
  double run_seconds = last.seconds;
  while (last.seconds + 4 * run_seconds < patience) {  // two runs: baseline and perturbed
    const double at = cpu_seconds();
    Reference finer = motion.run(2 * last.steps);
    run_seconds = cpu_seconds() - at;
    const double apart = motion.distance(finer.state, last.state) / study.size;
    finer.self_check = std::isfinite(apart) ? apart : 1e300;
    if (last.self_check < 1e300) finer.order = std::log2(last.self_check / finer.self_check);
    finer.growth = motion.growth(last);
    finer.seconds = cpu_seconds() - begin;
    last = finer;
    if (report) report(last);
    const bool only_rounding = last.order < 2 && last.self_check < 1e-10;
    if (last.floor() < enough || only_rounding) break;
  }
  return last;
}

}  // namespace tradeoff
