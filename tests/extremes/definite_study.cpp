// definite_study [--quick] [--summary]: ways to make the matrix definite (definite_ways.h), over scenes,
// h and k, with one linear system in every step and with --newton 50. Prints a table of all runs and then one
// row per way, in Markdown.
//
// All ways of a run take their steps in turn, so that a busy machine slows all of them alike. Times are CPU
// times, divided by that of `tension`.
#include <algorithm>
#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <deque>
#include <optional>

#include "extremes/definite_ways.h"
#include "program/diagnostics.h"
#include "program/progress.h"
#include "scene/hinges.h"
#include "support/cpu_time.h"
#include "support/extreme_scenes.h"
#include "ways/simulator.h"

namespace {

using namespace extremes;

// A sheet that lies folded flat on itself, free and without weight, and opens.
TestScene folded(double k) {
  TestScene scene = sheet(8, Held::free, k, k, Gravity::off);
  for (Eigen::Index i = 2; i < scene.start.x.size(); i += 3)
    scene.start.x[i] = -0.5 + std::abs(scene.start.x[i] + 0.5);
  scene.cloth.hinges.elements = make_hinges(scene.mesh);
  scene.cloth.term<DihedralBend>() = DihedralBend(0.1);
  start_angles(scene.cloth.hinges.elements, scene.start.x);
  return scene;
}

struct StudyScene {
  const char* name;
  MakeScene make;
  int step = 3;
  double judged = 0;  // s, when the error is measured; 0 where a small difference soon grows large
};
const std::array scenes = {
    StudyScene{"drop", dropped, 3, 0.5}, StudyScene{"curtain", curtain_of, 3, 0.3},
    StudyScene{"squeeze", squeezed},     StudyScene{"tangle", tangled},
    StudyScene{"strip", pushed_strip},   StudyScene{"fold", folded, 5}};

struct Study {
  bool quick = false, summary = false;

  std::vector<double> all_h() const {
    return quick ? std::vector{1.0 / 60, 0.1} : std::vector{1.0 / 240, 1.0 / 60, 0.1};
  }
  std::vector<double> all_k() const { return quick ? std::vector{1e3} : std::vector{1e3, 1e5}; }
  double seconds() const { return quick ? 0.5 : 1; }
  int fewest() const { return quick ? 10 : 30; }  // steps
};

struct Setting {
  const StudyScene* scene;
  double h, k;
  int newton;
};

struct Result {
  double gained = 0;  // J, the sum of all rises of the energy
  bool exploded = false;
  int steps = 0, definite = 0;  // definite: steps whose printed matrix was
  double time = 0, error = std::nan("");
  WayCounts counts;
};
using Results = std::array<Result, all_ways.size()>;

struct Row {
  Setting setting;
  Results results;
};

// One way ----------------------------------------------------------------------------------------

class Runner {
 public:
  Runner(Way way, const Setting& setting_, const std::optional<VecX>& truth_)
      : setting(setting_), truth(truth_), scene(setting.scene->make(setting.k)),
        simulator(make_way(way, setting.scene->step, scene.cloth, setting.newton)) {}

  void step() {
    if (result.exploded) return;
    State& state = scene.start;
    result.definite += simulator->full_is_definite(setting.h, state);
    const double before = energy();
    result.time += seconds([&] { simulator->step(setting.h, state); });
    ++result.steps;
    result.counts = simulator->counts();
    result.exploded = !(max_stretch(scene.mesh, state.x) <= exploded_stretch);
    const double rise = energy() - before;
    if (!(rise <= 1e-9 * std::abs(before))) result.gained += rise;
    if (truth && result.steps == std::lround(setting.scene->judged / setting.h))
      result.error = std::sqrt((state.x - *truth).squaredNorm() / scene.cloth.vertices());
  }

  Result result;

 private:
  double energy() const { return energies(scene.cloth, scene.start).total(); }

