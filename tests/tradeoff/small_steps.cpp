#include "tradeoff/small_steps.h"

#include <cstdio>

#include "support/text.h"

namespace tradeoff {

const std::vector<Iterated>& iterated_methods() {
  static const std::vector<Iterated> all = {
      {"Newton",
       [](const Study& study, int n) -> Configuration {
         const int step = first_step_of(study.meshes.front().scene.cloth) == 5 ? 5 : 3;
         return {step, {.newton = n, .tolerance = 1e-8}};
       }},
      {"XPBD", [](const Study&, int n) { return xpbd_of(n); }},
      {"VBD", [](const Study&, int n) { return vbd_of(n); }},
  };
  return all;
}

std::array<double, 3> small_step_errors(const Study& study, size_t mesh, const Iterated& method,
                                        long total) {
  std::array<double, 3> errors;
  for (size_t i = 0; i < errors.size(); ++i) {
    const int n = iterations_per_step[i];
    errors[i] =
        error_of(study.meshes[mesh], study.references[mesh], {method.with(study, n), total / n});
  }
  return errors;
}

void print_small_steps(const Study& study) {
  for (size_t mesh = 0; mesh < study.meshes.size(); ++mesh) {
    std::printf(
        "\nErrors for the same work%s: few steps of 16 or 4 iterations, or as many steps as "
        "iterations\n\n  %10s",
        study.meshes.size() > 1 ? format(", %d cells", cells_of(study.meshes[mesh])).c_str() : "",
        "iterations");
    for (const Iterated& method : iterated_methods())
      for (const int n : iterations_per_step)
        std::printf(" %9s", (method.name + format(" %d", n)).c_str());
    std::printf("\n");
    for (long total = 64; total <= 16384; total *= 4) {
      std::printf("  %10ld", total);
      for (const Iterated& method : iterated_methods())
        for (const double error : small_step_errors(study, mesh, method, total))
          std::printf(" %9s", error == error ? format("%.1e", error).c_str() : "-");
      std::printf("\n");
    }
  }
  std::printf(
      "\n  Newton 16: one step of at most 16 iterations; it ends when it has converged. Newton 1: "
      "the plain step.\n");
}

}  // namespace tradeoff
