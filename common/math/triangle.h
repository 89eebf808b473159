// Stretch and shear of a triangle: two threads per triangle, along u and along v.
//
//   w_u = ∂x/∂u,  w_v = ∂x/∂v         the columns of F = [x1−x0, x2−x0] Dm⁻¹, 3 × 2
//   Dm  = [uv1−uv0, uv2−uv0]          2 × 2, m, the rest shape
//
// |w| is the stretch of a thread: 1 at rest, 1.05 when it is 5 % longer.
#pragma once
#include <optional>
#include <vector>

#include "math/condition.h"

struct Triangle : Element<3, 2> {
  double area;       // m², at rest
  double sqrt_area;  // m
};

// The weights from the rest shape: w = [x1−x0, x2−x0] Dm⁻¹, so that weight(:, 1) and weight(:, 2)
// are the rows of Dm⁻¹. A triangle listed clockwise in (u, v) has det Dm < 0; its area is |det Dm|/2.
inline Triangle make_triangle(const Face& vertices, const Vec2& uv0, const Vec2& uv1,
                              const Vec2& uv2) {
  Eigen::Matrix2d Dm;
  Dm << uv1 - uv0, uv2 - uv0;
  Triangle t;
  t.vertices = vertices;
  t.weight.rightCols<2>() = Dm.inverse().transpose();
  t.weight.col(0) = -t.weight.col(1) - t.weight.col(2);
  t.area = 0.5 * std::abs(Dm.determinant());
  t.sqrt_area = std::sqrt(t.area);
  return t;
}

// Stretch: the thread along w = w[m] wants its rest length b (1: as woven).
//
//   C = √a (|w| − b),   ∂C/∂w = √a n,   n = w/|w|
//
// BW98 weighs by the area a. With √a the energy k/2 C² is proportional to the area, so that k is
// the stiffness of the cloth in N/m and means the same on every mesh.
inline Condition<1> stretch(const Triangle& t, const Vecs<2>& w, int m, double b = 1) {
  const Length length(w[m]);
  return {t.sqrt_area * (length.value - b), {t.sqrt_area * length.n}, m, true};
}

// ∂²C/∂w² = √a (I − n nᵀ)/|w|: only turning the thread changes n, and the shorter it is the more.
inline Mats<1> stretch_second(const Triangle& t, const Vecs<2>& w, int m) {
  return {{{t.sqrt_area * Length(w[m]).second_derivative()}}};
}

// Shear: the two threads want to stay perpendicular.
//
//   C = √a w_u·w_v,   ∂C/∂w_u = √a w_v,   ∂C/∂w_v = √a w_u
inline Condition<2> shear(const Triangle& t, const Vecs<2>& w) {
  return {t.sqrt_area * w[0].dot(w[1]), {t.sqrt_area * w[1], t.sqrt_area * w[0]}};
}

// ∂²C/∂w_u∂w_v = √a I; it has the eigenvalues ±√a, so shear is not convex.
inline Mats<2> shear_second(const Triangle& t) {
  const Mat3 O = Mat3::Zero(), I = t.sqrt_area * Mat3::Identity();
  return {{{O, I}, {I, O}}};
}

// The triangles of a cloth and the conditions that they carry in this scene.
struct Triangles {
  static constexpr int N = 3, Y = 2;
  std::vector<Triangle> elements;  // empty where the scene models neither stretch nor shear
  std::optional<Term> stretch, shear;
  std::array<double, 2> b = {1, 1};  // rest lengths b_u, b_v of the threads

  // Hands each condition of t, at w, to act(term, condition, second), where second() is the second
  // derivative, computed only by whoever calls it.
  template <class Act>
  void conditions(const Triangle& t, const Vecs<2>& w, const Act& act) const {
    if (stretch)
      for (int m = 0; m < 2; ++m)
        act(*stretch, ::stretch(t, w, m, b[m]), [&, m] { return stretch_second(t, w, m); });
    if (shear) act(*shear, ::shear(t, w), [&] { return shear_second(t); });
  }
};
