// The usual way to a system matrix, for comparison: every condition of an element writes all its
// 3 × 3 blocks, as the notes give them, as triplets into a sparse matrix.
#pragma once
#include <Eigen/SparseCore>

#include "math/cloth.h"
#include "math/tension.h"
#include "support/both_halves.h"

using Sparse = Eigen::SparseMatrix<double>;
using Triplets = std::vector<Eigen::Triplet<double>>;

// ∂y_m/∂x_i; the vectors y of a hinge are its vertices.
template <int N, int Y>
double weight(const Element<N, Y>& e, int m, int i) {
  return e.weight(m, i);
}
inline double weight(const Hinge&, int m, int i) {
  return m == i;
}

// Adds the forces of a family to f, and calls add(i, j, K_ij, D_ij) for every block (i, j) of K and
// D, by the formulas of the notes.
template <class Family, class Add>
void family_blocks(const Family& family, const State& state, VecX& f, const Add& add) {
  constexpr int N = Family::N;
  for (const auto& e : family.elements) {
    const auto y = gather(e, state.x);
    Tension<Family::Y> tension;
    family.conditions(e, y, [&](const Term& term, const auto& c) {
      constexpr int M = std::decay_t<decltype(c)>::M;
      tension.add(term.k * c.C, c);
      Vecs<N> g = zero_vectors<N>();
      double Cdot = 0;
      for (int i = 0; i < N; ++i) {
        for (int m = 0; m < M; ++m) g[size_t(i)] += weight(e, c.first + m, i) * c.dCdy[size_t(m)];
        Cdot += g[size_t(i)].dot(state.v.segment<3>(3 * e.vertices[size_t(i)]));
      }
      for (int i = 0; i < N; ++i) {
        f.segment<3>(3 * e.vertices[size_t(i)]) -= (term.k * c.C + term.kd * Cdot) * g[size_t(i)];
        for (int j = 0; j < N; ++j) {
          const Mat3 ggT = g[size_t(i)] * g[size_t(j)].transpose();
          add(e.vertices[size_t(i)], e.vertices[size_t(j)], Mat3(-term.k * ggT),
              Mat3(-term.kd * ggT));
        }
      }
    });
    BothHalves<Family::Y> kept;
    tension.subtract_from(kept, e, y);
    for (int i = 0; i < N; ++i)
      for (int j = 0; j < N; ++j) {
        Mat3 K_ij = Mat3::Zero();
        for (int m = 0; m < Family::Y; ++m)
          for (int n = 0; n < Family::Y; ++n)
            K_ij += weight(e, m, i) * weight(e, n, j) * kept.blocks[size_t(m)][size_t(n)];
        add(e.vertices[size_t(i)], e.vertices[size_t(j)], K_ij, Mat3(Mat3::Zero()));
      }
  }
}

template <class Add>
void notes_blocks(const Cloth& cloth, const State& state, VecX& f, const Add& add) {
  f.setZero();
  for (int i = 0; i < cloth.vertices(); ++i)
    f.segment<3>(3 * i) = cloth.mass[3 * i] * *cloth.gravity;
  for_each_family(cloth, [&](const auto& family) { family_blocks(family, state, f, add); });
}

// f, K, D and A = M − h D − h² K from triplets. The lists of triplets keep their
// memory from step to step.
struct FromTriplets {
  FromTriplets(const Cloth& cloth_, double h_) : cloth(cloth_), h(h_), f(cloth.mass.size()) {
    for (Sparse* matrix : {&K, &D, &M}) matrix->resize(f.size(), f.size());
    for (int i = 0; i < f.size(); ++i) K_entries.emplace_back(i, i, cloth.mass[i]);
    M.setFromTriplets(K_entries.begin(), K_entries.end());
  }
  void assemble(const State& state) {
    K_entries.clear(), D_entries.clear();
    notes_blocks(cloth, state, f, [&](int i, int j, const Mat3& K_ij, const Mat3& D_ij) {
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
  // Takes the pinned coordinates out of the system: their rows and columns of A become those of M.
  void hold_pins(VecX& b) {
    A.prune([&](Eigen::Index r, Eigen::Index c, double) {
      return r == c || (cloth.inverse_mass[r] > 0 && cloth.inverse_mass[c] > 0);
    });
    for (const Pin& pin : cloth.pins) b.segment<3>(3 * pin.vertex).setZero();
  }

  const Cloth& cloth;
  double h;
  VecX f;
  Triplets K_entries, D_entries;
  Sparse K, D, A, M;
};
