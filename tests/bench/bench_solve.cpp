// The cost of solving: the product with A, a whole implicit step, its growth with the number of
// vertices, the savings of a warm start, bending, meshes that are no grids, and the error that
// multigrid removes last. Every step is one linear system: the guard is off. One thread, CPU time,
// medians of interleaved rounds.
//
// The state is a cloth with equal diagonals in mid-swing: k = 1e4 N/m, k_shear = k/10,
// kd/k = 1e-3 s, h = 0.01 s, 0.2 kg/m², held by two corners, 0.2 s after it was released flat. The
// first run computes and saves this state, so that later runs count the same iterations.
#include "bench_solve.h"

#include <map>
#include <string>

int main(int argc, char** argv) {
  const std::map<std::string, bool (*)()> parts = {
      {"1 product", bench_product}, {"2 step", bench_step}, {"3 growth", bench_growth},
      {"4 warm", bench_warm},       {"5 bend", bench_bend}, {"6 mesh", bench_mesh},
      {"7 mode", bench_mode}};
  const std::string wanted = argc == 2 ? argv[1] : "";
  bool good = true, any = false;
  for (const auto& [name, part] : parts)
    if (argc == 1 || name.substr(2) == wanted) {
      any = true;
      good = part() && good;
    }
  if (!any) std::fprintf(stderr, "usage: bench_solve [product|step|growth|warm|bend|mesh|mode]\n");
  return any ? !good : 2;
}
