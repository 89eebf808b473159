// A spring between two vertices: the smallest condition, and the cloth of mass-spring models.
#pragma once
#include "math/family.h"

// y = x_0 − x_1, the only vector that a spring reads.
struct Spring : Element<2, 1> {
  static constexpr std::string_view plural = "springs";
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
//
// The length is smoothed as that of a thread. A spring without length at rest takes 1 m for it.
struct Elongation : Condition<1> {
  Elongation(const Spring& s, const Vec3& y)
      : sqrt_share(s.sqrt_share), length(y, s.rest_length > 0 ? s.rest_length : 1) {
    C = sqrt_share * (length.value - s.rest_length);
    dCdy = {sqrt_share * length.n};
  }

  // ∂²C/∂y² = √s (I − n nᵀ)/|y|
  Mats<1> second() const { return {{{sqrt_share * length.second_derivative()}}}; }
  Square<1> across() const { return Square<1>::Ones(); }

  double sqrt_share;
  Length length;
};

// P = ∂²C/∂y²: all of it acts across the spring (math/tension.h).
inline Mat3 across(const Spring& s, const Vecs<1>& y) {
  return Elongation(s, y[0]).second()[0][0];
}

// The springs that are the cloth itself. Code builds them; no scene names them.
struct SpringTerm : Term {
  using Term::Term;
  static constexpr TermInfo info = {.table = "spring", .first_step = 0};

  template <class Act>
  void conditions(const Spring& s, const Vecs<1>& y, const Act& act) const {
    act(*this, Elongation(s, y[0]));
  }
};

// [bend] model = "springs": between opposite vertices of two triangles, with hardly any resistance to
// small folds. They have no bending modulus: their energy grows with κ⁴.
struct SpringBend : Term {
  using Term::Term;
  static constexpr TermInfo info = {
      .table = "bend", .model = "springs", .first_step = 5, .rests_flat = true};

  template <class Act>
  void conditions(const Spring& s, const Vecs<1>& y, const Act& act) const {
    act(*this, Elongation(s, y[0]));
  }
};
