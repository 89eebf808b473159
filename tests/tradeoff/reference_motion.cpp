#include "tradeoff/reference_motion.h"

#include <cstdio>

#include "bench/cpu_time.h"
#include "physics/reference.h"
#include "ways/way.h"

namespace tradeoff {

namespace {

constexpr double moved = 1e-9;   // m
constexpr double enough = 1e-6;  // of the size: an error that no trial undercuts

// The Runge-Kutta method on the forces of a step that has them all. Of a force, pins leave what their
// filter does; of the velocities at the start, they prescribe what they hold.
class FineMotion {
 public:
  explicit FineMotion(const StudyScene& study)
      : cloth(study.scene.cloth), start(study.scene.start),
        simulator(
            make_simulator({cloth.hinges.bend || cloth.quadratic_hinges.bend ? 5 : 2}, cloth)),
        end(study.scene.time.end) {
    for (const Pin& pin : cloth.pins) {
      const Vec3 v = start.v.segment<3>(3 * pin.vertex);
      start.v.segment<3>(3 * pin.vertex) = pin.velocity + pin.S * (v - pin.velocity);
    }
  }

  State run(long steps, double by = 0) {
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
    State state = begun_elsewhere(by);
    cloth.hinges.follow(state.x);
    for (long n = 0; n < steps; ++n) {
      step(end / double(steps), state);
      cloth.hinges.follow(state.x);
    }
    return state;
  }

  // Vertices up to `by` m from where they should be, irregular and the same on every machine.
  State begun_elsewhere(double by) const {
    State state = start;
    for (int i = 0; i < state.x.size(); ++i)
      if (cloth.inverse_mass[i] > 0) state.x[i] += by * std::sin(12.9898 * i);
    return state;
  }

  double distance(const State& a, const State& b) const { return rms_distance(cloth, a.x, b.x); }
  long coarsest() {
    const double h = critical_step(*simulator, cloth, start);
    return std::max(8L, std::lround(std::ceil(end / (0.5 * h))));
  }

 private:
  Cloth cloth;
  State start;
  std::unique_ptr<Simulator> simulator;
  double end;
};

}  // namespace

std::string Reference::refusal() const {
  if (floor() <= worst_floor) return {};
  char text[300];
  if (self_check >= 1e300)
    std::snprintf(text, sizeof text,
                  "there is no time for a reference: %ld steps of order 4 took %.0f s", steps,
                  seconds);
  else if (!(1e3 * self_check <= worst_floor))
    std::snprintf(
        text, sizeof text,
        "the reference is not converged: %ld and %ld steps of order 4 end %.1e of the size apart, "
        "and it would take %.0e",
        steps / 2, steps, self_check, 1e-3 * worst_floor);
  else
    std::snprintf(
        text, sizeof text,
        "the scene makes %.0f nm out of 1 nm, so that with %.1e left between two references no "
        "error below %.0e can be told",
        growth, self_check, floor());
  return text;
}

Reference find_reference(const StudyScene& study, double patience) {
  FineMotion motion(study);
  Reference reference;
  const double begin = cpu_seconds();
  long steps = motion.coarsest();
  State before = motion.run(steps);
  double last = cpu_seconds() - begin;
  reference.growth = motion.distance(motion.run(steps, moved), before) /
                     motion.distance(motion.begun_elsewhere(moved), motion.begun_elsewhere(0));
  reference.steps = steps;
  reference.state = before;
  while (!(reference.floor() < enough) && cpu_seconds() - begin + 2 * last < patience) {
    const double check_before = reference.self_check, at = cpu_seconds();
    reference.steps = steps *= 2;
    reference.state = motion.run(steps);
    last = cpu_seconds() - at;
    const double check = motion.distance(reference.state, before) / study.size;
    reference.self_check = std::isfinite(check) ? check : 1e300;
    if (check_before < 1e300) reference.order = std::log2(check_before / reference.self_check);
    before = reference.state;
    if (reference.order < 2 && reference.self_check < 1e-10) break;  // the rest is rounding
  }
  reference.seconds = cpu_seconds() - begin;
  return reference;
}

}  // namespace tradeoff
