// The systems on which the solvers are compared, each from one step of a cloth in mid-swing, and
// the measurements of a solution: iterations, residual, error.
#pragma once
#include "math/direct_solver.h"
#include "scene/make_cloth.h"
#include "step04_cg/time_step.h"

// The parameters of a case. Every cloth is 1 m × 1 m with 0.2 kg/m² and held by its two back
// corners. It starts flat and swings for `steps` steps of h. Each step is taken in `parts`: whole
// steps, linearised once, would tear the finest grids, and a torn cloth is another system.
struct Setting {
  int cells;
  Diagonals diagonals = Diagonals::same;
  double k = 1e4, k_shear = 1e3;         // N/m
  double kd_stretch = 10, kd_shear = 1;  // N s/m: kd/k = 1e-3 s
  double h = 0.01;                       // s
  int steps = 20, parts = 8;
  double bend = 0;  // N m; kd/k = 1e-3 s
};

struct Case {
  explicit Case(const Setting&);  // reads the state that the first run saved beside the program

  Setting setting;
  Mesh mesh;
  Cloth cloth;
  State state;
  VecX last_dv;  // of the step that led to `state`
  double vertices() const { return double(cloth.vertices()); }
};

// "cholmod" if the build found it, else "ldlt".
const std::string& best_direct();

// A, b, the preconditioner and dv = z of the next step. true_dv solves its system directly.
struct Problem {
  Problem(const Case&, const std::string& preconditioner);
  step04::System system;
};
VecX true_dv(const Case&, const step04::System&);

// Conjugate gradients as in step 4, from Δv = dv, with a look before every iteration at two
// numbers: √(rᵀ P⁻¹ r) / |Δv|_M, which the stop test compares with the tolerance, and the error
// relative to the true Δv. Ends when both are small enough.
struct Look {
  double left, error;
};
std::vector<Look> watch(const Case&, step04::System&, VecX dv, const VecX& truth,
                        const Look& enough);

// The number of iterations of a loop that stops at this tolerance.
inline size_t iterations(const std::vector<Look>& looks, double tolerance) {
  size_t i = 0;
  while (i + 1 < looks.size() && looks[i].left > tolerance) ++i;
  return i;
}

// The number of iterations that the error itself needs. The loop of a step cannot know this error.
inline size_t iterations_to(const std::vector<Look>& looks, double error) {
  size_t i = 0;
  while (i + 1 < looks.size() && looks[i].error > error) ++i;
  return i;
}

// The loosest tolerance of 1, 3e-1, 1e-1, 3e-2 … that leaves at most this error.
double loosest(const std::vector<Look>&, double error);

inline size_t bytes(const BlockMatrix& A) {
  return sizeof(Mat3) * (A.diagonal.size() + A.upper.size()) +
         sizeof(int) * (A.row_start.size() + A.column.size());
}
