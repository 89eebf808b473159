// What a tolerance of conjugate gradients is worth. For 1e-1 … 1e-10: the residual, the error in Δv
// compared with a direct solve of the same system, iterations, time, and the error in position at the end
// compared with the run of direct solves.
//
// All tolerances solve the systems of one trajectory, that of the direct solves, so that they can be
// compared. Besides, each tolerance has its own run, where the errors of one step go into the next. Every step
// is one linear system: the guard is off.
//
// --table stiffness prints instead how many times the tolerance the error is, by k and preconditioner.
#include <CLI/CLI.hpp>
#include <iostream>

#include "math/direct_solver.h"
#include "scene/scene.h"
#include "step03_implicit/time_step.h"
#include "step04_cg/time_step.h"
#include "support/cpu_time.h"
#include "support/gnuplot.h"

namespace {

struct Arguments {
  std::filesystem::path scene = SOURCE_DIRECTORY "/step04_cg/scene.toml";
  std::filesystem::path out = "out/measure_tolerance";
  std::string preconditioner = "block";
  std::optional<double> k;
  std::string table;
  Overrides overrides;
};

// The measurements of one tolerance. Residual, error and iterations have one entry per step.
struct Measured {
  double tolerance;
  std::vector<double> residual = {}, error = {}, iterations = {}, seconds = {};
  double position = 0, worst_position = 0;
  long capped = 0, indefinite = 0;
};

double worst(const std::vector<double>& values) {
  return *std::max_element(values.begin(), values.end());
}

// Makes the cloth stiffer or softer: stretch gets k, shear and damping change in proportion.
void rescale(Cloth& cloth, double k) {
  if (!cloth.term<StretchTerm>()) throw BadInput("--k: the scene has no [stretch]");
  const double factor = k / cloth.term<StretchTerm>()->k;
  cloth.triangles.for_each_term([&](auto& term) {
    if (term) term->k *= factor, term->kd *= factor;
  });
}

Scene read(const Arguments& arguments) {
  Scene scene = read_scene(arguments.scene, "step04_cg", arguments.overrides);
  for (const Pin& pin : scene.cloth.pins)
    if (!pin.holds_all() || pin.moves())
      throw BadInput("measure_tolerance: the direct solvers take pins that hold all and rest");
  if (arguments.k) rescale(scene.cloth, *arguments.k);
  return scene;
}

// The run of direct solves. In every step each tolerance solves the same system.
class Trajectory {
 public:
  Trajectory(const Scene& scene_, const std::string& preconditioner)
      : scene(scene_), cloth(scene.cloth), system(cloth, {.preconditioner = preconditioner}),
        direct(make_direct_solver("ldlt", system.A, cloth.inverse_mass)), state(scene.start),
        dv(system.dv), r(system.r) {}

  void step(std::vector<Measured>& measured) {
    const double h = scene.time.h;
    const double assembly = seconds([&] {
      step04::forces(cloth, state, system);
      system.K.multiply(state.v, system.b);
      system.b = h * (system.f + h * system.b);
      system.A.set_diagonal(cloth.mass);
      system.A.add(-h, system.D);
      system.A.add(-h * h, system.K);
      system.preconditioner->set(system.A);
    });
    direct->solve(system.A, system.b, dv);
    for (Measured& m : measured) solve(assembly, m);
    state.v += dv;
    state.x += h * state.v;
  }

  const State& now() const { return state; }

 private:
  double residual() {
    system.A.multiply(system.dv, system.q);
    r = system.b - system.q;
    step04::filter(cloth, r);
    return r.norm();
  }

  void solve(double assembly, Measured& m) {
    const long before = system.counts.iterations;
    system.method.tolerance = m.tolerance;
    step04::prescribe(cloth, state.v, system.dv);
    const double first = residual();
    const double solving = seconds([&] { step04::conjugate_gradients(cloth, system); });
    m.seconds.push_back(assembly + solving);
    m.iterations.push_back(double(system.counts.iterations - before));
    m.residual.push_back(residual() / first);
    m.error.push_back((system.dv - dv).norm() / dv.norm());
  }

