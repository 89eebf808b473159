// The cost of assembling f, K, D and A per triangle, in three ways: ours; the notes' way, nine
// 3 × 3 blocks per condition as triplets and setFromTriplets; and the same blocks by coeffRef in a
// matrix that already has its pattern. Then a whole step of the default solver against a step from
// triplets that analyses its matrix anew. Ratios are medians of CPU times over interleaved rounds.
#include <cstdio>
#include <cstdlib>
#include <Eigen/SparseCholesky>

#include "scene/make_cloth.h"
#include "step03_implicit/time_step.h"
#include "support/cpu_time.h"
#include "support/poses.h"
#include "usual_way.h"

namespace {

constexpr double h = 1.0 / 60;

struct Scene {
  explicit Scene(int n) : mesh(make_grid({1, 1}, {n, n}, Diagonals::alternating)) {
    Model model;
    model.add(StretchTerm(1000, 0.02));
    model.add(ShearTerm(500, 0.01));
    model.gravity = Vec3(0, -9.81, 0);
    model.pins = {n * (n + 1), n * (n + 1) + n};
    cloth = make_cloth(mesh, model);
    Random random(121);
    state = {mesh.x + random.vector(int(mesh.x.size()), 0.1 / n),
             random.vector(int(mesh.x.size()), 0.1)};
    for (const Pin& pin : model.pins) state.v.segment<3>(3 * pin.vertex).setZero();
  }
  double triangles() const { return double(mesh.faces.size()); }

  Mesh mesh;
  Cloth cloth;
  State state;
};

struct Ours {
  explicit Ours(const Scene& s) : scene(s), system(s.cloth) {}
  void assemble() {
    step03::forces(scene.cloth, scene.state, system);
    system.A.set_diagonal(scene.cloth.mass);
    system.A.add(-h, system.D);
    system.A.add(-h * h, system.K);
  }
  const Scene& scene;
  step03::System system;
};

struct FromCoeffRef : FromTriplets {
  explicit FromCoeffRef(const Scene& s) : FromTriplets(s.cloth, ::h) {
    FromTriplets::assemble(s.state);
  }
  void assemble(const State& state) {
    K.coeffs().setZero(), D.coeffs().setZero();
    notes_blocks(cloth, state, f, [&](int i, int j, const Mat3& K_ij, const Mat3& D_ij) {
      for (int c = 0; c < 3; ++c)
        for (int r = 0; r < 3; ++r) {
          K.coeffRef(3 * i + r, 3 * j + c) += K_ij(r, c);
          D.coeffRef(3 * i + r, 3 * j + c) += D_ij(r, c);
        }
    });
    A = M - h * D - h * h * K;
  }
};

// A whole step from triplets. It analyses the pattern anew.
VecX step_from_triplets(const Scene& scene, FromTriplets& way) {
  way.assemble(scene.state);
  VecX b = h * (way.f + h * (way.K * scene.state.v));
  way.hold_pins(b);
  Eigen::SimplicialLDLT<Sparse> ldlt(way.A);
  return ldlt.solve(b);
}

// Different results make any comparison of times worthless.
void require_equal(const VecX& a, const VecX& b, const char* what) {
  if ((a - b).norm() <= 1e-9 * b.norm()) return;
  std::fprintf(stderr, "bench_assembly: %s differ by %.1e\n", what, (a - b).norm() / b.norm());
  std::exit(1);
}

void assembly(int n) {
  const Scene scene(n);
  Ours ours(scene);
  FromTriplets triplets(scene.cloth, h);
  FromCoeffRef coeff(scene);
  ours.assemble(), triplets.assemble(scene.state), coeff.assemble(scene.state);
  VecX Ap;
  ours.system.A.multiply(scene.state.v, Ap);
  require_equal(ours.system.f, triplets.f, "forces");
  require_equal(Ap, triplets.A * scene.state.v, "matrices from triplets");
  require_equal(Ap, coeff.A * scene.state.v, "matrices from coeffRef");

  std::vector<double> t, triplet_ratio, coeff_ratio;
  for (int round = 0; round < 11; ++round) {
    t.push_back(seconds([&] {
                  for (int i = 0; i < 4; ++i) ours.assemble();
                }) /
                4);
    triplet_ratio.push_back(seconds([&] { triplets.assemble(scene.state); }) / t.back());
    coeff_ratio.push_back(seconds([&] { coeff.assemble(scene.state); }) / t.back());
  }
  std::printf("%4d  %14.0f  %16.1f  %16.1f\n", n, 1e9 * median(t) / scene.triangles(),
              median(triplet_ratio), median(coeff_ratio));
}

void whole_step(int n) {
  const Scene scene(n);
  step03::System system(scene.cloth, {.guard = false});
  FromTriplets triplets(scene.cloth, h);
  std::vector<double> t, ratio;
  for (int round = 0; round < 7; ++round) {
    State state = scene.state;
    VecX dv;
    t.push_back(seconds([&] { step03::time_step(scene.cloth, h, state, system); }));
    ratio.push_back(seconds([&] { dv = step_from_triplets(scene, triplets); }) / t.back());
    require_equal(system.dv, dv, "steps");
  }
  std::printf("%4d  %14.1f  %16.1f\n", n, 1e3 * median(t), median(ratio));

  const auto bytes = [](const BlockMatrix& A) {
    return double(sizeof(Mat3) * (A.diagonal.size() + A.upper.size()) +
                  sizeof(int) * (A.row_start.size() + A.column.size()));
  };
  const auto sparse_bytes = [](const Sparse& A) {
    return double(A.nonZeros()) * (sizeof(double) + sizeof(int)) +
           double(A.outerSize() + 1) * sizeof(int);
  };
  const double vertices = scene.cloth.vertices();
  std::printf(
      "\nBytes per vertex: one of K, D, A %.0f, of a full sparse matrix %.0f, of the triplets for "
      "K and D %.0f\n",
      bytes(system.A) / vertices, sparse_bytes(triplets.K) / vertices,
      2 * double(triplets.K_entries.size() * sizeof(triplets.K_entries[0])) / vertices);
}

}  // namespace

int main() {
  std::printf(
      "Assembly of f, K, D and A\ncells  ours, ns/triangle  triplets / ours  coeffRef / ours\n");
  for (const int n : {32, 64, 128}) assembly(n);
  std::printf(
      "As it should be at 128: both above 4.\n\nA whole step, --solver ldlt\n"
      "cells  ours, ms  from triplets / ours\n");
  whole_step(64);
}
