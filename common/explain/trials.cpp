#include "explain/trials.h"

#include <time.h>

#include <algorithm>
#include <cmath>

#include "math/method.h"
#include "program/diagnostics.h"
#include "text/text.h"

namespace {

// Methods that are always slower than the others: they exist to be compared with.
bool is_slow(const std::string& name) {
  return name == "inverse" || name == "none" || name == "jacobi";
}

// Steps from stop to stop: ten or a multiple, so that h can be ten times as long, and about twenty
// stops. One step if the runs come to few steps.
long stride_of(double steps) {
  return steps < 20 ? 1 : 10 * std::max(1L, std::lround(steps / 200));
}

// The points of a finer grid where the vertices of a coarser one lie, interpolated between its
// vertices.
VecX sampled(const VecX& x, const Grid& fine, const Grid& coarse) {
  VecX at(3 * coarse.vertices());
  for (int j = 0; j <= coarse.cells[1]; ++j)
    for (int i = 0; i <= coarse.cells[0]; ++i) {
      const double u = double(i) * fine.cells[0] / coarse.cells[0];
      const double v = double(j) * fine.cells[1] / coarse.cells[1];
      const int column = std::min(int(u), fine.cells[0] - 1);
      const int row = std::min(int(v), fine.cells[1] - 1);
      const auto corner = [&](int right, int up) {
        return Vec3(x.segment<3>(3 * fine.vertex(column + right, row + up)));
      };
      const double a = u - column, b = v - row;
      const Vec3 below = (1 - a) * corner(0, 0) + a * corner(1, 0);
      const Vec3 above = (1 - a) * corner(0, 1) + a * corner(1, 1);
      at.segment<3>(3 * coarse.vertex(i, j)) = (1 - b) * below + b * above;
    }
  return at;
}

}  // namespace

double seconds_of(const std::function<void()>& work) {
  const auto now = [] {
    timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
  };
  const double start = now();
  work();
  return now() - start;
}

bool Trial::is_late() const {
  return ended.empty() && steps < stride * long(distance_at.size() + 1);
}

void Trial::advance(const TimeBudget& time) {
  if (!is_late()) return;
  bool finite = true;
  seconds += seconds_of([&] {
    for (; finite && is_late() && time.is_left(); ++steps) {
      simulation.step(h, state);
      finite = state.x.allFinite();
    }
  });
  if (!finite || has_exploded(max_stretch(*mesh, state.x)))
    ended = text("explodes by t = %.3g s", double(steps) * h);
}

void Trial::compare_with(const VecX& other) {
  seconds_to_stop = seconds;
  distance_at.push_back(rms_distance(state.x, at_own_vertices ? at_own_vertices(other) : other));
}

Trials::Trials(const Options& options_, const Scene& scene_, const std::vector<Part>& parts_,
               const Simulate& simulate_, const TimeBudget& time_)
    : options(options_), scene(scene_), parts(parts_), simulate(simulate_), time(time_) {
  step_seconds = seconds_of_a_step();
  const double share = std::min(1.0, time.length() / forecast());  // of the scene, in this time
  stride = stride_of(share * double(scene.time.steps()));
}

// The mean of up to ten steps. The first one does not count: a cloth that begins to fall as a whole
// needs few iterations.
double Trials::seconds_of_a_step() const {
  const TimeBudget enough = time.part(0.01);
  const Simulation simulation = simulate(scene.cloth, options.method);
  State state = scene.start;
  simulation.step(scene.time.h, state);
  const double before = time.spent();
  int steps = 0;
  do simulation.step(scene.time.h, state);
  while (++steps < 10 && enough.is_left());
  return (time.spent() - before) / steps;
}

// For a step of the scene the runs with h, h/2 and h/4 and the perturbed one take 1 + 2 + 4 + 1
// steps, the run with a tighter tolerance and each run without a part one. Timings and cheaper runs
// take about a third more.
double Trials::forecast() const {
  const double runs = 8 + double(options.concepts.iterative) + double(parts.size());
  return 4.0 / 3 * runs * double(scene.time.steps()) * step_seconds;
}

