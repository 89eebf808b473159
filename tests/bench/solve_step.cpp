// A whole implicit step, from one state to the next, at equal error in Δv: step 4 with each
// preconditioner, the direct solvers of step 3, and the usual way (usual_way.h).
#include <Eigen/IterativeLinearSolvers>

#include "bench_solve.h"
#include "solve_cases.h"
#include "step03_implicit/time_step.h"
#include "support/cpu_time.h"
#include "usual_way.h"

namespace {

constexpr double error_allowed = 0.01;

struct Way {
  std::string name;
  double tolerance;                    // 0 for a direct solver
  std::function<long(VecX& dv)> step;  // returns the iterations
  long iterations = 0;
  double error = 0;
  std::vector<double> seconds = {};
};

Way ours(const Case& c, const std::string& preconditioner, const VecX& truth) {
  Problem problem(c, preconditioner);
  const auto looks = watch(c, problem.system, problem.system.dv, truth, {1, error_allowed / 2});
  const double tolerance = loosest(looks, error_allowed);
  const Method method{.guard = false, .preconditioner = preconditioner, .tolerance = tolerance};
  auto system = std::make_shared<step04::System>(c.cloth, method);
  return {"step 4, " + preconditioner, tolerance, [&c, system](VecX& dv) {
            State state = c.state;
            const long before = system->counts.iterations;
            step04::time_step(c.cloth, c.setting.h, state, *system);
            dv = system->dv;
            return system->counts.iterations - before;
          }};
}

Way direct(const Case& c, const std::string& solver) {
  Method method{.guard = false};
  method.solver = solver;
  auto system = std::make_shared<step03::System>(c.cloth, method);
  return {"step 3, " + solver, 0, [&c, system](VecX& dv) {
            State state = c.state;
            step03::time_step(c.cloth, c.setting.h, state, *system);
            dv = system->dv;
            return 0L;
          }};
}

// Triplets and a new matrix in every step; Eigen's conjugate gradients,
// preconditioned by the diagonal.
long usual_step(const Case& c, FromTriplets& way, double tolerance, VecX& dv) {
  way.assemble(c.state);
  VecX b = way.h * (way.f + way.h * (way.K * c.state.v));
  way.hold_pins(b);
  Eigen::ConjugateGradient<Sparse> cg;
  cg.setTolerance(tolerance);
  cg.compute(way.A);
  dv = cg.solve(b);
  return cg.iterations();
}

Way usual(const Case& c, const VecX& truth) {
  auto way = std::make_shared<FromTriplets>(c.cloth, c.setting.h);
  Way result{"triplets, Eigen's CG", 0.1, {}};
  VecX dv;
  for (int i = 1;; ++i) {
    usual_step(c, *way, result.tolerance, dv);
    if ((dv - truth).norm() <= error_allowed * truth.norm() || result.tolerance < 1e-12) break;
    result.tolerance = std::pow(10.0, -1 - i / 2) * (i % 2 ? 0.3 : 1);
  }
  const double tolerance = result.tolerance;
  result.step = [&c, way, tolerance](VecX& dv_) { return usual_step(c, *way, tolerance, dv_); };
  return result;
}

void measure(std::vector<Way>& ways, const VecX& truth, int rounds) {
  for (int round = 0; round < rounds; ++round)
    for (Way& way : ways) {
      VecX dv;
      way.seconds.push_back(seconds([&] { way.iterations = way.step(dv); }));
      way.error = (dv - truth).norm() / truth.norm();
    }
}

void print(const Case& c, const std::vector<Way>& ways) {
  std::printf(
      "\nA whole implicit step at %d x %d cells, error in dv at most %g\n"
      "way                     tolerance  iterations  error in dv       ms  time / multigrid\n",
      c.setting.cells, c.setting.cells, error_allowed);
  for (const Way& way : ways) {
    char tolerance[20] = "direct";
    if (way.tolerance > 0) std::snprintf(tolerance, sizeof tolerance, "%.0e", way.tolerance);
    std::printf("%-22s  %9s  %10ld  %11.1e  %7.1f  %16.2f\n", way.name.c_str(), tolerance,
                way.iterations, way.error, 1e3 * median(way.seconds),
                median_ratio(way.seconds, ways[0].seconds));
  }
}

void measure_smaller() {
  const Case c({.cells = 80});
  const VecX truth = true_dv(c, Problem(c, "none").system);
  std::vector<Way> ways = {ours(c, "multigrid", truth), ours(c, "block", truth)};
  measure(ways, truth, 5);
  print(c, ways);
}

}  // namespace

bool bench_step() {
  const Case c({.cells = 96});
  const VecX truth = true_dv(c, Problem(c, "none").system);
  std::vector<Way> ways;
  for (const char* name : {"multigrid", "ic", "block", "jacobi", "none"})
    ways.push_back(ours(c, name, truth));
  ways.push_back(usual(c, truth));
  ways.push_back(direct(c, "ldlt"));
  if (best_direct() != "ldlt") ways.push_back(direct(c, best_direct()));
  measure(ways, truth, 7);
  print(c, ways);
  std::printf(
      "As it should be: the usual way at least 10 times multigrid, the direct solvers above 1\n");
  measure_smaller();
  bool reached = true;
  for (const Way& way : ways) reached = reached && way.error <= error_allowed;
  return require(reached, "the error in dv of every way");
}
