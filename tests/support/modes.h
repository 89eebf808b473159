// Vibration about a state by brute force: the stiffness matrix from differences of the forces, one
// column at a time, and all frequencies from a dense eigenvalue solver.
#pragma once
#include <vector>

#include "math/cloth.h"
#include "support/decompositions.h"

// K̂ = −∂f/∂x by central differences of width `reach`. For forces that are linear in x the only
// error is rounding, f/reach.
template <class Forces, class System>
MatX stiffness_matrix(const Cloth& cloth, const State& state, const Forces& forces, System& system,
                      double reach) {
  MatX K(state.x.size(), state.x.size());
  for (int j = 0; j < K.cols(); ++j) {
    State moved = state;
    moved.x[j] = state.x[j] + reach;
    forces(cloth, moved, system);
    K.col(j) = -system.f;
    moved.x[j] = state.x[j] - reach;
    forces(cloth, moved, system);
    K.col(j) += system.f;
  }
  return K / (2 * reach);
}

// K̂ p = ω² M p on the coordinates that are not pinned.
struct Modes {
  VecX omega;  // 1/s, ascending; 0 if ω² is not positive
  MatX shape;  // m, one column per mode, zero at the pins
};

inline Modes modes(const Cloth& cloth, const MatX& K) {
  std::vector<int> free;
  for (int i = 0; i < cloth.mass.size(); ++i)
    if (cloth.inverse_mass[i] > 0) free.push_back(i);
  const VecX root = cloth.mass(free).cwiseSqrt().cwiseInverse();
  const MatX scaled = root.asDiagonal() * K(free, free) * root.asDiagonal();
  const Eigenpairs pairs = eigenpairs(0.5 * (scaled + scaled.transpose()));
  Modes m;
  m.omega = pairs.values.cwiseMax(0).cwiseSqrt();
  m.shape = MatX::Zero(cloth.mass.size(), root.size());
  for (size_t i = 0; i < free.size(); ++i)
    m.shape.row(free[i]) = root[Eigen::Index(i)] * pairs.vectors.row(Eigen::Index(i));
  return m;
}
