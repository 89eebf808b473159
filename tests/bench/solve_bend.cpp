// The cost of bending: assembly per hinge, a whole step against the usual way at equal error in
// Δv, and its growth with the number of vertices. The cloth is that of the other parts, with a
// bending stiffness of 1e-4 N·m.
#include <Eigen/IterativeLinearSolvers>

#include "bench_solve.h"
#include "math/direct_solver.h"
#include "scene/make_cloth.h"
#include "solve_cases.h"
#include "step04_cg/time_step.h"
#include "step05_bend/time_step.h"
#include "support/cpu_time.h"
#include "usual_way.h"

namespace {

constexpr double h = 0.01, error_allowed = 0.01;

struct Folding {
  explicit Folding(int cells_, bool bends = true)
      : cells(cells_), mesh(make_grid({1, 1}, {cells, cells}, Diagonals::same)) {
    Model model;
    model.add(StretchTerm(1e4, 10));
    model.add(ShearTerm(1e3, 1));
    if (bends) model.add(DihedralBend(1e-4, 1e-7));
    model.gravity = Vec3(0, -9.81, 0);
    model.pins = {mesh.grid->vertex(0, cells), mesh.grid->vertex(cells, cells)};
    cloth = make_cloth(mesh, model);
    state = {mesh.x, VecX::Zero(mesh.x.size())};
    if (!bends) return;
    constexpr int parts = 4;  // per step: whole steps tear the finest grids
    step05::System system(cloth,
                          {.guard = false, .preconditioner = "multigrid", .tolerance = 1e-4});
    for (int n = 0; n < 20 * parts; ++n) step05::time_step(cloth, h / parts, state, system);
  }

