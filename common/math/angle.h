// Bending: the angle θ of a hinge and its two derivatives, in ten steps.
//
//          P2            A hinge is two triangles that share an edge: flap 0 = (P0, P1, P2) and
//         ╱│╲            flap 1 = (P3, P2, P1), both counter-clockwise from the front.
//       P0 │ P3
//         ╲│╱            θ = 0 where it is flat. θ > 0 where P0 and P3 are folded back: a ridge,
//          P1            seen from the front. Lifting P3 to the front makes θ negative: a valley.
//
// This sign stands here, in step 5, and nowhere else: the gradient of step 7 is that of this θ.
//
// Turned by half a turn a hinge is the same hinge, and flap 1 becomes flap 0. So every step but 5 is
// written once, for a flap whose corners 0, 1, 2 are its own vertex and the ends of the edge. The
// literature numbers by triangle and vertex: its d00, d01, d02 are d[0], d[1], d[2] of flap 0, and its
// d13, d12, d11 those of flap 1; the same for the cosines c and the binormals m.
#pragma once
#include <algorithm>
#include <cmath>

#include "math/types.h"

using Corners = std::array<double, 3>;  // a number at each corner of a flap

// 1. Edges: v_ab = p_a − p_b, m, and their directions e_ab.
struct Edges {
  Vec3 v10, v20, v12;
  Vec3 e10, e20, e12;
};

inline Edges edges(const Vec3& p0, const Vec3& p1, const Vec3& p2) {
  const Vec3 v10 = p1 - p0, v20 = p2 - p0, v12 = p1 - p2;
  return {v10, v20, v12, v10 / v10.norm(), v20 / v20.norm(), v12 / v12.norm()};
}

// 2. The cosine of the angle at each corner, and the normal, towards the front.
inline Corners cosines(const Edges& e) {
  return {e.e10.dot(e.e20), e.e10.dot(e.e12), -e.e20.dot(e.e12)};
}
inline Vec3 normal(const Edges& e) {
  const Vec3 N = e.e12.cross(e.e10);
  return N / N.norm();
}

// 3. Binormals: the unit vector in the flap from each corner to the opposite edge, square to it.
inline Vecs<3> binormals(const Edges& e, const Vec3& n) {
  return {-e.e12.cross(n), -e.e20.cross(n), e.e10.cross(n)};
}

// 4. Heights: how far each corner is from its opposite edge, m.
inline Corners heights(const Edges& e, const Vecs<3>& m) {
  return {m[0].dot(e.v10), -m[1].dot(e.v12), -m[2].dot(e.v20)};
}

struct Flap {
  Edges e;
  Corners c;  // cosines
  Vec3 n;     // normal
  Vecs<3> m;  // binormals
  Corners d;  // m, heights
};

inline Flap make_flap(const Vec3& p0, const Vec3& p1, const Vec3& p2) {
  Flap flap;
  flap.e = edges(p0, p1, p2);
  flap.c = cosines(flap.e);
  flap.n = normal(flap.e);
  flap.m = binormals(flap.e, flap.n);
  flap.d = heights(flap.e, flap.m);
  return flap;
}

// The two flaps of a hinge, and which vertices of it are their corners.
using Fold = std::array<Flap, 2>;
inline constexpr std::array<Face, 2> corners = {{{0, 1, 2}, {3, 2, 1}}};

inline Fold make_fold(const Vecs<4>& p) {
  return {make_flap(p[0], p[1], p[2]), make_flap(p[3], p[2], p[1])};
}

// The same two normals, but as long as twice the area of their flap, m².
struct Normals {
  explicit Normals(const Vecs<4>& p)
      : edge(p[1] - p[2]), N0(edge.cross(p[1] - p[0])), N1(edge.cross(p[3] - p[1])) {}

  Vec3 edge, N0, N1;
};

// 5. The angle from n0 to n1 about the edge, seen along e12 from its end P1 to its end P2, in [−π, π]:
//
//   |N0| |N1| cos θ = N0·N1,   |N0| |N1| sin θ = −e12·(N0 × N1)
//
// The angle needs no unit normals. So an energy, which needs nothing but θ, takes none of the other steps.
inline double angle(const Vecs<4>& p) {
  const auto& [edge, N0, N1] = Normals(p);
  return std::atan2(-edge.dot(N0.cross(N1)) / edge.norm(), N0.dot(N1));
}

// 6. ∂n/∂x_j = m_j nᵀ/d_j: only moving a corner along n tilts the flap, about the opposite edge and
// the more the lower the flap; n leans towards that edge.
inline std::array<Mat3, 3> normal_gradients(const Flap& f) {
  std::array<Mat3, 3> dndx;
  for (int j = 0; j < 3; ++j) dndx[j] = f.m[j] * f.n.transpose() / f.d[j];
  return dndx;
}

