// Stretch and shear of a triangle: two threads per triangle, along u and along v.
//
//   w_u = ∂x/∂u,  w_v = ∂x/∂v         the columns of F = [x1−x0, x2−x0] Dm⁻¹, 3 × 2
//   Dm  = [uv1−uv0, uv2−uv0]          2 × 2, m, the rest shape
//
// |w| is the stretch of a thread: 1 at rest, 1.05 when it is 5 % longer.
#pragma once
#include "math/family.h"

struct Triangle : Element<3, 2> {
  static constexpr std::string_view plural = "triangles";
  int face = 0;      // its place in the list of triangles
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

// P = n nᵀ, the direction across the triangle (math/tension.h); zero where the triangle is a line.
inline Mat3 across(const Triangle&, const Vecs<2>& w) {
  const Vec3 n = Length(w[0].cross(w[1])).n;
  return n * n.transpose();
}

// Stretch: the thread along w = w[m] wants its rest length b (1: as woven).
//
//   C = √a (|w| − b),   ∂C/∂w = √a n,   n = w/|w|
//
// BW98 weighs by the area a. With √a the energy k/2 C² is proportional to the area, so that k is
// the stiffness of the cloth in N/m and means the same on every mesh.
struct Stretch : Condition<1> {
  Stretch(const Triangle& t, const Vecs<2>& w, int m, double b = 1)
      : sqrt_area(t.sqrt_area), length(w[m]) {
    C = sqrt_area * (length.value - b);
    dCdy = {sqrt_area * length.n};
    first = m;
  }

  // ∂²C/∂w² = √a (I − n nᵀ)/|w|: only turning the thread changes n, and the shorter it is the more.
  Mats<1> second() const { return {{{sqrt_area * length.second_derivative()}}}; }
  Square<1> across() const { return Square<1>(sqrt_area / length.value); }

  double sqrt_area;
  Length length;
};

// Shear: the two threads want to stay perpendicular.
//
//   C = √a w_u·w_v,   ∂C/∂w_u = √a w_v,   ∂C/∂w_v = √a w_u
struct Shear : Condition<2> {
  Shear(const Triangle& t, const Vecs<2>& w) : sqrt_area(t.sqrt_area) {
    C = sqrt_area * w[0].dot(w[1]);
    dCdy = {sqrt_area * w[1], sqrt_area * w[0]};
  }

  // ∂²C/∂w_u∂w_v = √a I, with the eigenvalues ±√a: whatever the sign of C is, half of it is negative.
  Mats<2> second() const {
    const Mat3 O = Mat3::Zero(), I = sqrt_area * Mat3::Identity();
    return {{{O, I}, {I, O}}};
  }
  Square<2> across() const { return sqrt_area * (Square<2>() << 0, 1, 1, 0).finished(); }

  double sqrt_area;
};

// [stretch]: both threads of a triangle.
struct StretchTerm : Term {
  using Term::Term;
  static constexpr TermInfo info = {.table = "stretch", .in_plane = InPlane::threads};

  template <class Act>
  void conditions(const Triangle& t, const Vecs<2>& w, const Act& act) const {
    for (int m = 0; m < 2; ++m) act(*this, Stretch(t, w, m, b[m]));
  }

  std::array<double, 2> b = {1, 1};  // rest lengths b_u, b_v of the threads
};

// [shear]
struct ShearTerm : Term {
  using Term::Term;
  static constexpr TermInfo info = {.table = "shear", .in_plane = InPlane::threads};

  template <class Act>
  void conditions(const Triangle& t, const Vecs<2>& w, const Act& act) const {
    act(*this, Shear(t, w));
  }
};
