// What the assembly of f, K, D and A costs per triangle, in three ways: ours; the notes' way, nine 3 × 3
// blocks per condition into triplets and setFromTriplets; and the same blocks into coeffRef of a matrix
// that has its pattern already. Then a whole step of the default solver beside one from triplets that
// analyses its matrix anew. Ratios are medians over interleaved rounds of CPU time.
#include <time.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <Eigen/SparseCholesky>

#include "math/poses.h"
#include "scene/make_cloth.h"
#include "step03_implicit/time_step.h"

namespace {

using Sparse = Eigen::SparseMatrix<double>;
using Triplets = std::vector<Eigen::Triplet<double>>;
constexpr double h = 1.0 / 60;

struct Scene {
  explicit Scene(int n) : mesh(make_grid({1, 1}, {n, n}, Diagonals::alternating)) {
    Model model;
    model.stretch = Term{"stretch", 1000, 0.02};
    model.shear = Term{"shear", 500, 0.01};
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

// f, and every block (i, j) of K and of D to add(i, j, K_ij, D_ij), as the notes write it.
template <class Add>
void notes_blocks(const Scene& scene, VecX& f, const Add& add) {
  f.setZero();
  for (int i = 0; i < scene.cloth.vertices(); ++i)
    f.segment<3>(3 * i) = scene.cloth.mass[3 * i] * *scene.cloth.gravity;
  for (const Triangle& t : scene.cloth.triangles.elements) {
    const Vecs<2> w = gather(t, scene.state.x);
    scene.cloth.triangles.conditions(
        t, w, [&](const Term& term, const auto& c, const auto& second) {
          constexpr int M = int(std::tuple_size_v<std::decay_t<decltype(c.dCdy)>>);
          const double kept = c.convex ? std::max(term.k * c.C, 0.0) : 0;
          const Mats<M> H = kept != 0 ? second() : zero_matrices<M>();
          Vecs<3> g = zero_vectors<3>();
          double Cdot = 0;
          for (int i = 0; i < 3; ++i) {
            for (int m = 0; m < M; ++m)
              g[size_t(i)] += t.weight(c.first + m, i) * c.dCdy[size_t(m)];
            Cdot += g[size_t(i)].dot(scene.state.v.segment<3>(3 * t.vertices[size_t(i)]));
          }
          for (int i = 0; i < 3; ++i) {
            f.segment<3>(3 * t.vertices[size_t(i)]) -=
                (term.k * c.C + term.kd * Cdot) * g[size_t(i)];
            for (int j = 0; j < 3; ++j) {
              const Mat3 ggT = g[size_t(i)] * g[size_t(j)].transpose();
              Mat3 K = -term.k * ggT;
              if (kept != 0)
                for (int m = 0; m < M; ++m)
                  for (int n = 0; n < M; ++n)
                    K -= kept * t.weight(c.first + m, i) * t.weight(c.first + n, j) *
                         H[size_t(m)][size_t(n)];
              add(t.vertices[size_t(i)], t.vertices[size_t(j)], K, Mat3(-term.kd * ggT));
            }
          }
        });
  }
}

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

// The notes' way, with triplets; `entries` keep their memory from step to step.
struct FromTriplets {
  explicit FromTriplets(const Scene& s) : scene(s), f(s.mesh.x.size()) {
    for (Sparse* matrix : {&K, &D, &M}) matrix->resize(f.size(), f.size());
    for (int i = 0; i < f.size(); ++i) K_entries.emplace_back(i, i, s.cloth.mass[i]);
    M.setFromTriplets(K_entries.begin(), K_entries.end());
  }
  void assemble() {
    K_entries.clear(), D_entries.clear();
    notes_blocks(scene, f, [&](int i, int j, const Mat3& K_ij, const Mat3& D_ij) {
      for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c) {
          K_entries.emplace_back(3 * i + r, 3 * j + c, K_ij(r, c));
          D_entries.emplace_back(3 * i + r, 3 * j + c, D_ij(r, c));
        }
    });
    K.setFromTriplets(K_entries.begin(), K_entries.end());
    D.setFromTriplets(D_entries.begin(), D_entries.end());
    A = M - h * D - h * h * K;
  }
  const Scene& scene;
  VecX f;
  Triplets K_entries, D_entries;
  Sparse K, D, A, M;
};

struct FromCoeffRef : FromTriplets {
  explicit FromCoeffRef(const Scene& s) : FromTriplets(s) { FromTriplets::assemble(); }
  void assemble() {
    K.coeffs().setZero(), D.coeffs().setZero();
    notes_blocks(scene, f, [&](int i, int j, const Mat3& K_ij, const Mat3& D_ij) {
      for (int c = 0; c < 3; ++c)
        for (int r = 0; r < 3; ++r) {
          K.coeffRef(3 * i + r, 3 * j + c) += K_ij(r, c);
          D.coeffRef(3 * i + r, 3 * j + c) += D_ij(r, c);
        }
    });
    A = M - h * D - h * h * K;
  }
};

// A whole step from triplets: pinned rows and columns replaced by M, the pattern analysed anew.
VecX step_from_triplets(FromTriplets& way) {
  way.assemble();
  VecX b = h * (way.f + h * (way.K * way.scene.state.v));
  way.A.prune([&](Eigen::Index r, Eigen::Index c, double) {
    return r == c || (way.scene.cloth.inverse_mass[r] > 0 && way.scene.cloth.inverse_mass[c] > 0);
  });
  for (const Pin& pin : way.scene.cloth.pins) b.segment<3>(3 * pin.vertex).setZero();
  Eigen::SimplicialLDLT<Sparse> ldlt(way.A);
  return ldlt.solve(b);
}

double seconds(const auto& work) {
  const auto now = [] {
    timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
  };
  const double start = now();
  work();
  return now() - start;
}

double median(std::vector<double> v) {
  std::nth_element(v.begin(), v.begin() + long(v.size() / 2), v.end());
  return v[v.size() / 2];
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
  FromTriplets triplets(scene);
  FromCoeffRef coeff(scene);
  ours.assemble(), triplets.assemble(), coeff.assemble();
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
    triplet_ratio.push_back(seconds([&] { triplets.assemble(); }) / t.back());
    coeff_ratio.push_back(seconds([&] { coeff.assemble(); }) / t.back());
  }
  std::printf("%4d  %14.0f  %16.1f  %16.1f\n", n, 1e9 * median(t) / scene.triangles(),
              median(triplet_ratio), median(coeff_ratio));
}

void whole_step(int n) {
  const Scene scene(n);
  step03::System system(scene.cloth);
  FromTriplets triplets(scene);
  std::vector<double> t, ratio;
  for (int round = 0; round < 7; ++round) {
    State state = scene.state;
    VecX dv;
    t.push_back(seconds([&] { step03::time_step(scene.cloth, h, state, system); }));
    ratio.push_back(seconds([&] { dv = step_from_triplets(triplets); }) / t.back());
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
