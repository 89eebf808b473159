// Conditions of a triangle that ignore rotations. They read F = (w_u w_v) only through its metric:
//
//   FᵀF = (A B; B D),   A = |w_u|²,  B = w_u·w_v,  D = |w_v|²
//
// A function C(A, B, D) has three slopes, and with them
//
//   ∂C/∂w_u = 2 C_A w_u + C_B w_v,   ∂C/∂w_v = C_B w_u + 2 C_D w_v
//   c = (2 C_A  C_B; C_B  2 C_D)     across the triangle (tension.h)
//
// So a model is a formula for C. Its slopes follow by the rules of differentiation, which Slopes knows.
#pragma once
#include "math/triangle.h"

// A number that depends on A, B and D: its value and its three slopes. T is double, or Slopes<double>: then the
// slopes have slopes, too, which are the second derivatives.
template <class T>
struct Slopes {
  T value, A = 0, B = 0, D = 0;

  Slopes(const T& value_, const T& A_, const T& B_, const T& D_)
      : value(value_), A(A_), B(B_), D(D_) {}
  Slopes(double number) : value(number) {}

  // f(x) with ∂f = f'(x) ∂x.
  static Slopes chain(const Slopes& x, const T& f, const T& slope) {
    return {f, slope * x.A, slope * x.B, slope * x.D};
  }
  friend Slopes operator+(const Slopes& a, const Slopes& b) {
    return {a.value + b.value, a.A + b.A, a.B + b.B, a.D + b.D};
  }
  friend Slopes operator-(const Slopes& a, const Slopes& b) {
    return {a.value - b.value, a.A - b.A, a.B - b.B, a.D - b.D};
  }
  friend Slopes operator-(const Slopes& a, double b) { return {a.value - b, a.A, a.B, a.D}; }
  friend Slopes operator*(double a, const Slopes& b) {
    return {a * b.value, a * b.A, a * b.B, a * b.D};
  }
  friend Slopes operator*(const Slopes& a, const Slopes& b) {
    return {a.value * b.value, a.A * b.value + a.value * b.A, a.B * b.value + a.value * b.B,
            a.D * b.value + a.value * b.D};
  }
  friend Slopes operator/(const Slopes& a, const Slopes& b) {
    const T q = a.value / b.value, inverse = 1 / b.value;
    return {q, inverse * (a.A - q * b.A), inverse * (a.B - q * b.B), inverse * (a.D - q * b.D)};
  }
  friend Slopes sqrt(const Slopes& x) {
    using std::sqrt;
    const T root = sqrt(x.value);
    return chain(x, root, 0.5 / root);
  }
  friend Slopes log(const Slopes& x) {
    using std::log;
    return chain(x, log(x.value), 1 / x.value);
  }
};

// The metric, and J = √(AD − B²) = |w_u × w_v|, the area by its area at rest. A cloth that is turned over is a
// rotated cloth, so J has no sign. The length of the normal has more digits than AD − B², and Length keeps J
// from zero where the triangle is a line.
template <class Number>
struct Metric {
  Number A, B, D, J;

  // s, the trace of S = √(FᵀF)
  Number trace_of_stretch() const {
    using std::sqrt;
    return sqrt(A + D + 2 * J);
  }
};

inline Metric<double> metric(const Vecs<2>& w) {
  return {w[0].squaredNorm(), w[0].dot(w[1]), w[1].squaredNorm(), Length(w[0].cross(w[1])).value};
}

//   ∂J/∂A = D/2J,   ∂J/∂B = −B/J,   ∂J/∂D = A/2J
template <class T>
Metric<Slopes<T>> with_slopes(const Metric<T>& m) {
  const T inverse = 1 / m.J;
  return {{m.A, 1, 0, 0},
          {m.B, 0, 1, 0},
          {m.D, 0, 0, 1},
          {m.J, 0.5 * (inverse * m.D), -1. * (inverse * m.B), 0.5 * (inverse * m.A)}};
}

// √a times a function of the metric. Function::strains(metric) is a list of them; this is the one at `which`.
template <class Function>
struct MetricCondition : Condition<2> {
  MetricCondition(const Triangle& t, const Vecs<2>& w_, const Slopes<double>& e,
                  const Function& function_, size_t which_)
      : sqrt_area(t.sqrt_area), c(coefficients(e)), w(w_), function(function_), which(which_) {
    C = sqrt_area * e.value;
    for (int m = 0; m < 2; ++m) dCdy[m] = sqrt_area * (c(m, 0) * w[0] + c(m, 1) * w[1]);
  }

  static Square<2> coefficients(const Slopes<double>& e) {
    return (Square<2>() << 2 * e.A, e.B, e.B, 2 * e.D).finished();
  }
  Square<2> across() const { return sqrt_area * c; }

  // With G_m = (∂A/∂w_m  ∂B/∂w_m  ∂D/∂w_m) as columns, and the Hessian H of C by A, B and D:
  //
  //   ∂²C/∂w_m∂w_n = c_mn I + G_m H G_nᵀ
  Mats<2> second() const {
    const auto e = function.strains(with_slopes(with_slopes(metric(w))))[which];
    std::array<Mat3, 2> G;
    G[0] << 2 * w[0], w[1], Vec3::Zero();
    G[1] << Vec3::Zero(), w[0], 2 * w[1];
    Mat3 H;
    H << e.A.A, e.A.B, e.A.D, e.B.A, e.B.B, e.B.D, e.D.A, e.D.B, e.D.D;
    Mats<2> blocks;
    for (int m = 0; m < 2; ++m)
      for (int n = 0; n < 2; ++n)
        blocks[m][n] = sqrt_area * (c(m, n) * Mat3::Identity() + G[m] * H * G[n].transpose());
    return blocks;
  }

  double sqrt_area;
  Square<2> c;
  const Vecs<2>& w;
  const Function& function;
  size_t which;
};
