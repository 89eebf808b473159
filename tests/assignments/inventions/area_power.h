// [area_power]: the area of a triangle, measured by a power of it.
//
//   J = |w_u × w_v|,        C = √a (J^p − 1)/p,        p = area_power
//
// a is the area of the triangle at rest, m², and J the area now divided by it. Your power p stands in
// area_power_numbers.h.
#pragma once
#include "inventions/area_power_numbers.h"
#include "math/triangle.h"

struct AreaPower : Condition<2> {
  // C, and in dCdy its derivatives by w_u and by w_v.
  AreaPower(const Triangle& t, const Vecs<2>& w_) : sqrt_area(t.sqrt_area), w(w_) {
    not_written("D1.3", "AreaPower::AreaPower");
  }

  // The four blocks ∂²C/∂w_m∂w_n
  Mats<2> second() const { not_written("D1.3", "AreaPower::second"); }

  // The four numbers nᵀ ∂²C/∂w_m∂w_n n with the normal n of the triangle: see math/tension.h
  Square<2> across() const { not_written("D1.3", "AreaPower::across"); }

  double sqrt_area;  // m
  Vecs<2> w;
};

struct AreaPowerTerm : Term {
  using Term::Term;
  static constexpr TermInfo info = {.table = "area_power"};

  template <class Act>
  void conditions(const Triangle& t, const Vecs<2>& w, const Act& act) const {
    act(*this, AreaPower(t, w));
  }
};