// 7. ∂θ/∂x_i = a_i n, the sum over the flaps that have vertex i. The levers a_i, 1/m, are
//
//   a_0 = −1/d_0,   a_1 = c_2/d_1,   a_2 = c_1/d_2
//
// Corner 0 turns its flap about the edge. What it pushes, the ends of the edge hold, each by its share
// of the lever, so that there is no net force: a_0 + a_1 + a_2 = 0; and no net torque.
inline Corners levers(const Flap& f) {
  return {-1 / f.d[0], f.c[2] / f.d[1], f.c[1] / f.d[2]};
}

inline Vecs<4> angle_gradient(const Fold& fold) {
  Vecs<4> gradient = zero_vectors<4>();
  for (int flap = 0; flap < 2; ++flap) {
    const Corners a = levers(fold[flap]);
    for (int i = 0; i < 3; ++i) gradient[corners[flap][i]] += a[i] * fold[flap].n;
  }
  return gradient;
}

// 8. ∂d_i/∂x_j. Corner i changes its height against m_i; the other two, j, turn the opposite edge and
// share the change by where the foot of the height lies: d_i c_k/d_j, with k the third corner.
inline Vecs<3> height_gradients(const Flap& f, int i) {
  Vecs<3> dddx;
  for (int j = 0; j < 3; ++j) dddx[j] = (j == i ? -1 : f.d[i] * f.c[3 - i - j] / f.d[j]) * f.m[i];
  return dddx;
}

// 9. ∂c_i/∂x_j = −(d_j/|v_ij|²) m_k: moving j towards the edge ij opens the angle at i; sin α_i is
// d_j/|v_ij|, and one more |v_ij| is the lever. Corner i itself undoes what the other two do.
inline Vecs<3> cosine_gradients(const Flap& f, int i) {
  const Corners squares = {f.e.v12.squaredNorm(), f.e.v20.squaredNorm(), f.e.v10.squaredNorm()};
  const int j = (i + 1) % 3, k = (i + 2) % 3;
  Vecs<3> dcdx;
  dcdx[j] = -f.d[j] / squares[k] * f.m[k];
  dcdx[k] = -f.d[k] / squares[j] * f.m[j];
  dcdx[i] = -dcdx[j] - dcdx[k];
  return dcdx;
}

// 10. ∂²θ/∂x_i∂x_j = n (∂a_i/∂x_j)ᵀ + a_i ∂n/∂x_j, the sum over the flaps. With the levers written as
// b_i/d_i, b = (−1, c_2, c_1):   ∂a_i/∂x_j = (∂b_i/∂x_j − a_i ∂d_i/∂x_j)/d_i
inline std::array<Vecs<3>, 3> lever_gradients(const Flap& f, const Corners& a) {
  const std::array<Vecs<3>, 3> dbdx = {zero_vectors<3>(), cosine_gradients(f, 2),
                                       cosine_gradients(f, 1)};
  std::array<Vecs<3>, 3> dadx;
  for (int i = 0; i < 3; ++i) {
    const Vecs<3> dddx = height_gradients(f, i);
    for (int j = 0; j < 3; ++j) dadx[i][j] = (dbdx[i][j] - a[i] * dddx[j]) / f.d[i];
  }
  return dadx;
}

inline Mats<4> angle_second(const Fold& fold) {
  Mats<4> second = zero_matrices<4>();
  for (int flap = 0; flap < 2; ++flap) {
    const Flap& f = fold[flap];
    const Corners a = levers(f);
    const std::array<Vecs<3>, 3> dadx = lever_gradients(f, a);
    const std::array<Mat3, 3> dndx = normal_gradients(f);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        second[corners[flap][i]][corners[flap][j]] += f.n * dadx[i][j].transpose() + a[i] * dndx[j];
  }
  return second;
}

// False if a flap is lower than `lowest`, m. Such a flap is a line: it has no normal, and the levers of one
// that is almost a line grow without bound. The lowest height of a flap is |N| divided by its longest edge.
// False also for not-a-numbers.
inline bool has_angle(const Vecs<4>& p, double lowest) {
  const auto& [edge, N0, N1] = Normals(p);
  const auto high = [&, e2 = edge.squaredNorm()](const Vec3& N, const Vec3& corner) {
    const double longest2 =
        std::max({e2, (p[1] - corner).squaredNorm(), (p[2] - corner).squaredNorm()});
    return N.squaredNorm() > lowest * lowest * longest2;
  };
  return high(N0, p[0]) && high(N1, p[3]);
}