  const Scene& scene;
  const Cloth& cloth;
  step04::System system;
  std::unique_ptr<DirectSolver> direct;
  State state;
  VecX dv, r;
};

// The own run of one tolerance.
struct OwnRun {
  OwnRun(const Scene& scene, const std::string& preconditioner, double tolerance)
      : system(scene.cloth,
               {.guard = false, .preconditioner = preconditioner, .tolerance = tolerance}),
        state(scene.start) {}
  step04::System system;
  State state;
};

// Root mean square of the distances between vertices, relative to the longer side of the cloth.
double distance(const Scene& scene, const State& a, const State& b) {
  const auto points = scene.start.x.reshaped(3, scene.cloth.vertices());
  const double size = (points.rowwise().maxCoeff() - points.rowwise().minCoeff()).maxCoeff();
  return (a.x - b.x).norm() / std::sqrt(scene.cloth.vertices()) / size;
}

// How well the end of a run is determined: direct solves again, from vertices moved by up to 1 nm.
class Moved {
 public:
  explicit Moved(const Scene& scene_)
      : scene(scene_), system(scene.cloth, {.guard = false}), state(scene.start) {
    for (int i = 0; i < state.x.size(); ++i)
      if (scene.cloth.inverse_mass[i] > 0) state.x[i] += 1e-9 * std::sin(12.9898 * i);
  }
  void step() { step03::time_step(scene.cloth, scene.time.h, state, system); }
  const State& now() const { return state; }

 private:
  const Scene& scene;
  step03::System system;
  State state;
};

struct Result {
  std::vector<Measured> measured;
  double moved = 0, worst_moved = 0;  // error in position of the run that began elsewhere
};

Result measure(const Scene& scene, const std::string& preconditioner) {
  Result result;
  std::vector<Measured>& measured = result.measured;
  std::vector<OwnRun> runs;
  for (int decade = 1; decade <= 10; ++decade) {
    measured.push_back({std::pow(10.0, -decade)});
    runs.emplace_back(scene, preconditioner, measured.back().tolerance);
  }
  Trajectory trajectory(scene, preconditioner);
  Moved moved(scene);
  for (long n = 0; n < scene.time.steps(); ++n) {
    trajectory.step(measured);
    moved.step();
    result.moved = distance(scene, moved.now(), trajectory.now());
    result.worst_moved = std::max(result.worst_moved, result.moved);
    for (size_t i = 0; i < runs.size(); ++i) {
      Measured& m = measured[i];
      step04::time_step(scene.cloth, scene.time.h, runs[i].state, runs[i].system);
      m.position = distance(scene, runs[i].state, trajectory.now());
      m.worst_position = std::max(m.worst_position, m.position);
    }
  }
  for (size_t i = 0; i < runs.size(); ++i) {
    measured[i].capped = runs[i].system.counts.capped;
    measured[i].indefinite = runs[i].system.counts.indefinite;
  }
  return result;
}

void print(const Scene& scene, const Result& result) {
  const std::vector<Measured>& measured = result.measured;
  std::printf(
      "\n           relative residual     error in dv           iterations         ms   error in "
      "position\n"
      "tolerance  median    worst       median    worst       median  worst   a step   at %g s   "
      "worst\n",
      scene.time.end);
  for (const Measured& m : measured) {
    std::printf("%9.0e  %-8.1e  %-8.1e    %-8.1e  %-8.1e    %6.0f %6.0f  %7.1f   %-8.1e  %-8.1e",
                m.tolerance, median(m.residual), worst(m.residual), median(m.error), worst(m.error),
                median(m.iterations), worst(m.iterations), 1e3 * median(m.seconds), m.position,
                m.worst_position);
    if (m.capped) std::printf("  %ld steps capped", m.capped);
    if (m.indefinite) std::printf("  %ld steps broke off", m.indefinite);
    std::printf("\n");
  }
  std::printf("direct solves, begun up to 1e-9 m elsewhere %35s %8.1e  %8.1e\n", "", result.moved,
              result.worst_moved);
  const double enough = 1e-3;
  const auto good = [&](const Measured& m) { return worst(m.error) < enough; };
  const auto first = std::find_if(measured.begin(), measured.end(), good);
  if (first == measured.end())
    std::printf("\nNo tolerance keeps the error in dv below %g in every step.\n", enough);
  else
    std::printf("\nThe loosest tolerance that keeps the error in dv below %g in every step: %.0e\n",
                enough, first->tolerance);
}

void write_csv(const std::filesystem::path& file, const std::vector<Measured>& measured) {
  std::ofstream csv(file);
  csv << "tolerance,residual_median,residual_worst,error_median,error_worst,iterations_median,"
         "iterations_worst,milliseconds,position_end,position_worst\n";
  for (const Measured& m : measured)
    csv << m.tolerance << ',' << median(m.residual) << ',' << worst(m.residual) << ','
        << median(m.error) << ',' << worst(m.error) << ',' << median(m.iterations) << ','
        << worst(m.iterations) << ',' << 1e3 * median(m.seconds) << ',' << m.position << ','
        << m.worst_position << '\n';
}

std::string script(const Arguments& arguments, const std::string& name, double moved) {
  const std::string title =
      "What a tolerance is worth (--preconditioner " + arguments.preconditioner +
      (arguments.k ? ", k = " + CLI::detail::to_string(*arguments.k) + " N/m" : std::string()) +
      ")";
  return gnuplot_style + "set terminal pngcairo size 900,540 font \"sans,13\"\nset output \"" +
         name + ".png\"\nset title \"" + title + R"("
set logscale xy
set xlabel "tolerance of conjugate gradients"
set ylabel "relative error"
set xrange [0.3:3e-11]
set yrange [1e-14:3]
set key bottom left reverse Left
set style fill transparent solid 0.15 noborder
plot ")" +
         name +
         R"(.csv" using 1:4:5 skip 1 with filledcurves lc rgb "#D55E00" notitle, \
     "" using 1:5 skip 1 with linespoints lt 2 title "error in Δv, worst step", \
     "" using 1:4 skip 1 with linespoints lt 6 title "error in Δv, median step", \
     "" using 1:10 skip 1 with linespoints lt 1 title "error in position / size of the cloth", \
     x with lines lt 5 dt 2 title "error = tolerance", \
     )" + CLI::detail::to_string(moved) +
         R"( with lines lt 7 dt 4 title "error in position after moving the start by 1 nm"
)";
}

