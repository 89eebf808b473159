#include "explain/survey.h"

#include <algorithm>
#include <cmath>

#include "explain/page_layout.h"
#include "explain/waiting.h"
#include "text/machine.h"

namespace {

constexpr double patience = 13;  // s of the processor, of the runs that advance together
constexpr int rounds = 2;        // of forces, at a stop

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + long(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

void require_memory(const Survey& s) {
  const Held held = s.as_is.simulation.held();
  const double runs = 6 + double(s.left_out.size());
  const double bytes = runs * double(held.vectors + held.matrices + held.slots);
  const double there = physical_memory();
  if (bytes < 0.7 * there) return;
  throw BadInput(
      text("--explain: %.0f runs side by side need at least %.0f MB of memory, this machine "
           "has %.0f MB; take fewer cells",
           runs, bytes / 1e6, there / 1e6));
}

// Interleaved rounds of a step, and of its forces with the folds that it follows before them: of the cloth
// as it is and without each of its parts.
class StepClock {
 public:
  StepClock(const Trials& trials, const std::vector<Part>& parts)
      : h(trials.scene.time.h), as_is(trials.simulate(trials.scene.cloth, trials.options.method)),
        cloth(trials.scene.cloth), saved(parts.size()) {
    for (const Part& part : parts) without.push_back(part.cloth);
  }
  void measure(const Survey& s, const State& state) {
    for (int round = 0; round < rounds; ++round) {
      whole.push_back(seconds(as_is, cloth, state));
      State moved = state;
      step.push_back(seconds_of([&] { as_is.step(h, moved); }));
      for (size_t p = 0; p < without.size(); ++p)
        saved[p].push_back(whole.back() - seconds(s.left_out[p].simulation, without[p], state));
    }
  }
  void tell(Survey& s) const {
    s.round_seconds = median(step);
    s.forces_seconds = median(whole);
    for (const std::vector<double>& one : saved) s.without_seconds.push_back(median(one));
  }

 private:
  // The second time: as in a run, where the step before has left everything in the caches.
  static double seconds(const Simulation& simulation, Cloth& of, const State& state) {
    const auto evaluate = [&] {
      follow(of.hinges.elements, state.x);
      simulation.forces(state);
    };
    evaluate();
    return seconds_of(evaluate);
  }

  double h;
  Simulation as_is;
  Cloth cloth;
  std::vector<Cloth> without;
  std::vector<double> step, whole;
  std::vector<std::vector<double>> saved;
};

void take_a_step(std::vector<Probe>& probes, const Trials& trials, double h, const State& from) {
  for (Probe& probe : probes) {
    const Simulation simulation = trials.simulate(trials.scene.cloth, probe.way.method);
    State state = from;
    probe.seconds.push_back(seconds_of([&] { simulation.step(h, state); }));
  }
}

// Not every scene can be solved in every way, nor is every solver built in.
void keep_possible(std::vector<Probe>& probes, const Trials& trials) {
  std::erase_if(probes, [&](const Probe& probe) {
    try {
      trials.simulate(trials.scene.cloth, probe.way.method);
      return false;
    } catch (const std::invalid_argument&) {
      return true;
    }
  });
}

Survey begin(const Trials& trials, const std::vector<Part>& parts) {
  const Cloth& cloth = trials.scene.cloth;
  const Method& method = trials.options.method;
  Survey s{.as_is = trials.trial("", cloth, method),
           .half = trials.trial("", cloth, method, 0.5),
           .quarter = trials.trial("", cloth, method, 0.25),
           .nudged = trials.nudged(nudge),
           .tighter = {},
           .left_out = {},
           .cheaper = {},
           .tenth_h = {},
           .other_methods = {}};
  s.size = box_of(trials.scene.start.x).diagonal().norm();
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
  keep_possible(s.other_methods, trials);
  return s;
}

std::vector<Trial*> compared_with_as_is(Survey& s) {
  std::vector<Trial*> trials = {&s.as_is, &s.half, &s.quarter, &s.nudged};
  if (s.tighter) trials.push_back(&*s.tighter);
  for (Trial& trial : s.left_out) trials.push_back(&trial);
  return trials;
}

// What is a quarter of its size away is another scene, and may cost any time.
void end_if_far(Trial& trial, double size, double time) {
  if (!trial.ended.empty() || trial.distance_at.back() < size / 4) return;
  trial.ended = text("another scene: %.0f %% away by t = %.3g s",
                     100 * trial.distance_at.back() / size, time);
}

void note_stop(Survey& s) {
  const VecX &x = s.as_is.state.x, &half = s.half.state.x, &quarter = s.quarter.state.x;
  s.times.push_back(double(s.as_is.steps) * s.as_is.h);
  s.best_at.push_back(2 * quarter - half);
  s.error_at.push_back(rms_distance(x, s.best_at.back()));
  s.order_at.push_back(std::log2(rms_distance(x, half) / rms_distance(half, quarter)));
  for (Trial* trial : compared_with_as_is(s)) trial->note(x);
  for (Trial& trial : s.left_out) end_if_far(trial, s.size, s.times.back());
}

// One after the other, to where the others have come.
void run_cheaper(Survey& s, const Trials& trials) {
  for (const auto& make : trials.cheaper()) try {
      Trial trial = make();
      for (const VecX& best : s.best_at) {
        trial.advance();
        trial.note(best);
      }
      trial.simulation = {};
      s.cheaper.push_back(std::move(trial));
    } catch (const std::invalid_argument&) {
    } catch (const BadInput&) {
    }
}

}  // namespace

double Probe::median() const {
  return ::median(seconds);
}

std::optional<size_t> Survey::told() const {
  const auto near_one = [&](size_t stop) { return order_at[stop] > 0.8 && order_at[stop] < 1.25; };
  for (size_t stop = times.size(); stop-- > 0;)
    if (near_one(stop) && (stop == 0 || near_one(stop - 1))) return stop;
  return {};
}

double Survey::error_of_h(size_t stop) const {
  return told() && stop <= *told() ? error_at[stop] : quarter.distance_at[stop];
}

Survey survey(const Options& options, const Scene& scene, const std::vector<Part>& parts,
              const Simulate& simulate) {
  const Trials trials(options, scene, simulate);
  Survey s = begin(trials, parts);
  StepClock clock(trials, parts);
  clock.measure(s, scene.start);

  Waiting waiting;
  double spent = 0;  // s of the processor
  const long stops = scene.time.steps() / trials.stride;
  for (long stop = 0; stop < stops && spent < patience && s.as_is.ended.empty(); ++stop)
    spent += seconds_of([&] {
      for (Trial* trial : compared_with_as_is(s)) {
        trial->advance();
        waiting.show(std::max((double(stop) + 0.5) / double(stops), spent / patience));
      }
      if (!s.as_is.ended.empty()) return;
      note_stop(s);
      take_a_step(s.tenth_h, trials, scene.time.h / 10, s.as_is.state);
      take_a_step(s.other_methods, trials, scene.time.h, s.as_is.state);
      clock.measure(s, s.as_is.state);
    });
  clock.tell(s);
  run_cheaper(s, trials);
  return s;
}
