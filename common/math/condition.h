// The one idea that carries every model of this project: a condition.
//
//   C(x) is a number that is zero when the cloth is content (Baraff & Witkin 1998)
//   E   = k/2 C²                        energy                     J
//   f_i = −∂E/∂x_i = −k C ∂C/∂x_i       force on vertex i          N
//
// A condition reads the vertices of its element only through a few vectors y that are linear in
// them:
//
//   y_m = Σ_i weight(m, i) x_i          so that   ∂C/∂x_i = Σ_m weight(m, i) ∂C/∂y_m
//
// with weights known from the rest shape. A model is therefore written once, on y, and `gather` and
// `scatter` carry it to the vertices. For a triangle the y are w_u and w_v, the columns of the
// deformation gradient F, and weight(0, i) is the ∂w_u/∂x_i of the literature.
#pragma once
#include <cmath>
#include <type_traits>

#include "math/types.h"

// A condition on the M vectors of y from y[first] on: its value and its gradient, found by the
// constructor of the model. A model also has
//
//   Mats<M> second() const      M × M blocks ∂²C/∂y_m∂y_n
//
// a function of its own, because only --jacobian bw98 needs it, and, on a triangle or a spring,
//
//   Square<M> across() const    M × M numbers: ∂²C/∂y_m∂y_n across the element; see math/tension.h
template <int M_>
struct Condition {
  static constexpr int M = M_;

  double C;
  Vecs<M> dCdy;
  int first = 0;
};

// The stiffness and the damping of conditions: E = k/2 C², d = −kd Ċ ∂C/∂x. TermInfo::units has their units.
struct Term {
  explicit Term(double k_, double kd_ = 0) : k(k_), kd(kd_) {}

  double k;
  double kd;
};

// The N vertices that an element reads, and the weights that make its Y vectors y of them. The
// weights of each y add up to zero: moving the whole element is no deformation.
template <int N_, int Y_>
struct Element {
  static constexpr int N = N_, Y = Y_;

  Eigen::Matrix<double, Y, N> weight;
  std::array<int, N> vertices;
};

// An element whose vectors y are its N vertices, as seen from the first: moving the whole element
// changes nothing, and far from the origin its edges stay exact.
template <int N_>
struct VertexElement {
  static constexpr int N = N_, Y = N_;

  std::array<int, N> vertices;
};

// y_m = Σ_i weight(m, i) x_i = Σ_{i>0} weight(m, i) (x_i − x_0), exact far from the origin as well.
template <int N, int Y>
Vecs<Y> gather(const Element<N, Y>& e, const VecX& x) {
  const Vec3 x0 = x.segment<3>(3 * e.vertices[0]);
  Vecs<Y> y = zero_vectors<Y>();
  for (int i = 1; i < N; ++i) {
    const Vec3 edge = x.segment<3>(3 * e.vertices[i]) - x0;
    for (int m = 0; m < Y; ++m) y[m] += e.weight(m, i) * edge;
  }
  return y;
}

// y_i = x_i − x_0
template <int N>
Vecs<N> gather(const VertexElement<N>& e, const VecX& x) {
  const Vec3 x0 = x.segment<3>(3 * e.vertices[0]);
  Vecs<N> y;
  for (int i = 0; i < N; ++i) y[i] = x.segment<3>(3 * e.vertices[i]) - x0;
  return y;
}

// The chain rule:  f_i += Σ_m weight(m, i) f_m,  and f_0 is what makes the net force zero.
// (std::type_identity_t: N and Y follow from the element alone.)
template <int N, int Y>
void scatter(const Element<N, Y>& e, const std::type_identity_t<Vecs<Y>>& f_y, VecX& f) {
  Vec3 net = Vec3::Zero();
  for (int i = 1; i < N; ++i) {
    Vec3 f_i = e.weight(0, i) * f_y[0];
    for (int m = 1; m < Y; ++m) f_i += e.weight(m, i) * f_y[m];
    f.segment<3>(3 * e.vertices[i]) += f_i;
    net += f_i;
  }
  f.segment<3>(3 * e.vertices[0]) -= net;
}

template <int N>
void scatter(const VertexElement<N>& e, const std::type_identity_t<Vecs<N>>& f_y, VecX& f) {
  for (int i = 0; i < N; ++i) f.segment<3>(3 * e.vertices[i]) += f_y[i];
}

// |w|, and the direction n = ∂|w|/∂w of w. A thread that has collapsed to a point has no direction,
// so the length is smoothed over a width ε, 1e-9 of the length at rest:
//
//   |w| = √(w·w + ε²),   n = w / |w|,   ∂n/∂w = (I − n nᵀ) / |w|
//
// For |w| > 0.1 of that length this is |w| to the last digit; at w = 0 the direction is 0, and the force
// finite.
struct Length {
  static constexpr double epsilon = 1e-9;
  explicit Length(const Vec3& w, double at_rest = 1)
      : value(std::sqrt(w.squaredNorm() + epsilon * epsilon * at_rest * at_rest)), n(w / value) {}
  Mat3 second_derivative() const { return (Mat3::Identity() - n * n.transpose()) / value; }

  double value;
  Vec3 n;
};