  Setting setting;
  const std::optional<VecX>& truth;
  TestScene scene;
  std::unique_ptr<WaySimulator> simulator;
};

// Explicit steps of 10 µs: shorter than the longest stable step at k = 1e5 N/m, 60 µs.
std::optional<VecX> true_positions(const StudyScene& study_scene, double k) {
  if (study_scene.judged == 0) return {};
  TestScene scene = study_scene.make(k);
  const auto simulator = make_simulator({1}, scene.cloth);
  const double h = 1e-5;
  for (long i = std::lround(study_scene.judged / h); i > 0; --i) simulator->step(h, scene.start);
  return scene.start.x;
}

Results run(const Study& study, const Setting& setting, const std::optional<VecX>& truth) {
  std::deque<Runner> runners;  // never moves them: their simulators refer to their cloths
  for (const Way way : all_ways) runners.emplace_back(way, setting, truth);
  const long steps = std::max(long(study.fewest()), std::lround(study.seconds() / setting.h));
  for (long i = 0; i < steps; ++i)
    for (Runner& runner : runners) runner.step();
  Results results;
  for (size_t way = 0; way < results.size(); ++way) results[way] = runners[way].result;
  return results;
}

// What follows -----------------------------------------------------------------------------------

const Result& of(const Row& row, Way way) {
  return row.results[size_t(way)];
}

bool gains_more(const Row& row, Way way) {
  const Result &mine = of(row, way), &tension = of(row, Way::tension);
  return mine.exploded || mine.gained > 1.01 * tension.gained + 1e-6;
}

// NaN where a cloth exploded.
double time_ratio(const Row& row, Way way) {
  const Result &mine = of(row, way), &tension = of(row, Way::tension);
  return mine.exploded || tension.exploded ? std::nan("") : mine.time / tension.time;
}

double systems_ratio(const Row& row, Way way) {
  const Result &mine = of(row, way), &tension = of(row, Way::tension);
  return mine.exploded || tension.exploded
             ? std::nan("")
             : double(mine.counts.systems) / double(tension.counts.systems);
}

// Backward Euler is of first order: an error e in the time t becomes e/2 in the time 2t.
double time_at_equal_error(const Row& row, Way way) {
  return time_ratio(row, way) * of(row, way).error / of(row, Way::tension).error;
}

// The tables -------------------------------------------------------------------------------------

std::string number(const char* format, double value) {
  if (std::isnan(value)) return "–";
  char text[40];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

std::string percent(long part, long all) {
  return number("%.0f %%", 100.0 * double(part) / double(all));
}

std::string joules(const Result& result) {
  if (result.exploded) return "explodes";
  return result.gained > 0 ? number("%.1e", result.gained) : "0";
}

void print_runs(const std::vector<Row>& rows) {
  std::printf(
      "| scene | k, N/m | h, s | `--newton` | way | gained, J | systems | iterations | halvings "
      "| redone | unconverged | CG iterations | printed definite | time | time at equal error |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  for (const Row& row : rows)
    for (const Way way : all_ways) {
      const Setting& s = row.setting;
      const Result& r = of(row, way);
      const WayCounts& c = r.counts;
      std::printf(
          "| %s | %.0e | %.4f | %d | `%s` | %s | %ld | %ld | %ld | %ld | %ld | %ld | %s | %s | %s "
          "|\n",
          s.scene->name, s.k, s.h, s.newton, name(way), joules(r).c_str(), c.systems, c.iterations,
          c.halvings, c.redone, c.unconverged, c.cg, percent(r.definite, r.steps).c_str(),
          number("%.2f", time_ratio(row, way)).c_str(),
          number("%.2f", time_at_equal_error(row, way)).c_str());
    }
  std::printf("\n");
}

// The geometric mean over the rows where there is a value, and the largest value.
struct Spread {
  double mean = std::nan(""), least = mean, most = mean;
};
Spread spread(const std::vector<Row>& rows, const auto& value) {
  std::vector<double> logs;
  for (const Row& row : rows)
    if (const double log = std::log(value(row)); std::isfinite(log)) logs.push_back(log);
  if (logs.empty()) return {};
  double sum = 0;
  for (const double log : logs) sum += log;
  const auto [least, most] = std::minmax_element(logs.begin(), logs.end());
  return {std::exp(sum / double(logs.size())), std::exp(*least), std::exp(*most)};
}

std::string text(const Spread& s) {
  return number("%.2f", s.mean) + " (" + number("%.2f", s.least) + " … " + number("%.2f", s.most) +
         ")";
}

std::string text(const std::vector<Row>& rows, Way way, double ratio(const Row&, Way)) {
  return text(spread(rows, [&](const Row& row) { return ratio(row, way); }));
}

std::string gaining(const std::vector<Row>& rows, Way way) {
  const auto gains =
      std::count_if(rows.begin(), rows.end(), [&](const Row& row) { return gains_more(row, way); });
  return std::to_string(gains) + " of " + std::to_string(rows.size());
}

// With --newton 50 the ways have the same error wherever Newton's method converges: the times tell enough.
void print_summary(const std::vector<Row>& all) {
  const auto with = [&](int newton) {
    std::vector<Row> rows;
    for (const Row& row : all)
      if (row.setting.newton == newton) rows.push_back(row);
    return rows;
  };
  const std::vector<Row> plain = with(1), newton = with(50);
  std::printf(
      "| way | plain steps: gain more | systems | time at equal error "
      "| `--newton 50`: gain more | systems | time |\n|---|---|---|---|---|---|---|\n");
  for (const Way way : all_ways)
    std::printf("| `%s` | %s | %s | %s | %s | %s | %s |\n", name(way), gaining(plain, way).c_str(),
                text(plain, way, systems_ratio).c_str(),
                text(plain, way, time_at_equal_error).c_str(), gaining(newton, way).c_str(),
                text(newton, way, systems_ratio).c_str(), text(newton, way, time_ratio).c_str());
}

// ------------------------------------------------------------------------------------------------

std::vector<Row> measure(const Study& study) {
  std::vector<Row> rows;
  const size_t all = scenes.size() * study.all_k().size() * study.all_h().size() * 2;
  Progress progress(long(all), "measuring: ", stderr);
  for (const StudyScene& scene : scenes)
    for (const double k : study.all_k()) {
      const std::optional<VecX> truth = true_positions(scene, k);
      for (const double h : study.all_h())
        for (const int newton : {1, 50}) {
          const Setting setting{&scene, h, k, newton};
          rows.push_back({setting, run(study, setting, truth)});
          progress.show(long(rows.size()));
        }
    }
  progress.end();
  return rows;
}

}  // namespace

int main(int argc, char** argv) {
  Study study;
  CLI::App app("Ways to make the matrix of the implicit step definite");
  app.set_help_flag("--help", "list the options");
  app.add_flag("--quick", study.quick, "fewer and shorter runs");
  app.add_flag("--summary", study.summary, "without the table of all runs");
  CLI11_PARSE(app, argc, argv);
  const std::vector<Row> rows = measure(study);
  if (!study.summary) print_runs(rows);
  print_summary(rows);
}
