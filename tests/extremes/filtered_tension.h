// Ways to make the matrix of an element definite. With
//
//   G = Σ k ∂C/∂y ∂C/∂yᵀ,   S = Σ k C ∂²C/∂y²      the sums over the conditions of the element
//
// the printed matrix is −K = G + S, and may have negative eigenvalues. Every way keeps −K = G + R:
//
//   tension    R = T₊ ⊗ P                   math/tension.h, the steps' own
//   clamp      G + R = (G + S)₊             negative eigenvalues become zero
//   absolute   G + R = |G + S|              negative eigenvalues change their sign (Chen et al. 2024)
//   sum        R = S₊
//   kim        R = Σ ((k ggᵀ + k C ∂²C)₊ − k ggᵀ)     every condition by itself (Kim 2020)
//   full       R = S                        the printed matrix
//
// FilteredTension takes the place of Tension in a step. Hinges keep only G, as in the steps; `full` keeps
// their S, too.
#pragma once
#include "math/tension.h"

namespace extremes {

enum class Filter { tension, clamp, absolute, sum, kim, full };
inline Filter filter = Filter::tension;  // of the step that is running

// A without its negative eigenvalues, and with their absolute values. In a file of their own: inlined into
// every condition of every family they would compile for minutes.
Square<3> without_negative(const Square<3>& A);
Square<6> without_negative(const Square<6>& A);
Square<3> absolute(const Square<3>& A);
Square<6> absolute(const Square<6>& A);

template <int M>
Square<3 * M> from_blocks(const Mats<M>& blocks) {
  Square<3 * M> all;
  for (int m = 0; m < M; ++m)
    for (int n = 0; n < M; ++n) all.template block<3, 3>(3 * m, 3 * n) = blocks[m][n];
  return all;
}

// The same of a symmetric matrix, from its blocks m ≤ n.
template <int M>
Square<3 * M> from_upper(const Mats<M>& blocks) {
  Mats<M> both = blocks;
  for (int m = 0; m < M; ++m)
    for (int n = 0; n < m; ++n) both[m][n] = blocks[n][m].transpose();
  return from_blocks<M>(both);
}

template <int M>
Mats<M> to_blocks(const Square<3 * M>& all) {
  Mats<M> blocks;
  for (int m = 0; m < M; ++m)
    for (int n = 0; n < M; ++n) blocks[m][n] = all.template block<3, 3>(3 * m, 3 * n);
  return blocks;
}

// k ggᵀ + load ∂²C without its negative eigenvalues, minus k ggᵀ. k is load/C; without a load, no ∂²C acts.
template <class Condition>
Square<3 * Condition::M> clamped_alone(double load, const Condition& c) {
  constexpr int size = 3 * Condition::M;
  if (load == 0) return Square<size>::Zero();
  Eigen::Vector<double, size> g;
  for (int m = 0; m < c.M; ++m) g.template segment<3>(3 * m) = c.dCdy[m];
  const Square<size> kggT = load / c.C * g * g.transpose();
  const Square<size> k_and_load = kggT + load * from_blocks<Condition::M>(c.second());
  return without_negative(k_and_load) - kggT;
}

template <int Y>
class FilteredTension {
 public:
  // One condition under the load k C.
  template <class Condition>
  void add(double load, const Condition& c) {
    if (filter == Filter::tension)
      tension.add(load, c);
    else
      add_second(load, c);
  }

  // K is −G, and becomes −(G + R).
  template <class Matrix, class Element>
  void subtract_from(Matrix& K, const Element& element, const Vecs<Y>& y) const {
    if (filter == Filter::tension)
      tension.subtract_from(K, element, y);
    else if (filter == Filter::full)
      subtract(S, K);
    else if constexpr (requires { across(element, y); })
      subtract(to_blocks<Y>(R(-from_upper<Y>(K.on_y()), from_blocks<Y>(S))), K);
  }

 private:
  // noinline: else this would compile for minutes.
  template <class Condition>
  [[gnu::noinline]] void add_second(double load, const Condition& c) {
    Mats<Condition::M> all = c.second();
    for (auto& row : all)
      for (Mat3& block : row) block *= load;
    if constexpr (requires { c.across(); })
      if (filter == Filter::kim) all = to_blocks<Condition::M>(clamped_alone(load, c));
    for (int m = 0; m < c.M; ++m)
      for (int n = 0; n < c.M; ++n) S[c.first + m][c.first + n] += all[m][n];
  }

  static Square<3 * Y> R(const Square<3 * Y>& G, const Square<3 * Y>& S) {
    switch (filter) {
      case Filter::clamp:
        return without_negative(Square<3 * Y>(G + S)) - G;
      case Filter::absolute:
        return absolute(Square<3 * Y>(G + S)) - G;
      case Filter::sum:
        return without_negative(S);
      default:
        return S;  // kim: each condition is clamped already
    }
  }

  template <class Matrix>
  static void subtract(const Mats<Y>& R, Matrix& K) {
    for (int m = 0; m < Y; ++m)
      for (int n = m; n < Y; ++n) K.add(m, n, -R[m][n]);
  }

  Tension<Y> tension;
  Mats<Y> S = filter == Filter::tension ? Mats<Y>() : zero_matrices<Y>();
};

}  // namespace extremes
