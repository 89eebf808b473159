// Quadratic bending (Bergou et al. 2006): a condition that is linear in the vertices, and so a
// constant K.
//
//   y = Σ q_i x_i,   E = k/2 · 3/(A0 + A1) |y|²
//
// y is the Laplacian of the flat hinge, applied to the vertices. It is zero where the vertices are an
// affine image of the flat hinge. Where the flaps keep their shape
//
//   E = k 6|e|² sin²(θ/2)/(A0 + A1)
//
// which is 3|e|²/(A0 + A1) times k/2 θ² for small folds, and less for sharp ones. The model is only for
// flat rest shapes, and for cloth that hardly stretches: a deformation in the plane that is not affine
// costs energy, too.
#pragma once
#include "math/family.h"

struct QuadraticHinge : Element<4, 1> {
  static constexpr std::string_view plural = "hinges";
  double sqrt_weight;  // 1/m, √(3/(A0 + A1))
};

// A flap at rest, its own corner first.
using FlatFlap = std::array<Vec2, 3>;

inline double area(const FlatFlap& p) {
  const Vec2 a = p[1] - p[0], b = p[2] - p[0];
  return 0.5 * std::abs(a.x() * b.y() - a.y() * b.x());
}

// The cotangent of the angle at corner i.
inline double cotangent(const FlatFlap& p, int i) {
  const Vec2 a = p[(i + 1) % 3] - p[i], b = p[(i + 2) % 3] - p[i];
  return a.dot(b) / (2 * area(p));
}

// With the cotangents c_i at the corners of flap 0 and c_i' at those of flap 1, listed as for a Hinge:
//
//   q = (−c_1 − c_2,  c_2 + c_1',  c_1 + c_2',  −c_1' − c_2')
inline QuadraticHinge make_quadratic_hinge(const std::array<int, 4>& vertices,
                                           const FlatFlap& flap0, const FlatFlap& flap1) {
  const double c1 = cotangent(flap0, 1), c2 = cotangent(flap0, 2);
  const double d1 = cotangent(flap1, 1), d2 = cotangent(flap1, 2);
  QuadraticHinge hinge;
  hinge.vertices = vertices;
  hinge.weight << -c1 - c2, c2 + d1, c1 + d2, -d1 - d2;
  hinge.sqrt_weight = std::sqrt(3 / (area(flap0) + area(flap1)));
  return hinge;
}

// One of three conditions:  C = √(3/(A0 + A1)) y along an axis. It is linear, so ∂²C/∂y² = 0.
struct Flatness : Condition<1> {
  Flatness(const QuadraticHinge& hinge, const Vecs<1>& y, int axis) {
    dCdy = {hinge.sqrt_weight * Vec3::Unit(axis)};
    C = dCdy[0].dot(y[0]);
  }

  Mats<1> second() const { return zero_matrices<1>(); }
};

// [bend] model = "quadratic". A rotation of a folded hinge costs no energy. But it turns y and so changes
// each of the three conditions, and damping resists it.
struct QuadraticBend : Term {
  using Term::Term;
  static constexpr TermInfo info = {.table = "bend",
                                    .model = "quadratic",
                                    .first_step = 5,
                                    .units = newton_metre,
                                    .rests_flat = true,
                                    .rotation = Rotation::damped};
  static double k_of_modulus(double B) { return B / 3; }

  template <class Act>
  void conditions(const QuadraticHinge& hinge, const Vecs<1>& y, const Act& act) const {
    for (int axis = 0; axis < 3; ++axis) act(*this, Flatness(hinge, y, axis));
  }
};
