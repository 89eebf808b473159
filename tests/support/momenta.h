// Linear and angular momentum of a cloth about the origin, and a sheet to watch them on.
#pragma once
#include "support/scenes.h"

struct Momenta {
  Vec3 linear = Vec3::Zero(), angular = Vec3::Zero();
  double linear_scale = 0, angular_scale = 0;  // Σ m |v| and Σ m |x × v|
};

inline Momenta momenta(const Cloth& cloth, const State& state) {
  Momenta sum;
  for (int i = 0; i < cloth.vertices(); ++i) {
    const Vec3 x = state.x.segment<3>(3 * i), mv = cloth.mass[3 * i] * state.v.segment<3>(3 * i);
    sum.linear += mv;
    sum.angular += x.cross(mv);
    sum.linear_scale += mv.norm();
    sum.angular_scale += x.cross(mv).norm();
  }
  return sum;
}

// A free square metre that drifts and spins with 6 rad/s about an oblique axis.
inline TestScene thrown_sheet() {
  TestScene scene = sheet(5, Held::free, 100, 50, Gravity::off);
  const Vec3 spin = 6 * Vec3(1, 4, 2).normalized(), centre(0.5, 0, -0.5), drift(0.3, -0.2, 0.5);
  for (int i = 0; i < scene.cloth.vertices(); ++i)
    scene.start.v.segment<3>(3 * i) =
        drift + spin.cross(Vec3(scene.start.x.segment<3>(3 * i) - centre));
  scene.end = 0.3;
  return scene;
}
