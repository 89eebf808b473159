// The systems that the solvers are compared on, one step of cloths in mid-swing, and what is known of a
// solution of one: iterations, residual, error.
#pragma once
#include "math/direct_solver.h"
#include "scene/make_cloth.h"
#include "step04_cg/time_step.h"

// What tells one case from another. Every cloth is 1 m × 1 m with 0.2 kg/m², held by the two corners at
// the back, and swings from flat for `steps` steps of h, each taken in `parts`: in whole ones, linearised
// once, the finest grids would tear here, and a torn cloth is a system of its own.
struct Setting {
  int cells;
  Diagonals diagonals = Diagonals::same;
  double k = 1e4, k_shear = 1e3;         // N/m
  double kd_stretch = 10, kd_shear = 1;  // N s/m: kd/k = 1e-3 s
  double h = 0.01;                       // s
  int steps = 20, parts = 8;
};

struct Case {
  explicit Case(const Setting&);  // reads the state that the first run saved beside the program

  Setting setting;
  Mesh mesh;
  Cloth cloth;
  State state;
  VecX last_dv;  // of the step that led here
  double vertices() const { return double(cloth.vertices()); }
};

// cholmod where it was found when building, else ldlt.
const std::string& best_direct();

// A, b, preconditioner and dv = z of the step that comes next, and the true Δv.
struct Problem {
  Problem(const Case&, const std::string& preconditioner);
  step04::System system;
};
VecX true_dv(const Case&, const step04::System&);

// Conjugate gradients as in step 4, from Δv = dv, seen from outside before every iteration: what the
// stop test compares with the tolerance, √(rᵀ T r) / |Δv|_M, and the error relative to the true Δv. Ends
// where both are small enough.
struct Look {
  double left, error;
};
std::vector<Look> watch(const Case&, step04::System&, VecX dv, const VecX& truth,
                        const Look& enough);

// After how many iterations the loop ends that stops at a tolerance.
inline size_t iterations(const std::vector<Look>& looks, double tolerance) {
  size_t i = 0;
  while (i + 1 < looks.size() && looks[i].left > tolerance) ++i;
  return i;
}

// After how many iterations the error is small enough, if one knew it.
inline size_t iterations_to(const std::vector<Look>& looks, double error) {
  size_t i = 0;
  while (i + 1 < looks.size() && looks[i].error > error) ++i;
  return i;
}

// The loosest of the tolerances 1, 3e-1, 1e-1, 3e-2 … that leaves at most this error.
double loosest(const std::vector<Look>&, double error);

inline size_t bytes(const BlockMatrix& A) {
  return sizeof(Mat3) * (A.diagonal.size() + A.upper.size()) +
         sizeof(int) * (A.row_start.size() + A.column.size());
}
