// [strain_limit]: a thread costs nothing until it is longer than the limit.
//
//   C = √a max(0, |w| − strain_limit)        for w = w_u, and for w = w_v
//
// a is the area of the triangle at rest, m². Your limit stands in strain_limit_numbers.h.
#pragma once
#include "inventions/strain_limit_numbers.h"
#include "math/triangle.h"

struct StrainLimit : Condition<1> {
  // The condition of the thread w = threads[m]: its C, its dCdy, and its place `first`.
  StrainLimit(const Triangle& t, const Vecs<2>& threads, int m)
      : sqrt_area(t.sqrt_area), w(threads[m]) {
    not_written("D1.1", "StrainLimit::StrainLimit");
  }

  // ∂²C/∂w²
  Mats<1> second() const { not_written("D1.1", "StrainLimit::second"); }

  // nᵀ ∂²C/∂w² n with the normal n of the triangle: see math/tension.h
  Square<1> across() const { not_written("D1.1", "StrainLimit::across"); }

  double sqrt_area;  // m
  Vec3 w;
};

struct StrainLimitTerm : Term {
  using Term::Term;
  static constexpr TermInfo info = {.table = "strain_limit"};

  // Hands the conditions of a triangle to act(*this, condition).
  template <class Act>
  void conditions(const Triangle& t, const Vecs<2>& w, const Act& act) const {
    not_written("D1.1", "StrainLimitTerm::conditions");
  }
};
