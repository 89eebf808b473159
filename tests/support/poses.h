// Random triangles: rest shapes of any size, proportion and winding, and the poses in which
// the derivatives of a condition are tested.
#pragma once
#include <numbers>
#include <ostream>
#include <random>

#include "math/triangle.h"

inline constexpr double pi = std::numbers::pi;

// Reproducible random numbers: every test makes its own from a seed.
class Random {
 public:
  explicit Random(unsigned seed) : generator(seed) {}

  unsigned seed() { return unsigned(generator()); }  // for another generator

  double between(double low, double high) {
    return low + (high - low) * double(generator()) / double(std::mt19937::max());
  }
  // Entries between −size and size.
  VecX vector(int n, double size) {
    VecX x(n);
    for (double& entry : x) entry = between(-size, size);
    return x;
  }
  Vec3 direction() {
    Vec3 d;
    do d = vector(3, 1);
    while (d.norm() > 1 || d.norm() < 0.1);
    return d.normalized();
  }
  Mat3 rotation() { return Eigen::AngleAxisd(between(-pi, pi), direction()).toRotationMatrix(); }

 private:
  std::mt19937 generator;
};

using Rest = std::array<Vec2, 3>;  // (u, v) of the three corners

// Edges between 5 cm and 4 m, counter-clockwise or clockwise, anywhere in (u, v), no slivers.
inline Rest random_rest(Random& random) {
  const double size = random.between(0.05, 2);
  const Vec2 origin = random.vector(2, 3);
  for (;;) {
    const Vec2 e1 = random.vector(2, size), e2 = random.vector(2, size);
    if (std::abs(e1.x() * e2.y() - e1.y() * e2.x()) > 0.3 * size * size)
      return {origin, origin + e1, origin + e2};
  }
}

inline Triangle make_triangle(const Rest& rest) {
  return make_triangle({0, 1, 2}, rest[0], rest[1], rest[2]);
}

enum class Pose { random, compressed, sheared, inverted, line, collapsed };

inline constexpr std::array<Pose, 6> all_poses = {
    Pose::random, Pose::compressed, Pose::sheared, Pose::inverted, Pose::line, Pose::collapsed};

inline const char* name(Pose pose) {
  switch (pose) {
    case Pose::random:
      return "random";
    case Pose::compressed:
      return "compressed";
    case Pose::sheared:
      return "sheared";
    case Pose::inverted:
      return "inverted";
    case Pose::line:
      return "almost_a_line";
    case Pose::collapsed:
      return "collapsed";
  }
  return "?";
}
inline void PrintTo(Pose pose, std::ostream* out) {
  *out << name(pose);
}

// The two columns w_u, w_v of F in a pose, turned at random in space.
inline Vecs<2> pose_w(Pose pose, Random& random) {
  Vec3 wu = Vec3::UnitX(), wv = Vec3::UnitY();
  switch (pose) {
    case Pose::random:
      wu = random.between(0.3, 2) * random.direction();
      wv = random.between(0.3, 2) * random.direction();
      break;
    case Pose::compressed:
      wu *= 0.5, wv *= 0.5;
      break;
    case Pose::sheared:
      wv += 0.6 * wu;
      break;
    case Pose::inverted:
      wu *= 0.85, wv *= -1.15;
      break;  // det < 0 in the plane: turned over
    case Pose::line:
      wv = random.between(-1.5, 1.5) * wu + 5e-2 * wv;
      break;
    case Pose::collapsed:
      wu *= 1e-3, wv *= 1.5e-3;
      break;
  }
  const Mat3 R = random.rotation();
  return {R * wu, R * wv};
}

// The vertices that have this F, within a few metres of the origin.
inline VecX positions(const Rest& rest, const Vecs<2>& w, const Vec3& origin) {
  VecX x(9);
  for (int i = 0; i < 3; ++i) {
    const Vec2 uv = rest[i] - rest[0];
    x.segment<3>(3 * i) = origin + uv.x() * w[0] + uv.y() * w[1];
  }
  return x;
}

// x rotated and then moved.
inline VecX moved(const VecX& x, const Mat3& R, const Vec3& by) {
  VecX y(x.size());
  for (int i = 0; i < x.size(); i += 3) y.segment<3>(i) = R * x.segment<3>(i) + by;
  return y;
}
