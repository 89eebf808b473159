// Sheets held in every way that a pin can hold, and what pins mean, with dense matrices.
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

// What a pin leaves free that holds the unit vector p, or that leaves only d.
inline Mat3 all_but(const Vec3& p) {
  return Mat3::Identity() - p * p.transpose();
}
inline Mat3 only(const Vec3& d) {
  return d * d.transpose();
}

// S of all vertices.
MatX filter_matrix(const Cloth&);

// Orthonormal columns that span what the pins leave free.
MatX free_directions(const Cloth&);

// z as it is defined: what the pins prescribe of Δv, in the directions that they hold.
VecX prescribed(const Cloth&, const VecX& v);

// The Δv in z + range(S) at which ½ Δvᵀ A Δv − bᵀ Δv is smallest.
VecX reduced_solution(const Cloth&, const MatX& A, const VecX& b, const VecX& z);

// A disturbed sheet that moves, held by pins that move: corners in all directions, others in two and
// in one, along the axes and obliquely, and two neighbours.
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
