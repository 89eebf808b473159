// The cost of every way to resist a change of shape within the plane: ns per triangle of one evaluation of the
// forces (step 1), and of the forces with K and D (step 3), undamped. Medians of CPU times over interleaved
// rounds, and their ratios to [stretch] and [shear].
#include <cstdio>
#include <functional>

#include "bench/step_forces.h"
#include "support/cpu_time.h"
#include "support/membranes.h"
#include "support/poses.h"

namespace {

constexpr int cells = 64, rounds = 21;

// One cloth, and what is measured of it.
struct Way {
  std::string name;
  Cloth cloth;
  std::function<void()> forces, matrices;
  std::vector<double> force_ns, matrix_ns;
};

Model model_of(const std::string& name, const Moduli& moduli) {
  if (!name.starts_with("springs")) return with_membrane(name, moduli);
  SpringTerm springs(moduli.E());
  springs.shear = moduli.mu;
  springs.apart = 0.01 * moduli.E();
  springs.on_grid = name == "springs, grid";
  return Model().add(springs);
}

double ns_per_triangle(const std::function<void()>& work, double triangles) {
  constexpr int evaluations = 8;
  return 1e9 / (evaluations * triangles) * seconds([&] {
           for (int i = 0; i < evaluations; ++i) work();
         });
}

}  // namespace

int main() {
  const Mesh mesh = make_grid({1, 1}, {cells, cells}, Diagonals::alternating);
  const double triangles = double(mesh.faces.size());
  Random random(71);
  const State state{mesh.x + random.vector(int(mesh.x.size()), 0.1 / cells),
                    VecX::Zero(mesh.x.size())};
  std::vector<std::string> names = {"threads", "springs, grid", "springs, mesh"};
  for (const std::string& name : membrane_names()) names.push_back(name);

  std::vector<Way> ways(names.size());
  for (size_t i = 0; i < names.size(); ++i) {
    Way& way = ways[i];
    way.name = names[i];
    way.cloth = make_cloth(mesh, model_of(way.name, moduli_of(1000, way.name == "arap" ? 0 : 0.3)));
    way.forces = forces_of_step_1(way.cloth, state);
    way.matrices = forces_of_step_3(way.cloth, state);
  }
  for (int round = 0; round < rounds; ++round)
    for (Way& way : ways) {
      way.force_ns.push_back(ns_per_triangle(way.forces, triangles));
      way.matrix_ns.push_back(ns_per_triangle(way.matrices, triangles));
    }
  std::printf(
      "| %d × %d cells, ns per triangle | time of the forces | ratio of times "
      "| time with their derivatives (step 3) | ratio of times |\n|---|---|---|---|---|\n",
      cells, cells);
  for (const Way& way : ways)
    std::printf("| %s | %.0f | %.2f | %.0f | %.2f |\n", way.name.c_str(), median(way.force_ns),
                median_ratio(way.force_ns, ways[0].force_ns), median(way.matrix_ns),
                median_ratio(way.matrix_ns, ways[0].matrix_ns));
}
