// The scenes on which every step is judged: small cloths whose motion is known exactly, or so
// smooth that a finer computation gives many digits. Damping is set afterwards, in cloth.triangles.
#pragma once
#include <cmath>
#include <functional>

#include "scene/make_cloth.h"
#include "support/bend_models.h"
#include "support/poses.h"

inline constexpr double g = 9.81;       // m/s²
inline constexpr double density = 0.2;  // kg/m²

struct TestScene {
  Mesh mesh;
  Cloth cloth;
  State start;
  double end = 0;  // s
};

enum class Gravity { off, on };

inline Model model(double k_stretch, double k_shear, Gravity gravity) {
  Model m;
  m.density = density;
  if (k_stretch > 0) m.add(StretchTerm(k_stretch));
  if (k_shear > 0) m.add(ShearTerm(k_shear));
  if (gravity == Gravity::on) m.gravity = Vec3(0, -g, 0);
  return m;
}

// The vertices for whose (u, v) `hold` is true.
inline std::vector<Pin> where(const Mesh& grid, const std::function<bool(double, double)>& hold) {
  std::vector<Pin> found;
  for (int i = 0; i < grid.vertices(); ++i)
    if (hold(grid.x[3 * i], -grid.x[3 * i + 2])) found.push_back(i);
  return found;
}

// A vector per vertex from its (u, v).
inline VecX field(const Mesh& grid, const std::function<Vec3(double, double)>& at) {
  VecX all(grid.x.size());
  for (int i = 0; i < grid.vertices(); ++i)
    all.segment<3>(3 * i) = at(grid.x[3 * i], -grid.x[3 * i + 2]);
  return all;
}

inline TestScene at_rest(const Mesh& mesh, const Model& model) {
  return {mesh, make_cloth(mesh, model), {mesh.x, VecX::Zero(mesh.x.size())}, 0};
}

// A flat, horizontal, square metre, held by the two corners at v = 1 or by nothing.
enum class Held { free, by_two_corners };

inline TestScene sheet(int cells, Held held, double k, double k_shear, Gravity gravity) {
  const Mesh mesh = make_grid({1, 1}, {cells, cells}, Diagonals::same);
  Model m = model(k, k_shear, gravity);
  if (held == Held::by_two_corners) m.pins = {cells * (cells + 1), cells * (cells + 1) + cells};
  return at_rest(mesh, m);
}

// One triangle that hangs by its two upper vertices, so that only vertex 2 moves, 1 m from
// the hinge. It starts at rest, `angle` from straight down. The thread along v runs from
// the middle of the hinge to vertex 2: a spring of stiffness k a/(1 m)², whose length is
// the length of the pendulum.
inline TestScene pendulum(double angle, double k, double k_shear) {
  Mesh mesh;
  mesh.faces = {{0, 1, 2}};
  mesh.rest = {{Vec2(0, 0), Vec2(1, 0), Vec2(0.5, 1)}};
  mesh.x.resize(9);
  mesh.x << 0, 0, 0, 1, 0, 0, 0.5, -std::cos(angle), std::sin(angle);
  Model m = model(k, k_shear, Gravity::on);
  m.pins = {0, 1};
  return at_rest(mesh, m);
}

// A strip 1 m long in the plane z = 0, unstretched, held by its top row, v = 1, at y = 0.
inline TestScene strip(double width, const std::array<int, 2>& cells, double k, double k_shear,
                       Gravity gravity) {
  const Mesh mesh = make_grid({width, 1}, cells, Diagonals::same);
  Model m = model(k, k_shear, gravity);
  m.pins = where(mesh, [](double, double v) { return v == 1; });
  TestScene scene = at_rest(mesh, m);
  scene.start.x = field(mesh, [](double u, double v) { return Vec3(u, v - 1, 0); });
  return scene;
}

// The depth below the top at which a point s of a hanging cloth of length L rests. The thread at s
// bears the weight below it, and stretch is linear at any strain:
//   ρ g (L − s) = k (λ − 1),   λ = dy/ds      so   y = s + ρ g (L s − s²/2)/k,   y(L) = L + ρ g L²/2k
inline double hanging_depth(double s, double L, double k) {
  return s + density * g * (L * s - s * s / 2) / k;
}

// The scenes in which the order of convergence is measured. In each of them, small differences at
// the start stay small until `end`, so that the error at the end is that of the method.

// A triangle that swings from the horizontal.
inline TestScene swinging_triangle() {
  TestScene scene = pendulum(pi / 2, 200, 100);
  scene.end = 0.5;
  return scene;
}

// A strip of `rows` rows of square cells that vibrates lengthwise in its first mode.
// Tension is linear in stretch, at any amplitude, so the motion is that of air in a pipe:
// with s = v − 1 from the top,
//
//   y(s, t) = s + 0.05 m sin(π s/2) cos(ω t),   ω = π/2 √(k/ρ)/(1 m)
inline double ringing_depth(double s, double k, double time) {
  return s + 0.05 * std::sin(pi / 2 * s) * std::cos(pi / 2 * std::sqrt(k / density) * time);
}

inline TestScene ringing_strip_of(int rows, double k) {
  TestScene scene = strip(0.25, {rows / 4, rows}, k, k / 2, Gravity::off);
  for (int i = 0; i < scene.cloth.vertices(); ++i)
    scene.start.x[3 * i + 1] = ringing_depth(scene.start.x[3 * i + 1], k, 0);
  scene.end = 0.2;
  return scene;
}
inline TestScene ringing_strip() {
  return ringing_strip_of(8, 100);
}

// A sheet held by all edges, stretched by 5 %, and thrown up in the middle. It shows the order
// most clearly of the four.
inline TestScene trampoline() {
  const Mesh mesh = make_grid({1, 1}, {6, 6}, Diagonals::same);
  Model m = model(100, 50, Gravity::on);
  m.pins = where(mesh, [](double u, double v) { return u == 0 || u == 1 || v == 0 || v == 1; });
  TestScene scene = at_rest(mesh, m);
  scene.start.x *= 1.05;
  scene.start.v = field(
      mesh, [](double u, double v) { return Vec3(0, 2 * std::sin(pi * u) * std::sin(pi * v), 0); });
  for (const Pin& pin : m.pins)
    scene.start.v.segment<3>(3 * pin.vertex).setZero();  // sin π is not 0
  scene.end = 0.25;
  return scene;
}

// A curtain held by its top row, stretched by its own weight, and pulled 25 degrees aside.
inline TestScene curtain_of(double k) {
  const Mesh mesh = make_grid({1, 1}, {6, 6}, Diagonals::same);
  const double angle = 25 * pi / 180;
  Model m = model(k, k / 2, Gravity::on);
  m.pins = where(mesh, [](double, double v) { return v == 1; });
  TestScene scene = at_rest(mesh, m);
  scene.start.x = field(mesh, [&](double u, double v) {
    const double depth = hanging_depth(1 - v, 1, k);
    return Vec3(u, -depth * std::cos(angle), depth * std::sin(angle));
  });
  scene.end = 0.3;
  return scene;
}
inline TestScene curtain() {
  return curtain_of(100);
}

// A flap, held level at one end, that falls and bends.
inline TestScene flap(BendModel bend_model = BendModel::dihedral) {
  const Mesh mesh = make_grid({0.5, 0.125}, {8, 2}, Diagonals::same);
  Model m = model(100, 50, Gravity::on);
  add_bend(m, bend_model, *stiffness_of_modulus(bend_model, 0.02));
  m.pins = where(mesh, [](double u, double) { return u < 0.1; });
  TestScene scene = at_rest(mesh, m);
  scene.end = 0.25;
  return scene;
}
