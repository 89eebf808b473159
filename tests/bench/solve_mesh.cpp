// Multigrid by aggregates: a whole step with bending on meshes that are no grids, at equal error in
// Δv, beside an equal grid, whose coarser levels are grids. The cloth is that of solve_bend.cpp.
#include "bench_solve.h"
#include "math/direct_solver.h"
#include "scene/make_cloth.h"
#include "step05_bend/time_step.h"
#include "support/cpu_time.h"
#include "support/irregular.h"

namespace {

constexpr double h = 0.01, error_allowed = 0.01;

int farthest(const Mesh& mesh, const Vec3& direction) {
  const VecX along = mesh.x.reshaped(3, mesh.vertices()).transpose() * direction;
  int vertex;
  along.maxCoeff(&vertex);
  return vertex;
}

struct Swinging {
  Swinging(const char* name_, const Mesh& mesh, double k_, double bend)
      : name(name_), k(k_), triangles(mesh.faces.size()) {
    Model model;
    model.density = 0.2;
    model.add(StretchTerm(k, 1e-3 * k));
    model.add(ShearTerm(0.1 * k, 1e-4 * k));
    if (bend > 0) model.add(DihedralBend(bend, 1e-3 * bend));
    model.gravity = Vec3(0, -9.81, 0);
    model.pins = {farthest(mesh, Vec3(-1, 0, -1)), farthest(mesh, Vec3(1, 0, -1))};
    cloth = make_cloth(mesh, model);
    state = {mesh.x, VecX::Zero(mesh.x.size())};
    constexpr int parts = 4;  // per step: whole steps tear the finest grids
    step05::System system(cloth,
                          {.guard = false, .preconditioner = "multigrid", .tolerance = 1e-4});
    for (int n = 0; n < 20 * parts; ++n) step05::time_step(cloth, h / parts, state, system);
  }

  VecX true_dv() {
    step05::System system(cloth, {.guard = false, .max_iterations = 0});
    State end = state;
    step05::time_step(cloth, h, end, system);
    VecX dv = system.dv;
    make_direct_solver("ldlt", system.A, cloth.inverse_mass)->solve(system.A, system.b, dv);
    return dv;
  }

  const char* name;
  double k;
  size_t triangles;
  Cloth cloth;
  State state;
};

// A step from the state of `c` with the loosest tolerance 0.8ⁿ that keeps Δv within the allowed error.
struct Step {
  Step(Swinging& c, const char* preconditioner, const VecX& truth) {
    for (double tolerance = 0.5; !(error <= error_allowed) && tolerance > 1e-9; tolerance *= 0.8) {
      auto system = std::make_shared<step05::System>(
          c.cloth,
          Method{.guard = false, .preconditioner = preconditioner, .tolerance = tolerance});
      take = [&c, system] {
        State end = c.state;
        step05::time_step(c.cloth, h, end, *system);
      };
      take();
      iterations = system->counts.iterations;
      error = (system->dv - truth).norm() / truth.norm();
    }
  }
  std::function<void()> take;
  long iterations = 0;
  double error = 1e300;
  std::vector<double> spent = {};
};

// Is every error as small as it should be?
bool compare(Swinging c) {
  const VecX truth = c.true_dv();
  std::vector<Step> steps;
  for (const char* name : {"multigrid", "ic", "block"}) steps.emplace_back(c, name, truth);
  for (int round = 0; round < 7; ++round)
    for (Step& step : steps) step.spent.push_back(seconds(step.take));
  std::printf("%-22s  %6.0e  %9zu", c.name, c.k, c.triangles);
  for (const Step& step : steps)
    std::printf("  %5ld %7.1f ms", step.iterations, 1e3 * median(step.spent));
  std::printf("  %8.2f\n", median_ratio(steps[2].spent, steps[0].spent));
  return std::ranges::all_of(steps, [](const Step& s) { return s.error <= error_allowed; });
}

}  // namespace

bool bench_mesh() {
  std::printf(
      "\nA whole step on a mesh, error in dv at most %g\n"
      "mesh                     k N/m  triangles         multigrid                ic             "
      "block  block / multigrid\n",
      error_allowed);
  const Mesh disc = random_disc(60, 7), even = make_grid({1, 1}, {104, 104}, Diagonals::same),
             odd = make_grid({1, 1}, {105, 105}, Diagonals::same);
  bool reached = true;
  for (const double k : {1e3, 1e4}) {
    reached &= compare({"disc", disc, k, 1e-4});
    reached &= compare({"104 x 104 cells", even, k, 1e-4});
    reached &= compare({"105 x 105 cells", odd, k, 1e-4});
  }
  reached &= compare({"disc without bending", disc, 1e4, 0});
  return require(reached, "the error in dv of every way");
}
