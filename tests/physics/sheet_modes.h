// Strips of every model that vibrate, and the frequencies of a chain of springs.
#pragma once
#include "physics/sheets.h"
#include "support/modes.h"
#include "support/statics.h"

namespace sheet_modes {

inline constexpr double L = 1;  // m

// K̂ = −∂f/∂x
inline MatX stiffness(const TestScene& scene) {
  Statics statics(scene.cloth);
  statics.evaluate(scene.start.x);
  return statics.K;
}

// A strip along v, one cell wide, that is stretched by s. A row of vertices moves as one, and keeps its
// width.
inline TestScene stretched_strip(const Sheet& sheet, int rows, double s) {
  TestScene scene =
      scene_of(make_grid({L / rows, L}, {1, rows}, Diagonals::same), sheet.model, Gravity::off);
  scene.start.x = field(scene.mesh, [&](double u, double v) { return Vec3(u, 0, -s * v); });
  return scene;
}

// The frequencies ω of rows 1 to `last`, when they move along one axis and the others stand still, 1/s,
// ascending.
inline VecX frequencies(const TestScene& scene, int last, int axis) {
  std::vector<std::vector<int>> unknowns;
  for (int j = 1; j <= last; ++j) unknowns.push_back({3 * (2 * j) + axis, 3 * (2 * j + 1) + axis});
  const MatX P = freedom(scene.start.x.size(), unknowns);
  const VecX mass = product({P.transpose(), scene.cloth.mass});
  const MatX root = mass.cwiseSqrt().cwiseInverse().asDiagonal();
  const VecX squares = eigenvalues(product({root, P.transpose(), stiffness(scene), P, root}));
  return squares.cwiseMax(0).cwiseSqrt();
}

// Waves run through a thread of length L at rest with the speed c. Rows at the distance h are a chain of
// springs, with the frequencies
//
//   one end held     ω_n = 2 c/h sin((2n − 1) π h/4L)  →  (2n − 1) π c/2L
//   both ends held   ω_n = 2 c/h sin(n π h/2L)         →  n π c/L
inline double chain(double c, int rows, double quarter_waves) {
  return 2 * c * rows / L * std::sin(quarter_waves * pi / (4 * rows));
}

}  // namespace sheet_modes
