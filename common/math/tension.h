// Tension: what the definite matrix keeps of S = Σ k C ∂²C/∂y², the sum over the conditions of an element.
//
//   ∂²C/∂y_m∂y_n = c_mn P   across the element, in the directions that are perpendicular to every y
//   T_mn = Σ k C c_mn
//   −K   = Σ k ∂C/∂y ∂C/∂yᵀ + T₊ ⊗ P
//
// P has no negative eigenvalues, and T₊ is T without its negative ones. So −K has none either, and
// A = M − h D − h² K is positive definite. A cloth under tension resists whatever pushes it out of its plane.
// Under pressure it buckles, and the matrix lets it.
//
// For a triangle P = n nᵀ with its normal n, and T is its stress, the second Piola–Kirchhoff stress times the
// area, J. A spring is one thread: P = ∂²C/∂y², and T = k C. A condition says its c by across(), an element
// its P by across(element, y). The vertices of a hinge leave no direction across, and quadratic bending is
// linear: they say nothing, and nothing is kept.
#pragma once
#include "math/condition.h"

inline Square<1> positive_part(const Square<1>& T) {
  return T.cwiseMax(0);
}
// With the eigenvalues mean ± r:   T₊ = p I + q (T − mean I)
inline Square<2> positive_part(const Square<2>& T) {
  const double mean = (T(0, 0) + T(1, 1)) / 2, half = (T(0, 0) - T(1, 1)) / 2;
  const double r = std::sqrt(half * half + T(0, 1) * T(0, 1));
  const double high = std::max(mean + r, 0.0), low = std::max(mean - r, 0.0);
  const double p = (high + low) / 2, q = r > 0 ? (high - low) / (2 * r) : 0;
  Square<2> positive;
  positive << p + q * half, q * T(0, 1), q * T(0, 1), p - q * half;
  return positive;
}

// Summed up over the conditions of one element.
template <int Y>
struct Tension {
  // One condition under the load k C.
  template <class Condition>
  void add(double load, const Condition& c) {
    if constexpr (requires { c.across(); })
      T.template block<Condition::M, Condition::M>(c.first, c.first) += load * c.across();
  }
  // K −= T₊ ⊗ P
  template <class Matrix, class Element>
  void subtract_from(Matrix& K, const Element& element, const Vecs<Y>& y) const {
    if constexpr (requires { across(element, y); }) {
      const Square<Y> positive = positive_part(T);
      const Mat3 P = across(element, y);
      for (int m = 0; m < Y; ++m)
        for (int n = m; n < Y; ++n) K.add(m, n, -positive(m, n) * P);
    }
  }

  Square<Y> T = Square<Y>::Zero();
};
