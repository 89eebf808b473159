// Why multigrid needs more iterations on a finer grid: the error that its V-cycles remove last, with
// bending and without, in Markdown, and its picture.
#include <Eigen/SparseCholesky>
#include <filesystem>

#include "bench_solve.h"
#include "math/direct_solver.h"
#include "math/parents.h"
#include "picture/film.h"
#include "picture/overlay.h"
#include "picture/png.h"
#include "picture/renderer.h"
#include "slow_mode.h"
#include "solve_cases.h"
#include "step05_bend/time_step.h"
#include "text/text.h"

namespace {

using Sparse = Eigen::SparseMatrix<double>;

constexpr int cycles = 1000;

// The next step of a case: its system, its true Δv and its slowest error.
struct Slow {
  explicit Slow(const Setting& setting)
      : c(setting), system(c.cloth, {.guard = false, .preconditioner = "multigrid"}) {
    system.method.max_iterations = 0;  // prepares everything and solves nothing
    take();
    mode = slowest_mode(c.cloth, system.A, *system.preconditioner, cycles);
  }

  void take() {
    State state = c.state;
    step05::time_step(c.cloth, c.setting.h, state, system);
  }

  // The fewest iterations after which Δv is wrong by at most `error`.
  int iterations_to(double error) {
    VecX truth = system.dv;
    make_direct_solver(best_direct(), system.A, c.cloth.inverse_mass)
        ->solve(system.A, system.b, truth);
    system.method.tolerance = 0;
    for (int& n = system.method.max_iterations; n < 1000; ++n) {
      take();
      if ((system.dv - truth).norm() <= error * truth.norm()) break;
    }
    return system.method.max_iterations;
  }

  Case c;
  step05::System system;
  SlowMode mode;
};

// 1/m: the largest angle between the normals at the two ends of a thread, by its length.
double sharpest_fold(const Case& c) {
  const VecX n = normals(c.mesh, c.state.x);
  const int cells = c.setting.cells;
  double least = 1;
  for (int j = 0; j <= cells; ++j)
    for (int i = 0; i < cells; ++i)
      for (const auto& [a, b] :
           {std::pair{c.mesh.grid->vertex(i, j), c.mesh.grid->vertex(i + 1, j)},
            {c.mesh.grid->vertex(j, i), c.mesh.grid->vertex(j, i + 1)}})
        least = std::min(least, n.segment<3>(3 * a).dot(n.segment<3>(3 * b)));
  return std::acos(least) * cells;
}

// Q of the free vertices, from the grid of half as many cells.
Sparse interpolation(const Cloth& cloth) {
  const Parents parents = coarse_parents(*cloth.grid);
  std::vector<Eigen::Triplet<double>> entries;
  int row = 0;
  for (int i = 0; i < cloth.vertices(); ++i) {
    if (cloth.inverse_mass[3 * i] == 0) continue;
    for (int d = 0; d < 3; ++d, ++row)
      for (const auto& [vertex, weight] : parents[size_t(i)])
        entries.emplace_back(row, 3 * vertex + d, weight);
  }
  Sparse Q(row, 3 * cloth.grid->half().vertices());
  Q.setFromTriplets(entries.begin(), entries.end());
  return Q;
}

// min over c of |e − Q c|_A, where |e|_A = 1: what an exact solution on the next grid leaves.
double left_by_coarse_grid(const Cloth& cloth, const BlockMatrix& A_blocks, const VecX& e) {
  FreeMatrix free(A_blocks, cloth.inverse_mass);
  free.copy(A_blocks);
  const Sparse A = free.values.selfadjointView<Eigen::Upper>(), Q = interpolation(cloth);
  Sparse A_c = Q.transpose() * A * Q;
  A_c.diagonal().array() += 1e-14;  // a coarse vertex that has only pinned ones is free of A
  const VecX all = free.restrict(e);
  const VecX rest = all - Q * Eigen::SimplicialLDLT<Sparse>(A_c).solve(Q.transpose() * (A * all));
  return std::sqrt(rest.dot(A * rest));
}

void print(Slow& slow) {
  const Case& c = slow.c;
  const BlockMatrix& A = slow.system.A;
  const VecX& e = slow.mode.e;
  const double alone = stiffness_alone(c.cloth, c.mesh, c.state.x, A, e);
  std::printf("| %d%s | %.0f | %.0f %% | %.1f | %.0f | %.1f %% | %.1f %% | %.1f %% |",
              c.setting.cells, c.setting.bend > 0 ? ", bending" : "", sharpest_fold(c),
              100 * share_along_normals(c.mesh, c.state.x, e), stiffness(c.cloth, A, e), alone,
              100 * energy_norm(A, after_sweep(c.cloth, A, e)),
              100 * left_by_coarse_grid(c.cloth, A, e), 100 * slow.mode.left);
  std::printf(" %d |\n", slow.iterations_to(0.01));
  std::fflush(stdout);
}

// The fold at the left pin: the cloth, with an error that moves no vertex by more than 15 mm, and with what
// more cycles leave of this error.
void draw(const Slow& slow, const std::filesystem::path& file) {
  const Case& c = slow.c;
  const BlockMatrix& A = slow.system.A;
  constexpr int more = 20;
  VecX e = slow.mode.e;
  e *= 0.015 / std::sqrt(e.reshaped(3, c.cloth.vertices()).colwise().squaredNorm().maxCoeff());
  VecX rest = e;
  for (int n = 0; n < more; ++n) rest = after_cycle(c.cloth, A, *slow.system.preconditioner, rest);

  Surface surface{.faces = c.mesh.faces, .texture = c.mesh.rest};
  for (const Pin& pin : c.cloth.pins) surface.pins.push_back(pin.vertex);
  Renderer renderer(surface);
  const Stage stage{
      .eye = {0.5, 0.25, -0.85}, .target = {0.07, -0.06, -0.9}, .ground = -1.1, .size = 0.5};
  const auto tile = [&](const VecX& x, const std::string& title) {
    Image image = renderer.draw(stage, x, {.width = 640, .height = 480});
    draw_text(image, 24, 24, 20, title, {70, 78, 92});
    return image;
  };
  std::filesystem::create_directories(file.parent_path());
  write_png(file,
            film_strip({tile(c.state.x, "the cloth"), tile(c.state.x + e, "with the slowest error"),
                        tile(c.state.x + rest, text("%d V-cycles later", more))},
                       3));
  std::fprintf(stderr, "  see %s\n", file.c_str());
}

}  // namespace

bool bench_mode() {
  std::printf(
      "| cells | sharpest fold (1/m) | along the normal | eᵀAe / eᵀMe | one vertex alone | left by "
      "a "
      "sweep | by the coarse grid | by a V-cycle | iterations |\n"
      "|---|---|---|---|---|---|---|---|---|\n");
  bool grows = true;
  for (const double bend : {0.0, 1e-4}) {
    double before = 0;
    for (const int cells : {32, 64, 128}) {
      Slow slow({.cells = cells, .bend = bend});
      print(slow);
      grows = grows && (bend > 0 || slow.mode.left > before);
      before = slow.mode.left;
      if (cells == 128 && bend == 0) draw(slow, "out/bench_solve/slow_mode.png");
    }
  }
  return require(grows, "what a V-cycle leaves does not grow with the grid");
}
