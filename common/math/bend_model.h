// How a cloth resists folding: four models to choose from, and what their k means.
#pragma once
#include <optional>

enum class BendModel {
  dihedral,   // C = θ − θ0 of every hinge (Baraff & Witkin)                       hinge.h
  bridson,    // C ∝ sin((θ − θ0)/4), with the forces of Bridson et al.            hinge.h
  quadratic,  // C linear in the vertices: K is constant (Bergou et al.)           quadratic_bend.h
  springs     // between opposite vertices: hardly any resistance to small folds   spring.h
};

// The k of a model, N·m, that gives a cloth the bending modulus B: bent to a cylinder of curvature κ
// it stores B κ²/2 per area. N·m as well.
//
// It holds for square cells, vertices that lie on the cylinder, and an axis along the grid. In other
// directions a cloth is up to three times as stiff, or half; free to relax it is softer, a narrow strip
// by up to 1/3; and on cells a × b the dihedral model has B = k a/b bent along a. Springs have no
// modulus: their energy grows with κ⁴.
inline std::optional<double> stiffness_of_modulus(BendModel model, double B) {
  switch (model) {
    case BendModel::dihedral:
      return B;
    case BendModel::bridson:
      return 4 * B;
    case BendModel::quadratic:
      return B / 3;
    case BendModel::springs:
      return std::nullopt;
  }
  return std::nullopt;
}
