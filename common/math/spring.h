// A spring between two vertices: the smallest condition, and the cloth of mass-spring models.
#pragma once
#include <optional>
#include <vector>

#include "math/condition.h"

// y = x_0 − x_1, the only vector that a spring reads.
struct Spring : Element<2, 1> {
  double rest_length;     // m
  double sqrt_share = 1;  // √s, where s k is the stiffness of this spring
};

inline Spring make_spring(int i, int j, double rest_length, double share = 1) {
  Spring s;
  s.vertices = {i, j};
  s.weight << 1, -1;
  s.rest_length = rest_length;
  s.sqrt_share = std::sqrt(share);
  return s;
}

//   C = √s (|y| − L),   ∂C/∂y = √s n,   n = y/|y|,   E = s k/2 (|y| − L)²
inline Condition<1> elongation(const Spring& s, const Vec3& y) {
  const Length length(y);
  return {s.sqrt_share * (length.value - s.rest_length), {s.sqrt_share * length.n}, 0, true};
}

// ∂²C/∂y² = √s (I − n nᵀ)/|y|
inline Mats<1> elongation_second(const Spring& s, const Vec3& y) {
  return {{{s.sqrt_share * Length(y).second_derivative()}}};
}

// The springs of a cloth.
struct Springs {
  static constexpr int N = 2, Y = 1;
  std::vector<Spring> elements;
  std::optional<Term> spring;

  template <class Act>
  void conditions(const Spring& s, const Vecs<1>& y, const Act& act) const {
    if (spring) act(*spring, elongation(s, y[0]), [&] { return elongation_second(s, y[0]); });
  }
};
