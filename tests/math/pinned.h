// Sheets held in every way that a pin can hold, and what pins mean, with dense matrices.
#pragma once
#include <Eigen/Eigenvalues>

#include "dense.h"
#include "step04_cg/time_step.h"

inline constexpr std::array<const char*, 5> all_preconditioners = {"none", "jacobi", "block", "ic",
                                                                   "multigrid"};

inline Method cg(const std::string& preconditioner, double tolerance) {
  Method method;
  method.preconditioner = preconditioner;
  method.tolerance = tolerance;
  return method;
}

// What a pin leaves free that holds the unit vector p, or that leaves only d.
inline Mat3 all_but(const Vec3& p) {
  return Mat3::Identity() - p * p.transpose();
}
inline Mat3 only(const Vec3& d) {
  return d * d.transpose();
}

// S of all vertices.
inline MatX filter_matrix(const Cloth& cloth) {
  MatX S = MatX::Identity(cloth.mass.size(), cloth.mass.size());
  for (const Pin& pin : cloth.pins) S.block<3, 3>(3 * pin.vertex, 3 * pin.vertex) = pin.S;
  return S;
}

// Orthonormal columns that span what the pins leave free.
inline MatX free_directions(const Cloth& cloth) {
  const Eigen::SelfAdjointEigenSolver<MatX> eigen(filter_matrix(cloth));
  const auto free = (eigen.eigenvalues().array() > 0.5).count();
  return eigen.eigenvectors().rightCols(free);  // eigenvalues ascend: 0 … 0, 1 … 1
}

// z as it is defined: what the pins prescribe of Δv, in the directions that they hold.
inline VecX prescribed(const Cloth& cloth, const VecX& v) {
  VecX lacking = VecX::Zero(v.size());
  for (const Pin& pin : cloth.pins)
    lacking.segment<3>(3 * pin.vertex) = pin.velocity - v.segment<3>(3 * pin.vertex);
  return lacking - filter_matrix(cloth) * lacking;
}

// The Δv in z + range(S) at which ½ Δvᵀ A Δv − bᵀ Δv is smallest.
inline VecX reduced_solution(const Cloth& cloth, const MatX& A, const VecX& b, const VecX& z) {
  const MatX Z = free_directions(cloth);
  return z + Z * (Z.transpose() * A * Z).ldlt().solve(Z.transpose() * (b - A * z));
}

// A disturbed sheet that moves, held by pins that move: corners in all directions, others in two and
// in one, along the axes and obliquely, and two neighbours.
struct PinnedSheet {
  explicit PinnedSheet(unsigned seed, Diagonals diagonals = Diagonals::alternating,
                       const std::array<int, 2>& cells = {6, 4})
      : random(seed), mesh(make_grid({1, 1}, cells, diagonals)) {
    const Grid& grid = *mesh.grid;
    const int right = cells[0], top = cells[1];
    const auto pin = [&](int i, int j, const Mat3& S) {
      model.pins.emplace_back(grid.vertex(i, j), S, random.vector(3, 1));
    };
    pin(0, top, Mat3::Zero());
    pin(right, top, Mat3::Zero());
    pin(right - 1, top, Mat3::Zero());
    pin(1, 0, only(Vec3::UnitY()));
    pin(right, 1, only(random.direction()));
    pin(0, 1, all_but(Vec3::UnitX()));
    pin(2, 2, all_but(random.direction()));
    pin(3, 2, all_but(random.direction()));
    model.stretch = Term{"stretch", 1000, 0.5};
    model.shear = Term{"shear", 500, 0.2};
    model.gravity = Vec3(0, -9.81, 0);
    cloth = make_cloth(mesh, model);
    state = disturbed(mesh, 0.3 / right, random);
  }

  // A system whose A, b and Δv are those of a step from `state`.
  step04::System step(const Method& method) const {
    step04::System system(cloth, method);
    State end = state;
    step04::time_step(cloth, h, end, system);
    return system;
  }

  Random random;
  Mesh mesh;
  Model model;
  Cloth cloth;
  State state;
  double h = 1.0 / 60;
};
