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

// The shares of the time budget that may be spent when these measurements end. Cheaper runs have the
// remainder.
constexpr double until_limit = 0.2, until_runs = 0.7;
constexpr int rounds_per_stop = 2;  // of timings
constexpr const char* no_time = "not measured: no time was left";
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
  explicit StepClock(const Trials& trials)
      : h(trials.scene.time.h), time(trials.time),
        baseline(trials.simulate(trials.scene.cloth, trials.options.method)),
        cloth(trials.scene.cloth), saved(trials.parts.size()) {
    for (const Part& part : trials.parts) without.push_back(part.cloth);
  }
  // At least once, and then while time is left.
  void measure(const Survey& s, const State& state) {
    for (int round = 0; round < rounds_per_stop && (step.empty() || time.is_left()); ++round) {
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
  const TimeBudget& time;
  Simulation baseline;
  Cloth cloth;
  std::vector<Cloth> without;
  std::vector<double> step, forces;
  std::vector<std::vector<double>> saved;
};

void time_a_step(StepTimes& times, const Trials& trials, double h, const State& from) {
  const Simulation simulation = trials.simulate(trials.scene.cloth, times.with.method);
  State state = from;
  times.seconds.push_back(seconds_of([&] { simulation.step(h, state); }));
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

Survey begin(const Trials& trials) {
  const Cloth& cloth = trials.scene.cloth;
  const Method& method = trials.options.method;
  Survey s{.size = box_of(trials.scene.start.x).diagonal().norm(),
           .baseline = trials.trial("", cloth, method),
           .half = trials.trial("", cloth, method, 0.5),
           .quarter = trials.trial("", cloth, method, 0.25),
           .perturbed = trials.perturbed(perturbation)};
  for (const Part& part : trials.parts)
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

void note_some(Survey& s, size_t some, size_t of, const std::string& things) {
  if (some > 0) s.not_measured.push_back(text("%zu of %zu ", some, of) + things);
}

// Of an explicit step, with its damping, and then without each part while time is left.
Limit explicit_limit(const Trials& trials) {
  const auto h_crit = [&](const Cloth& cloth) {
    return critical_step(cloth, trials.scene.start,
                         trials.simulate(cloth, trials.options.method).forces);
  };
  const TimeBudget time = trials.time.part(until_limit);
  Limit limit = {h_crit(trials.scene.cloth), {}};
  for (const Part& part : trials.parts)
    if (time.is_left()) limit.without.push_back(h_crit(part.cloth));
  return limit;
}

// Of an explicit step that an implicit one replaces, without damping.
Limit undamped_limit(const Scene& scene) {
  VecX f;
  const auto forces = [&](const State& state) -> const VecX& {
    f.setZero(state.x.size());
    for_each_family(scene.cloth,
                    [&](const auto& family) { add_elastic_forces(family, state.x, f); });
    return f;
  };
  return {critical_step(scene.cloth, scene.start, forces), {}};
}

// Without these there is no error.
std::vector<Trial*> indispensable(Survey& s) {
  return {&s.baseline, &s.half, &s.quarter, &s.perturbed};
}

std::vector<Trial*> compared_with_baseline(Survey& s) {
  std::vector<Trial*> trials = indispensable(s);
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

bool is_late(const Trial* trial) {
  return trial->is_late();
}

// All runs to their next stop. False if the time does not suffice: then the stop does not count. But
// a run that has not come to its first stop is given up, unless it is indispensable.
bool advance_together(Survey& s, const TimeBudget& time, const std::function<void()>& show) {
  for (Trial* trial : compared_with_baseline(s)) {
    trial->advance(time);
    show();
  }
  if (std::ranges::any_of(indispensable(s), is_late)) return false;
  for (Trial* trial : compared_with_baseline(s))
    if (trial->is_late() && trial->distance_at.empty()) trial->ended = no_time;
  return std::ranges::none_of(compared_with_baseline(s), is_late);
}

// A cheaper run to the stop that the other runs have reached; nothing if the time does not suffice.
std::optional<Trial> run_cheaper(const std::function<Trial()>& make, const Survey& s,
                                 const TimeBudget& time) {
  if (!time.is_left()) return {};
  Trial trial = make();
  for (const VecX& best : s.extrapolated_at) {
    trial.advance(time);
    if (trial.is_late()) return {};
    trial.compare_with(best);
  }
  trial.simulation = {};
  return trial;
}

// One after the other. Not every method can solve every scene.
void run_all_cheaper(Survey& s, const Trials& trials) {
  const auto all = trials.cheaper();
  size_t late = 0;
  for (const auto& make : all) try {
      if (std::optional<Trial> trial = run_cheaper(make, s, trials.time))
        s.cheaper.push_back(std::move(*trial));
      else
        ++late;
    } catch (const std::invalid_argument&) {
    } catch (const BadInput&) {
    }
  note_some(s, late, all.size(), "cheaper runs");
}

void note_lack_of_time(Survey& s, long stops) {
  if (s.baseline.ended.empty() && long(s.times.size()) < stops)
    s.not_measured.push_back(s.times.empty() ? "the motion"
                                             : text("the motion after t = %.3g s", s.times.back()));
  if (s.tighter && s.tighter->ended == no_time)
    s.not_measured.push_back("a tenth of the tolerance");
  const size_t methods = s.other_methods.size();
  const size_t late = std::erase_if(s.other_methods, [](auto& m) { return m.seconds.empty(); });
  note_some(s, late, methods, "other methods");
}

}  // namespace

double StepTimes::median() const {
  return median_of(seconds);
}

double Survey::mean_seconds() const {
  return (baseline.seconds_to_stop + perturbed.seconds_to_stop) / 2;
}

double Survey::mean_step() const {
  const long steps = baseline.steps + perturbed.steps;
  return steps > 0 ? (baseline.seconds + perturbed.seconds) / double(steps) : median_step;
}

double Survey::timing_noise() const {
  return std::abs(baseline.seconds_to_stop - perturbed.seconds_to_stop) / mean_seconds();
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
  const bool tight =
      tighter && tighter->ended.empty() && tighter->distance_at[stop] > 0.03 * error_of_h(stop);
  return &tenth_h[tight ? 1 : 0];
}

const Trial* Survey::best_cheaper() const {
  const size_t stop = compared_at();
  const auto is_better = [&](const Trial& a, const Trial& b) {
    const double tenth = 0.1 * baseline.seconds_to_stop;
    const bool a_fits = a.seconds_to_stop < tenth, b_fits = b.seconds_to_stop < tenth;
    if (a_fits != b_fits) return a_fits;
    return a_fits ? a.distance_at[stop] < b.distance_at[stop]
                  : a.seconds_to_stop < b.seconds_to_stop;
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

Survey survey(const Trials& trials) {
  Survey s = begin(trials);
  StepClock clock(trials);
  clock.measure(s, trials.scene.start);
  const bool implicit = trials.options.concepts.implicit;
  const size_t parts = trials.parts.size();
  s.limit = implicit ? undamped_limit(trials.scene) : explicit_limit(trials);
  if (!implicit)
    note_some(s, parts - s.limit.without.size(), parts, "values of h_crit without a part");

  const TimeBudget time = trials.time.part(until_runs);
  const double h = trials.scene.time.h;
  const long stops = trials.scene.time.steps() / trials.stride;
  Progress progress(progress_steps, "measuring: ", stderr);
  const auto show = [&] {
    const double done =
        std::max((double(s.times.size()) + 0.5) / double(stops), time.spent() / time.length());
    progress.show(std::lround(std::min(1.0, done) * progress_steps));
  };
  for (long stop = 0; stop < stops && advance_together(s, time, show) && s.baseline.ended.empty();
       ++stop) {
    record_stop(s);
    for (StepTimes& times : s.tenth_h) time_a_step(times, trials, h / 10, s.baseline.state);
    for (StepTimes& times : s.other_methods)
      if (time.is_left()) time_a_step(times, trials, h, s.baseline.state);
    clock.measure(s, s.baseline.state);
  }
  progress.end();
  clock.store_medians(s);
  run_all_cheaper(s, trials);
  note_lack_of_time(s, stops);
  return s;
}
