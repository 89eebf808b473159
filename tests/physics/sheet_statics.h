// Strips of every model at rest under their weight, with their exact curves.
#pragma once
#include "physics/sheets.h"
#include "support/statics.h"

namespace sheet_statics {

inline constexpr double L = 1, w = density * g;  // m; N/m², the weight per area

// A strip in the plane z = 0, with its top, v = 1, at y = 0.
inline TestScene vertical_strip(const Sheet& sheet, double width, const std::array<int, 2>& cells) {
  TestScene scene =
      scene_of(make_grid({width, L}, cells, Diagonals::same), sheet.model, Gravity::on);
  lay(scene, [](double u, double v) { return Vec3(u, v - L, 0); });
  return scene;
}

// Which coordinates of the strip move together. `level`: the rows stay level, and their width is free, at the
// top as well. `pinned`: every vertex moves in the plane of the strip, and the top is pinned.
enum class Rows { level, pinned };

inline std::vector<std::vector<int>> unknowns(const Grid& grid, Rows rows) {
  const auto [columns, top] = grid.cells;
  const auto x = [&](int i, int j) { return 3 * grid.vertex(i, j); };
  std::vector<std::vector<int>> all;
  if (rows == Rows::level)
    for (int j = 0; j <= top; ++j) {
      all.push_back({x(1, j)});
      if (j < top) all.push_back({x(0, j) + 1, x(1, j) + 1});
    }
  else
    for (int j = 0; j < top; ++j)
      for (int i = 0; i <= columns; ++i)
        for (const int axis : {0, 1}) all.push_back({x(i, j) + axis});
  return all;
}

// The mean elongation of the strip at rest, by Newton's method from a uniform stretch.
inline double elongation(const TestScene& scene, Rows rows, double stretch) {
  const Grid& grid = *scene.mesh.grid;
  VecX x = scene.start.x;
  for (int i = 1; i < x.size(); i += 3) x[i] *= stretch;
  x = equilibrium(scene.cloth, freedom(x.size(), unknowns(grid, rows)), x);
  double lowest = 0;
  for (int i = 0; i <= grid.cells[0]; ++i) lowest += x[3 * i + 1] / (grid.cells[0] + 1);
  return -lowest - L;
}

// At the distance s from the lower end the strip carries the weight w s. With its sides free it is stretched
// there as the uniaxial law says:
//
//   elongation = ∫ (λ(w s) − 1) ds,   pull(λ) = w s           by Simpson's rule
inline double exact_elongation(const Sheet& sheet) {
  constexpr int n = 40;
  double sum = 0;
  for (int i = 0; i <= n; ++i) {
    const double weight = i == 0 || i == n ? 1 : i % 2 == 1 ? 4 : 2;
    sum += weight * (sheet.stretch_under(w * L * i / n) - 1);
  }
  return sum * L / (3 * n);
}

// A strip that hangs between its two ends, at the distance D. With the horizontal force H, and s from the
// middle, the tension of a thread with P = E (λ − 1) gives
//
//   x(s) = H/w asinh(w s/H) + H s/E,   y(s) = H/w (√(1 + (w s/H)²) − 1) + w s²/(2 E)
//
// for a strip 1 m wide. The first terms are the catenary of a thread that cannot stretch.
struct Catenary {
  Catenary(double D, double E_) : E(E_) {
    H = zero_of([&](double guess) { return (H = guess, x(L / 2) - D / 2); }, 1e-3, 1e3);
  }
  double x(double s) const { return H / w * std::asinh(w * s / H) + H * s / E; }
  double y(double s) const { return H / w * (std::hypot(1, w * s / H) - 1) + w * s * s / (2 * E); }
  double sag() const { return y(L / 2); }

  double E, H;
};

struct Hung {
  double sag, H;  // m; N per m of width
};

// At rest, from the exact curve. A row of vertices moves as one.
inline Hung hang(const Sheet& sheet, const Catenary& exact, int rows) {
  TestScene scene =
      scene_of(make_grid({L / rows, L}, {1, rows}, Diagonals::same), sheet.model, Gravity::on);
  lay(scene, [&](double u, double v) { return Vec3(exact.x(v - L / 2), exact.y(v - L / 2), u); });
  const auto row = [&](int j, int axis) {
    return std::vector<int>{3 * (2 * j) + axis, 3 * (2 * j + 1) + axis};
  };
  std::vector<std::vector<int>> unknowns;
  for (int j = 1; j < rows; ++j)
    for (const int axis : {0, 1}) unknowns.push_back(row(j, axis));
  const VecX x = equilibrium(scene.cloth, freedom(scene.start.x.size(), unknowns), scene.start.x);
  Statics statics(scene.cloth);
  statics.evaluate(x);
  return {x[row(0, 1)[0]] - x[row(rows / 2, 1)[0]], statics.f(row(0, 0)).sum() / (L / rows)};
}

}  // namespace sheet_statics
