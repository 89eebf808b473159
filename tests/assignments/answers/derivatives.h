// The derivatives of a formula by machine: the answers beside this file have no derivative written down. It cannot
// be handed in: it needs a header of Eigen, and the grader takes no line that begins with # from a student.
#pragma once
#include <unsupported/Eigen/AutoDiff>

// A number with its slopes by N variables, and one whose slopes have slopes.
template <int N>
using Once = Eigen::AutoDiffScalar<Eigen::Matrix<double, N, 1>>;
template <int N>
using Twice = Eigen::AutoDiffScalar<Eigen::Matrix<Once<N>, N, 1>>;

// Vectors of space whose entries have slopes.
template <class Number>
using Vector = std::array<Number, 3>;

template <class Number>
Number dot(const Vector<Number>& a, const Vector<Number>& b) {
  const Number x = a[0] * b[0], y = a[1] * b[1], z = a[2] * b[2], xy = x + y;
  return xy + z;
}
template <class Number>
Vector<Number> cross(const Vector<Number>& a, const Vector<Number>& b) {
  const auto entry = [&](size_t i, size_t j) -> Number {
    const Number first = a[i] * b[j], second = a[j] * b[i];
    return first - second;
  };
  return {entry(1, 2), entry(2, 0), entry(0, 1)};
}
template <class Number>
Vector<Number> sum(double s, const Vector<Number>& a, double t, const Vector<Number>& b) {
  Vector<Number> all;
  for (size_t i = 0; i < 3; ++i) {
    const Number first = s * a[i], second = t * b[i];
    all[i] = first + second;
  }
  return all;
}
// As in math/condition.h: a vector of no length has no direction.
template <class Number>
Number length(const Vector<Number>& a) {
  const Number square = dot(a, a) + 1e-18;
  return sqrt(square);
}

template <int M>
struct Differentiated {
  double value;
  Vecs<M> gradient;
  Mats<M> second;

  // nᵀ ∂²C/∂y_m∂y_n n
  Square<M> across(const Vec3& n) const {
    Square<M> c;
    for (int i = 0; i < M; ++i)
      for (int j = 0; j < M; ++j) c(i, j) = n.dot(second[size_t(i)][size_t(j)] * n);
    return c;
  }
};

// formula(y): a number that depends on M vectors.
template <size_t M>
auto differentiated(const std::array<Vec3, M>& y, const auto& formula) {
  constexpr int N = 3 * int(M);
  std::array<Vector<Twice<N>>, M> variables;
  for (int i = 0; i < N; ++i) {
    Twice<N> variable(Once<N>(y[size_t(i / 3)][i % 3], N, i));
    for (int j = 0; j < N; ++j)
      variable.derivatives()[j] = Once<N>(i == j ? 1.0 : 0.0, Eigen::Matrix<double, N, 1>::Zero());
    variables[size_t(i / 3)][size_t(i % 3)] = variable;
  }
  const Twice<N> C = formula(variables);
  Differentiated<int(M)> all;
  all.value = C.value().value();
  for (int i = 0; i < N; ++i) {
    const Once<N> slope = C.derivatives()[i];
    all.gradient[size_t(i / 3)][i % 3] = slope.value();
    for (int j = 0; j < N; ++j)
      all.second[size_t(i / 3)][size_t(j / 3)](i % 3, j % 3) = slope.derivatives()[j];
  }
  return all;
}