Trial Trials::trial(const std::string& name, const Cloth& cloth, const Method& method,
                    double factor_h) const {
  return {.options = name,
          .h = factor_h * scene.time.h,
          .stride = std::lround(double(stride) / factor_h),
          .simulation = simulate(cloth, method),
          .state = scene.start,
          .mesh = &scene.mesh};
}

Trial Trials::perturbed(double by) const {
  Trial run = trial("", scene.cloth, options.method);
  for (int i = 0; i < run.state.x.size(); ++i)
    run.state.x[i] += by * std::sqrt(2.0 / 3) * std::sin(1.0 + 12.9898 * i);
  for (const Pin& pin : scene.cloth.pins)
    run.state.x.segment<3>(3 * pin.vertex) = scene.start.x.segment<3>(3 * pin.vertex);
  return run;
}

NamedMethod Trials::tighter() const {
  NamedMethod tight = {"", options.method};
  tight.method.tolerance /= 10;
  tight.options = options_of(tight.method);
  return tight;
}

// The options in which `method` differs from the command line.
std::string Trials::options_of(const Method& method) const {
  std::string words;
  if (method.solver != options.method.solver) words += " --solver " + method.solver;
  if (method.preconditioner != options.method.preconditioner)
    words += " --preconditioner " + method.preconditioner;
  if (method.tolerance != options.method.tolerance)
    words += " --tolerance " + text("%g", method.tolerance);
  return words.empty() ? words : words.substr(1);
}

std::vector<NamedMethod> Trials::other_methods() const {
  std::vector<NamedMethod> methods;
  Method method = options.method;
  if (options.concepts.direct)
    for (const std::string& solver : solver_names) {
      if (is_slow(solver)) continue;
      method.solver = solver;
      methods.push_back({options_of(method), method});
    }
  if (options.concepts.iterative)
    for (const std::string& preconditioner : preconditioner_names)
      for (const double tolerance : {options.method.tolerance, 1e-2}) {
        if (tolerance < options.method.tolerance || is_slow(preconditioner)) continue;
        method.preconditioner = preconditioner;
        method.tolerance = tolerance;
        methods.push_back({options_of(method), method});
      }
  return methods;
}

// Half the cells and twice h: an eighth of the work. Throws BadInput where the scene refuses
// --cells.
Trial Trials::fewer_cells() const {
  Overrides overrides = options.overrides;
  overrides.cells = scene.cloth.grid->cells[0] / 2;
  overrides.h = 2 * scene.time.h;
  const auto coarse =
      std::make_shared<const Scene>(read_scene(options.scene, options.program, overrides));
  return {.options = text("--cells %d --h %g", *overrides.cells, *overrides.h),
          .h = *overrides.h,
          .stride = stride / 2,
          .simulation = simulate(coarse->cloth, options.method),
          .state = coarse->start,
          .mesh = &coarse->mesh,
          .at_own_vertices = [coarse, fine = *scene.cloth.grid](const VecX& x) {
            return sampled(x, fine, *coarse->cloth.grid);
          }};
}

std::vector<std::function<Trial()>> Trials::cheaper() const {
  std::vector<std::function<Trial()>> list;
  if (!options.concepts.implicit && scene.cloth.grid && scene.cloth.grid->cells[0] >= 4 &&
      stride % 2 == 0)
    list.push_back([this] { return fewer_cells(); });
  if (options.concepts.implicit)
    for (const int factor : {10, 5})  // the cheapest first
      for (const NamedMethod& other : other_methods())
        if (stride % factor == 0)
          list.push_back([=, this] {
            return trial("--h " + text("%g", factor * scene.time.h) +
                             (other.options.empty() ? "" : " " + other.options),
                         scene.cloth, other.method, factor);
          });
  return list;
}
