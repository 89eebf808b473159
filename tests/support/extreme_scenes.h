// Scenes that should break no step: a square metre of 12 × 12 cells with equal diagonals,
// k_shear = k, without damping, and with gravity; two corners are held where they start.
#pragma once
#include <random>

#include "support/scenes.h"

namespace extremes {

inline constexpr int cells = 12;

inline int vertex(int i, int j) {
  return j * (cells + 1) + i;
}

// Starts flat and horizontal.
inline TestScene dropped(double k) {
  return sheet(cells, Held::by_two_corners, k, k, Gravity::on);
}

// Starts flat, at 1 % of its size. So the two held corners are 1 cm apart.
inline TestScene squeezed(double k) {
  TestScene scene = dropped(k);
  scene.start.x *= 0.01;
  return scene;
}

// Every vertex without a pin starts at a random place in a cubic metre.
inline TestScene tangled(double k) {
  TestScene scene = dropped(k);
  std::mt19937 random(1);  // the same numbers everywhere
  for (double& coordinate : scene.start.x) coordinate = double(random()) / 4294967296.0;
  for (const Pin& pin : scene.cloth.pins)
    scene.start.x.segment<3>(3 * pin.vertex) = scene.mesh.x.segment<3>(3 * pin.vertex);
  return scene;
}

// Two neighbours at one point.
inline TestScene coincident(double k) {
  TestScene scene = dropped(k);
  scene.start.x.segment<3>(3 * vertex(6, 6)) = scene.start.x.segment<3>(3 * vertex(7, 6));
  return scene;
}

// One triangle degenerates to a line, one to a point.
inline TestScene collapsed(double k) {
  TestScene scene = dropped(k);
  const auto at = [&](int i, int j) { return scene.start.x.segment<3>(3 * vertex(i, j)); };
  at(3, 3) = (at(4, 3) + at(3, 4)) / 2;
  at(8, 8) = at(9, 8) = at(8, 9);
  return scene;
}

// The vertex in the middle leaves at 1 km/s.
inline TestScene shot(double k) {
  TestScene scene = dropped(k);
  scene.start.v.segment<3>(3 * vertex(6, 6)) = Vec3(480, 600, 640);
  return scene;
}

using MakeScene = TestScene (*)(double k);

// A strip of cloth, 1 m long and a quarter wide, whose two ends are held at 70 % of its length. It
// is flat except for a sine wave of one micrometre. No gravity.
inline TestScene pushed_strip(double k) {
  const Mesh mesh = make_grid({0.25, 1}, {3, cells}, Diagonals::same);
  Model m = model(k, k, Gravity::off);
  m.pins = where(mesh, [](double, double v) { return v == 0 || v == 1; });
  TestScene scene = at_rest(mesh, m);
  scene.start.x =
      field(mesh, [](double u, double v) { return Vec3(u, 1e-6 * std::sin(pi * v), -0.7 * v); });
  return scene;
}

}  // namespace extremes
