#include "solve_cases.h"

#include <cstdio>
#include <filesystem>
#include <fstream>

#include "step05_bend/time_step.h"

namespace {

Model model_of(const Setting& s) {
  Model model;
  model.add(StretchTerm(s.k, s.kd_stretch));
  model.add(ShearTerm(s.k_shear, s.kd_shear));
  if (s.bend > 0) model.add(DihedralBend(s.bend, 1e-3 * s.bend));
  model.gravity = Vec3(0, -9.81, 0);
  model.pins = {s.cells * (s.cells + 1), s.cells * (s.cells + 2)};
  return model;
}

std::filesystem::path file_of(const Setting& s) {
  char name[120];
  std::snprintf(name, sizeof name, "state_%d_%s_k%g_kd%g_b%g_h%.4f_%dx%d.bin", s.cells,
                s.diagonals == Diagonals::same ? "same" : "alternating", s.k, s.kd_stretch, s.bend,
                s.h, s.steps, s.parts);
  return std::filesystem::path(STATE_DIRECTORY) / name;
}

bool load(const std::filesystem::path& path, const std::vector<VecX*>& vectors) {
  std::ifstream file(path, std::ios::binary);
  for (VecX* v : vectors)
    file.read(reinterpret_cast<char*>(v->data()), v->size() * std::streamsize(sizeof(double)));
  return bool(file);
}

void save(const std::filesystem::path& path, const std::vector<VecX*>& vectors) {
  std::ofstream file(path.string() + ".part", std::ios::binary);
  for (VecX* v : vectors)
    file.write(reinterpret_cast<char*>(v->data()), v->size() * std::streamsize(sizeof(double)));
  file.close();
  std::filesystem::rename(path.string() + ".part", path);
}

}  // namespace

const std::string& best_direct() {
  static const std::string name = [] {
    try {
      make_direct_solver("cholmod", make_block_matrix(1, {}), VecX::Ones(3));
      return "cholmod";
    } catch (const std::invalid_argument&) {
      return "ldlt";
    }
  }();
  return name;
}

Case::Case(const Setting& s)
    : setting(s), mesh(make_grid({1, 1}, {s.cells, s.cells}, s.diagonals)),
      cloth(make_cloth(mesh, model_of(s))), state{mesh.x, VecX::Zero(mesh.x.size())},
      last_dv(state.v) {
  const std::vector<VecX*> kept = {&state.x, &state.v, &last_dv};
  if (load(file_of(s), kept)) return;
  state = {mesh.x, VecX::Zero(mesh.x.size())};
  std::fprintf(stderr, "  (once: %d x %d cells swing for %d steps)\n", s.cells, s.cells, s.steps);
  step05::System system(cloth, {.guard = false, .preconditioner = "multigrid", .tolerance = 1e-6});
  for (int n = 0; n < s.steps; ++n) {
    last_dv = -state.v;
    for (int i = 0; i < s.parts; ++i) step05::time_step(cloth, s.h / s.parts, state, system);
    last_dv += state.v;
  }
  save(file_of(s), kept);
}

// A step without iterations prepares everything and solves nothing.
Problem::Problem(const Case& c, const std::string& preconditioner)
    : system(c.cloth, {.guard = false, .preconditioner = preconditioner, .max_iterations = 0}) {
  State state = c.state;
  step04::time_step(c.cloth, c.setting.h, state, system);
}

VecX true_dv(const Case& c, const step04::System& system) {
  VecX dv = system.dv;
  make_direct_solver(best_direct(), system.A, c.cloth.inverse_mass)->solve(system.A, system.b, dv);
  return dv;
}

std::vector<Look> watch(const Case& c, step04::System& system, VecX dv, const VecX& truth,
                        const Look& enough) {
  VecX &r = system.r, &p = system.c, &q = system.q, &s = system.s;
  system.A.multiply(dv, q);
  r = system.b - q;
  step04::filter(c.cloth, r);
  p.setZero();
  std::vector<Look> looks;
  for (double delta_before = 1; looks.size() < 40000;) {
    system.preconditioner->apply(r, s);
    step04::filter(c.cloth, s);
    const double delta = r.dot(s);
    looks.push_back(
        {std::sqrt(delta / dv.cwiseAbs2().dot(c.cloth.mass)), (dv - truth).norm() / truth.norm()});
    if (looks.back().left <= enough.left && looks.back().error <= enough.error) break;
    p = s + delta / delta_before * p;
    system.A.multiply(p, q);
    step04::filter(c.cloth, q);
    const double alpha = delta / p.dot(q);
    dv += alpha * p;
    r -= alpha * q;
    delta_before = delta;
  }
  return looks;
}

double loosest(const std::vector<Look>& looks, double error) {
  for (int decade = 0;; --decade)
    for (const double digit : {1.0, 0.3}) {
      const double tolerance = digit * std::pow(10.0, decade);
      if (decade < -13 || looks[iterations(looks, tolerance)].error <= error) return tolerance;
    }
}