  int cells;
  Mesh mesh;
  Cloth cloth;
  State state;
};

// A step from `state` with the loosest tolerance of 0.3, 0.1, 0.03 … that keeps Δv
// within the allowed error.
struct Step {
  std::string name;
  double tolerance = 1;
  long iterations = 0;
  double error = 0;
  std::function<void()> take = {};
  std::vector<double> seconds = {};
};

Step ours(Folding& c, const std::string& preconditioner, const VecX& truth) {
  Step step{.name = "step 5, " + preconditioner};
  for (bool three = true; step.error == 0 || step.error > error_allowed; three = !three) {
    step.tolerance *= three ? 0.3 : 1 / 3.0;
    auto system = std::make_shared<step05::System>(
        c.cloth,
        Method{.guard = false, .preconditioner = preconditioner, .tolerance = step.tolerance});
    step.take = [&c, system] {
      State state = c.state;
      step05::time_step(c.cloth, h, state, *system);
    };
    step.take();
    step.iterations = system->counts.iterations;
    step.error = (system->dv - truth).norm() / truth.norm();
  }
  return step;
}

Step direct(Folding& c, const std::string& solver) {
  auto system =
      std::make_shared<step05::System>(c.cloth, Method{.guard = false, .max_iterations = 0});
  std::shared_ptr<DirectSolver> factors =
      make_direct_solver(solver, system->A, c.cloth.inverse_mass);
  return {.name = "direct, " + solver, .tolerance = 0, .take = [&c, system, factors] {
            State state = c.state;
            step05::time_step(c.cloth, h, state, *system);
            factors->solve(system->A, system->b, system->dv);
          }};
}

Step usual(Folding& c, const VecX& truth) {
  Step step{.name = "triplets, Eigen's CG"};
  auto way = std::make_shared<FromTriplets>(c.cloth, h);
  auto dv = std::make_shared<VecX>();
  auto count = std::make_shared<long>();
  for (bool three = true; step.error == 0 || step.error > error_allowed; three = !three) {
    step.tolerance *= three ? 0.3 : 1 / 3.0;
    step.take = [&c, way, dv, count, tolerance = step.tolerance] {
      way->assemble(c.state);
      VecX b = h * (way->f + h * (way->K * c.state.v));
      way->hold_pins(b);
      Eigen::ConjugateGradient<Sparse> cg;
      cg.setTolerance(tolerance);
      cg.compute(way->A);
      *dv = cg.solve(b);
      *count = cg.iterations();
    };
    step.take();
    step.iterations = *count;
    step.error = (*dv - truth).norm() / truth.norm();
  }
  return step;
}

VecX true_dv(Folding& c) {
  step05::System system(c.cloth, {.guard = false, .max_iterations = 0});
  State state = c.state;
  step05::time_step(c.cloth, h, state, system);
  VecX dv = system.dv;
  make_direct_solver(best_direct(), system.A, c.cloth.inverse_mass)->solve(system.A, system.b, dv);
  return dv;
}

void measure(std::vector<Step>& steps, int rounds) {
  for (int round = 0; round < rounds; ++round)
    for (Step& step : steps) step.seconds.push_back(seconds(step.take));
}

void print(const Folding& c, const std::vector<Step>& steps) {
  std::printf(
      "\nA whole step with bending at %d x %d cells, error in dv at most %g\n"
      "way                     tolerance  iterations  error in dv       ms  time / multigrid\n",
      c.cells, c.cells, error_allowed);
  for (const Step& step : steps)
    std::printf("%-22s  %9.0e  %10ld  %11.1e  %7.1f  %16.2f\n", step.name.c_str(), step.tolerance,
                step.iterations, step.error, 1e3 * median(step.seconds),
                median_ratio(step.seconds, steps[0].seconds));
}

// The time to assemble f, K and D with hinges and without.
void assembly(int cells) {
  Folding with(cells), without(cells, false);
  without.state = with.state;
  step05::System system(with.cloth), system_without(without.cloth);
  std::vector<double> spent[2];
  for (int round = 0; round < 9; ++round) {
    spent[0].push_back(seconds([&] { step05::forces(with.cloth, with.state, system); }));
    spent[1].push_back(
        seconds([&] { step05::forces(without.cloth, without.state, system_without); }));
  }
  const double hinges = double(with.cloth.hinges.elements.size());
  std::printf(
      "\nAssembly of f, K and D at %d x %d cells: %.0f ns per hinge, %.0f ns per triangle\n", cells,
      cells, 1e9 * (median(spent[0]) - median(spent[1])) / hinges,
      1e9 * median(spent[1]) / double(with.mesh.faces.size()));
}

// Compares step 5 with step 4 on a scene without bending.
void absent(int cells) {
  Folding c(cells, false);
  step04::System four(c.cloth, {.guard = false, .preconditioner = "multigrid"});
  step05::System five(c.cloth, {.guard = false, .preconditioner = "multigrid"});
  State a = c.state, b = c.state;
  std::vector<double> t4, t5;
  for (int n = 0; n < 20; ++n) {
    t4.push_back(seconds([&] { step04::time_step(c.cloth, h, a, four); }));
    t5.push_back(seconds([&] { step05::time_step(c.cloth, h, b, five); }));
  }
  std::printf("\nWithout bending, at %d x %d cells: step 5 takes %.3f of the time of step 4\n",
              cells, cells, median_ratio(t5, t4));
}

}  // namespace

bool bench_bend() {
  assembly(96);
  absent(96);
  bool reached = true;
  double least = 1e300, most = 0;
  std::vector<std::pair<double, double>> growth[2];
  for (const int cells : {32, 64, 96, 128, 256}) {
    std::fprintf(stderr, "  (%d x %d cells swing for 20 steps)\n", cells, cells);
    Folding c(cells);
    const VecX truth = true_dv(c);
    std::vector<Step> steps = {ours(c, "multigrid", truth), ours(c, "block", truth)};
    if (cells == 96)
      steps.insert(steps.end(), {ours(c, "ic", truth), usual(c, truth), direct(c, "ldlt"),
                                 direct(c, best_direct())});
    measure(steps, cells > 128 ? 3 : 5);
    print(c, steps);
    for (int way : {0, 1})
      growth[way].push_back({c.cloth.vertices(), median(steps[size_t(way)].seconds)});
    for (const Step& step : steps) reached = reached && step.error <= error_allowed;
    least = std::min(least, double(steps[0].iterations));
    most = std::max(most, double(steps[0].iterations));
  }
  for (int way : {0, 1}) {
    const auto [N0, t0] = growth[way].front();
    const auto [N1, t1] = growth[way].back();
    std::printf("%s: time ~ N^%.2f from 32 to 256 cells\n", way ? "block" : "multigrid",
                std::log(t1 / t0) / std::log(N1 / N0));
  }
  std::printf("As it should be: multigrid's iterations within a factor of 2\n");
  return require(reached, "the error in dv of every way") &&
         require(most <= 2 * least, "multigrid's iterations grow");
}
