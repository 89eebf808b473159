#include "explain/survey.h"

#include <algorithm>
#include <cmath>

#include "math/energy.h"
#include "math/stable_step.h"
#include "program/diagnostics.h"
#include "program/progress.h"
#include "text/machine.h"
#include "text/text.h"

namespace {

constexpr double time_budget = 13;     // s of CPU time, for the runs that advance together
constexpr int rounds_per_stop = 2;     // of timings
constexpr long progress_steps = 1000;  // the resolution of the progress line

double median_of(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + long(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

void require_memory(const Survey& s) {
  const Memory memory = s.baseline.simulation.memory();
  const double runs = 6 + double(s.left_out.size());
  const double needed = runs * double(memory.vectors + memory.matrices + memory.slots);
  if (needed < 0.7 * physical_memory()) return;
  throw BadInput(
      text("--explain: %.0f runs side by side need at least %.0f MB of memory, this machine "
           "has %.0f MB; take fewer cells",
           runs, needed / 1e6, physical_memory() / 1e6));
}

// Times steps and evaluations of the forces, of the whole cloth and without each part, in
// interleaved rounds. The folds that the forces follow are found before them, as in a step.
class StepClock {
 public:
  StepClock(const Trials& trials, const std::vector<Part>& parts)
      : h(trials.scene.time.h),
        baseline(trials.simulate(trials.scene.cloth, trials.options.method)),
        cloth(trials.scene.cloth), saved(parts.size()) {
    for (const Part& part : parts) without.push_back(part.cloth);
  }
  void measure(const Survey& s, const State& state) {
    for (int round = 0; round < rounds_per_stop; ++round) {
      forces.push_back(seconds(baseline, cloth, state));
      State moved = state;
      step.push_back(seconds_of([&] { baseline.step(h, moved); }));
      for (size_t p = 0; p < without.size(); ++p)
        saved[p].push_back(forces.back() - seconds(s.left_out[p].simulation, without[p], state));
    }
  }
  void store_medians(Survey& s) const {
    s.median_step = median_of(step);
    s.median_forces = median_of(forces);
    for (const std::vector<double>& of_part : saved) s.median_saved.push_back(median_of(of_part));
  }

 private:
  // The second evaluation counts: as in a run, the first has left everything in the caches.
  static double seconds(const Simulation& simulation, Cloth& of, const State& state) {
    const auto evaluate = [&] {
      follow(of.hinges.elements, state.x);
      simulation.forces(state);
    };
    evaluate();
    return seconds_of(evaluate);
  }

  double h;
  Simulation baseline;
  Cloth cloth;
  std::vector<Cloth> without;
  std::vector<double> step, forces;
  std::vector<std::vector<double>> saved;
};

void time_a_step(std::vector<StepTimes>& methods, const Trials& trials, double h,
                 const State& from) {
  for (StepTimes& times : methods) {
    const Simulation simulation = trials.simulate(trials.scene.cloth, times.with.method);
    State state = from;
    times.seconds.push_back(seconds_of([&] { simulation.step(h, state); }));
  }
}

// Not every method can solve every scene, and not every solver is built in.
void drop_impossible(std::vector<StepTimes>& methods, const Trials& trials) {
  std::erase_if(methods, [&](const StepTimes& times) {
    try {
      trials.simulate(trials.scene.cloth, times.with.method);
      return false;
    } catch (const std::invalid_argument&) {
      return true;
    }
  });
}

Survey begin(const Trials& trials, const std::vector<Part>& parts) {
  const Cloth& cloth = trials.scene.cloth;
  const Method& method = trials.options.method;
  Survey s{.size = box_of(trials.scene.start.x).diagonal().norm(),
           .baseline = trials.trial("", cloth, method),
           .half = trials.trial("", cloth, method, 0.5),
           .quarter = trials.trial("", cloth, method, 0.25),
           .perturbed = trials.perturbed(perturbation)};
  for (const Part& part : parts)
    s.left_out.push_back(trials.trial(part.option, part.cloth, method));
  require_memory(s);
  if (trials.options.concepts.implicit) s.tenth_h.push_back({{"", method}});
  if (trials.options.concepts.iterative) {
    const NamedMethod tight = trials.tighter();
    s.tighter = trials.trial(tight.options, cloth, tight.method);
    s.tenth_h.push_back({tight});
  }
  for (const NamedMethod& other : trials.other_methods()) s.other_methods.push_back({other});
  drop_impossible(s.other_methods, trials);
  return s;
}

std::vector<Trial*> compared_with_baseline(Survey& s) {
  std::vector<Trial*> trials = {&s.baseline, &s.half, &s.quarter, &s.perturbed};
  if (s.tighter) trials.push_back(&*s.tighter);
  for (Trial& trial : s.left_out) trials.push_back(&trial);
  return trials;
}

// A run that has moved a quarter of the cloth's size away no longer resembles the scene, and a step
// of it may take any time.
void end_if_far(Trial& trial, double size, double time) {
  if (!trial.ended.empty() || trial.distance_at.back() < size / 4) return;
  trial.ended = text("stopped at t = %.3g s, %.0f %% of the size away", time,
                     100 * trial.distance_at.back() / size);
}

void record_stop(Survey& s) {
  const VecX &x = s.baseline.state.x, &half = s.half.state.x, &quarter = s.quarter.state.x;
  s.times.push_back(double(s.baseline.steps) * s.baseline.h);
  s.extrapolated_at.push_back(2 * quarter - half);
  s.error_at.push_back(rms_distance(x, s.extrapolated_at.back()));
  s.order_at.push_back(std::log2(rms_distance(x, half) / rms_distance(half, quarter)));
  for (Trial* trial : compared_with_baseline(s)) trial->compare_with(x);
  for (Trial& trial : s.left_out) end_if_far(trial, s.size, s.times.back());
}

// One after the other, to the stop that the other runs have reached.
void run_cheaper(Survey& s, const Trials& trials) {
  for (const auto& make : trials.cheaper()) try {
      Trial trial = make();
      for (const VecX& best : s.extrapolated_at) {
        trial.advance();
        trial.compare_with(best);
      }
      trial.simulation = {};
      s.cheaper.push_back(std::move(trial));
    } catch (const std::invalid_argument&) {
    } catch (const BadInput&) {
    }
}

double h_crit_of(const Cloth& cloth, const State& start, const Simulate& simulate,
                 const Method& method) {
  return critical_step(cloth, start, simulate(cloth, method).forces);
}

}  // namespace

double StepTimes::median() const {
  return median_of(seconds);
}

double Survey::mean_seconds() const {
  return (baseline.seconds + perturbed.seconds) / 2;
}

double Survey::mean_step() const {
  return (baseline.seconds + perturbed.seconds) / double(baseline.steps + perturbed.steps);
}

double Survey::timing_noise() const {
  return std::abs(baseline.seconds - perturbed.seconds) / mean_seconds();
}

std::optional<size_t> Survey::last_reliable_stop() const {
  const auto near_one = [&](size_t stop) { return order_at[stop] > 0.8 && order_at[stop] < 1.25; };
  for (size_t stop = times.size(); stop-- > 0;)
    if (near_one(stop) && (stop == 0 || near_one(stop - 1))) return stop;
  return {};
}

double Survey::error_of_h(size_t stop) const {
  const std::optional<size_t> reliable = last_reliable_stop();
  return reliable && stop <= *reliable ? error_at[stop] : quarter.distance_at[stop];
}

bool Survey::is_below_error(const Trial& trial) const {
  return trial.ended.empty() && trial.distance_at[last()] < error_of_h(last());
}

const StepTimes* Survey::step_of_a_tenth() const {
  if (tenth_h.empty()) return nullptr;
  const size_t stop = compared_at();
  const bool tight = tighter && tighter->distance_at[stop] > 0.03 * error_of_h(stop);
  return &tenth_h[tight ? 1 : 0];
}

const Trial* Survey::best_cheaper() const {
  const size_t stop = compared_at();
  const auto is_better = [&](const Trial& a, const Trial& b) {
    const bool a_fits = a.seconds < 0.1 * baseline.seconds,
               b_fits = b.seconds < 0.1 * baseline.seconds;
    if (a_fits != b_fits) return a_fits;
    return a_fits ? a.distance_at[stop] < b.distance_at[stop] : a.seconds < b.seconds;
  };
  const Trial* best = nullptr;
  for (const Trial& trial : cheaper)
    if (trial.ended.empty() && (!best || is_better(trial, *best))) best = &trial;
  return best;
}

const StepTimes* Survey::better_method(double tolerance) const {
  const StepTimes* best = nullptr;
  for (const StepTimes& other : other_methods)
    if (other.with.method.tolerance <= tolerance && (!best || other.median() < best->median()))
      best = &other;
  return best && best->median() < 0.8 * mean_step() ? best : nullptr;
}

Survey survey(const Options& options, const Scene& scene, const std::vector<Part>& parts,
              const Simulate& simulate) {
  const Trials trials(options, scene, simulate);
  Survey s = begin(trials, parts);
  StepClock clock(trials, parts);
  clock.measure(s, scene.start);

  Progress progress(progress_steps, "measuring: ", stderr);
  double spent = 0;  // s of CPU time
  const long stops = scene.time.steps() / trials.stride;
  for (long stop = 0; stop < stops && spent < time_budget && s.baseline.ended.empty(); ++stop)
    spent += seconds_of([&] {
      for (Trial* trial : compared_with_baseline(s)) {
        trial->advance();
        const double done = std::max((double(stop) + 0.5) / double(stops), spent / time_budget);
        progress.show(std::lround(done * progress_steps));
      }
      if (!s.baseline.ended.empty()) return;
      record_stop(s);
      time_a_step(s.tenth_h, trials, scene.time.h / 10, s.baseline.state);
      time_a_step(s.other_methods, trials, scene.time.h, s.baseline.state);
      clock.measure(s, s.baseline.state);
    });
  progress.end();
  clock.store_medians(s);
  run_cheaper(s, trials);
  return s;
}

Limit explicit_limit(const Scene& scene, const std::vector<Part>& parts, const Simulate& simulate,
                     const Method& method) {
  Limit limit = {h_crit_of(scene.cloth, scene.start, simulate, method), {}};
  for (const Part& part : parts)
    limit.without.push_back(h_crit_of(part.cloth, scene.start, simulate, method));
  return limit;
}

double largest_frequency(const Scene& scene) {
  VecX f;
  const auto forces = [&](const State& state) -> const VecX& {
    f.setZero(state.x.size());
    for_each_family(scene.cloth,
                    [&](const auto& family) { add_elastic_forces(family, state.x, f); });
    return f;
  };
  return 2 / critical_step(scene.cloth, scene.start, forces);
}
