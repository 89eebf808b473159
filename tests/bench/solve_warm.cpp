// The savings of a warm start, from the last step's Δv instead of z, at equal error.
// Most runs take steps as the program does. One run takes its steps in parts; there Δv
// changes more from step to step.
#include "bench_solve.h"
#include "solve_cases.h"

namespace {

void compare(const char* name, const Case& c, const std::string& preconditioner) {
  Problem problem(c, preconditioner);
  const VecX truth = true_dv(c, problem.system);
  const Look enough{1e-6, 1e-4};
  const auto cold = watch(c, problem.system, problem.system.dv, truth, enough);
  const auto warm = watch(c, problem.system, c.last_dv, truth, enough);
  std::printf("%-19s  %-9s", name, preconditioner.c_str());
  for (const double error : {1e-1, 1e-2, 1e-3, 1e-4})
    std::printf("  %5zu %5zu", iterations_to(cold, error), iterations_to(warm, error));
  for (const double tolerance : {1e-1, 1e-2, 1e-3, 1e-4}) {
    const size_t a = iterations(cold, tolerance), b = iterations(warm, tolerance);
    std::printf("  %5zu %5zu %7.0e %7.0e", a, b, cold[a].error, warm[b].error);
  }
  std::printf("\n");
}

}  // namespace

bool bench_warm() {
  const auto soft = [](int steps) {
    return Setting{40, Diagonals::alternating, 1e3, 500, 0.02, 0.01, 0.01, steps, 1};
  };
  const std::vector<std::pair<const char*, Setting>> settings = {
      {"default, t = 0.2 s", soft(20)},
      {"default, t = 0.4 s", soft(40)},
      {"default, t = 0.8 s", soft(80)},
      {"k = 1e4, 64 cells", Setting{.cells = 64, .parts = 1}},
      {"the same, 8 parts", Setting{.cells = 64}},
      {"k = 1e6, h = 1/30 s", Setting{64, Diagonals::same, 1e6, 1e5, 1e3, 1e2, 1.0 / 30, 10, 1}}};
  std::printf(
      "\nIterations from dv = z (cold) and from the last step's dv (warm)\n"
      "                                  to an error in dv of                                    "
      "to a tolerance of, and the error there\n"
      "                                     1e-1         1e-2         1e-3         1e-4        "
      "1e-1                       1e-2                       1e-3                       1e-4\n"
      "case                 precond.    cold  warm   cold  warm   cold  warm   cold  warm"
      "%s\n",
      "   cold  warm    cold    warm   cold  warm    cold    warm   cold  warm    cold    warm"
      "   cold  warm    cold    warm");
  for (const auto& [name, setting] : settings) {
    const Case c(setting);
    for (const char* preconditioner : {"block", "ic", "multigrid"})
      compare(name, c, preconditioner);
  }
  return true;
}
