// The options of the implicit steps. A step reads only the options whose concept it teaches.
#pragma once
#include <string>
#include <vector>

#include "math/counters.h"

// Which part of (k C + kd Ċ) ∂²C/∂x² stands in the matrix: all of it, as Baraff & Witkin print it, or
// only the tension across each element (math/tension.h), which keeps the matrix positive definite.
enum class Jacobian { definite, bw98 };

inline const std::vector<std::string> solver_names = {"ldlt", "inverse", "cholmod"};
inline const std::vector<std::string> preconditioner_names = {"none", "jacobi", "block", "ic",
                                                              "multigrid"};

struct Method {
  Jacobian jacobian = Jacobian::definite;
  int newton = 1;               // Newton iterations per step at most; 1 is the plain step
  bool guard = true;            // a plain step that gains energy is taken again by Newton's method
  std::string solver = "ldlt";  // one of solver_names

  std::string preconditioner = "block";  // one of preconditioner_names
  double tolerance = 1e-4;               // of conjugate gradients: √(rᵀ P⁻¹ r) / |Δv|_M
  int max_iterations = 10000;            // in one system

  // The printed matrix is there to show how it fails.
  bool guarded() const { return guard && jacobian == Jacobian::definite; }
};