// Steps along one trajectory, whose systems are solved with each tolerance.
std::vector<Measured> measure_errors(const Scene& scene, const std::string& preconditioner,
                                     const std::vector<double>& tolerances) {
  std::vector<Measured> measured;
  for (const double tolerance : tolerances) measured.push_back({tolerance});
  Trajectory trajectory(scene, preconditioner);
  for (long n = 0; n < scene.time.steps(); ++n) trajectory.step(measured);
  return measured;
}

// In Markdown: how many times the tolerance the error in dv is.
void print_errors_by_stiffness(Arguments arguments) {
  const std::vector<std::string> names = {"block", "ic", "multigrid"};
  const std::vector<double> tolerances = {1e-2, 1e-4};
  const char* const tolerance_names[] = {"10⁻²", "10⁻⁴"};
  std::printf("| k (N/m) | tolerance |");
  for (const std::string& name : names) std::printf(" `%s`, median | worst |", name.c_str());
  std::printf("\n|---|---|---|---|---|---|---|---|\n");
  for (const auto& [k, k_name] :
       {std::pair{1e2, "10²"}, {1e3, "10³"}, {1e4, "10⁴"}, {1e5, "10⁵"}}) {
    arguments.k = k;
    const Scene scene = read(arguments);
    std::vector<std::vector<Measured>> all;
    for (const std::string& name : names) all.push_back(measure_errors(scene, name, tolerances));
    for (size_t i = 0; i < tolerances.size(); ++i) {
      std::printf("| %s | %s |", k_name, tolerance_names[i]);
      for (const std::vector<Measured>& measured : all)
        std::printf(" %.2g | %.2g |", median(measured[i].error) / tolerances[i],
                    worst(measured[i].error) / tolerances[i]);
      std::printf("\n");
    }
  }
}

void run(const Arguments& arguments) {
  if (!arguments.table.empty()) return print_errors_by_stiffness(arguments);
  const Scene scene = read(arguments);
  std::printf("%s, %d vertices, h = %g s, %ld steps, --preconditioner %s\n",
              arguments.scene.c_str(), scene.cloth.vertices(), scene.time.h, scene.time.steps(),
              arguments.preconditioner.c_str());
  const Result result = measure(scene, arguments.preconditioner);
  print(scene, result);
  std::filesystem::create_directories(arguments.out);
  const std::string name = "tolerance_" + arguments.preconditioner;
  write_csv(arguments.out / (name + ".csv"), result.measured);
  draw(arguments.out, name, script(arguments, name, result.worst_moved));
}

}  // namespace

int main(int argc, char** argv) {
  Arguments arguments;
  CLI::App app("What a tolerance of conjugate gradients is worth");
  app.set_help_flag("--help", "list the options");  // without -h, because of --h
  app.add_option("scene", arguments.scene, "that of step04_cg if absent");
  app.add_option("--out", arguments.out, "where table and picture go");
  app.add_option("--preconditioner", arguments.preconditioner);
  app.add_option("--k", arguments.k, "stiffness of stretch, N/m; shear and damping in proportion")
      ->check(CLI::PositiveNumber);
  app.add_option("--table", arguments.table, "print one table, and draw nothing: stiffness")
      ->check(CLI::IsMember({"stiffness"}));
  app.add_option("--h", arguments.overrides.h, "time step, s")->check(CLI::PositiveNumber);
  app.add_option("--end", arguments.overrides.end, "simulated time, s")->check(CLI::PositiveNumber);
  app.add_option("--cells", arguments.overrides.cells, "of the grid")->check(CLI::PositiveNumber);
  CLI11_PARSE(app, argc, argv);
  try {
    run(arguments);
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 2;
  }
}
