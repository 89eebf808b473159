// A sheet with all kinds of pins, and the definition of pins by dense matrices.
#pragma once
#include "step04_cg/time_step.h"
#include "support/dense.h"

inline constexpr std::array<const char*, 5> all_preconditioners = {"none", "jacobi", "block", "ic",
                                                                   "multigrid"};

inline Method cg(const std::string& preconditioner, double tolerance) {
  Method method;
  method.preconditioner = preconditioner;
  method.tolerance = tolerance;
  return method;
}

// S of a pin that holds the direction p, and of a pin that leaves only the direction d free.
inline Mat3 all_but(const Vec3& p) {
  return Mat3::Identity() - p * p.transpose();
}
inline Mat3 only(const Vec3& d) {
  return d * d.transpose();
}

// S of all vertices.
MatX filter_matrix(const Cloth&);

// Orthonormal columns that span the directions that the pins leave free.
MatX free_directions(const Cloth&);

// z by its definition: the part of Δv that the pins prescribe, in the directions that they hold.
VecX prescribed(const Cloth&, const VecX& v);

// The Δv in z + range(S) at which ½ Δvᵀ A Δv − bᵀ Δv is smallest.
VecX reduced_solution(const Cloth&, const MatX& A, const VecX& b, const VecX& z);

// A disturbed sheet that moves, held by pins that move: the corners in all directions, other
// vertices in two directions or in one, along the axes and obliquely. Two of them are neighbours.
struct PinnedSheet {
  explicit PinnedSheet(unsigned seed, Diagonals diagonals = Diagonals::alternating,
                       const std::array<int, 2>& cells = {6, 4});

  // A system whose A, b and Δv are those of a step from `state`.
  step04::System step(const Method&) const;

  Random random;
  Mesh mesh;
  Model model;
  Cloth cloth;
  State state;
  double h = 1.0 / 60;
};
