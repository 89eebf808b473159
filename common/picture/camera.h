// The matrices that take a point of space to the picture, as OpenGL wants them: all visible
// points land in the cube [-1, 1]^3.
#pragma once
#include <cmath>
#include <Eigen/Dense>
#include <numbers>

#include "math/types.h"

// The camera sees this much from the lower to the upper border.
inline constexpr double field_of_view = 35 * std::numbers::pi / 180;

// Moves `eye` to the origin and turns the view from it to `target` along -z.
inline Eigen::Matrix4d look_at(const Vec3& eye, const Vec3& target) {
  const Vec3 back = (eye - target).normalized();
  const Vec3 up = std::abs(back.y()) < 0.999 ? Vec3::UnitY() : Vec3(-Vec3::UnitZ());
  const Vec3 right = up.cross(back).normalized();
  Eigen::Matrix4d m = Eigen::Matrix4d::Identity();
  m.row(0).head<3>() = right;
  m.row(1).head<3>() = back.cross(right);
  m.row(2).head<3>() = back;
  m.col(3).head<3>() = -m.topLeftCorner<3, 3>() * eye;
  return m;
}

// aspect: width / height of the picture.
inline Eigen::Matrix4d perspective(double aspect, double near, double far) {
  const double f = 1 / std::tan(field_of_view / 2);
  Eigen::Matrix4d m = Eigen::Matrix4d::Zero();
  m(0, 0) = f / aspect;
  m(1, 1) = f;
  m(2, 2) = (far + near) / (near - far);
  m(2, 3) = 2 * far * near / (near - far);
  m(3, 2) = -1;
  return m;
}

// Parallel rays along `light` (towards the light); sees the ball of radius `reach` around `centre`.
inline Eigen::Matrix4d from_light(const Vec3& light, const Vec3& centre, double reach) {
  Eigen::Matrix4d m = look_at(centre + light, centre);
  m(2, 3) += 1;  // depth 0 at the centre
  m.topRows<3>() /= reach;
  m.row(2) = -m.row(2);
  return m;
}

// Slides every point along `light` onto the ground y = 0; sees the square of half side `reach`
// around `centre`. Depth keeps the height, so that points below the ground can be clipped away.
inline Eigen::Matrix4d onto_ground(const Vec3& light, const Vec3& centre, double reach) {
  Eigen::Matrix4d m = Eigen::Matrix4d::Identity();
  m.row(0) << 1 / reach, -light.x() / light.y() / reach, 0, -centre.x() / reach;
  m.row(1) << 0, -light.z() / light.y() / reach, 1 / reach, -centre.z() / reach;
  m.row(2) << 0, 0, 0, 0;
  return m;
}
