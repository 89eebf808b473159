// [cosine_shear]: shear as the cosine of the angle α between the threads, however long they are. The cloth is
// woven askew: at rest cos α is rest_cosine.
//
//   C = √a (cos α − rest_cosine),        cos α = w_u·w_v / (|w_u| |w_v|)
//
// a is the area of the triangle at rest, m². Your rest_cosine stands in cosine_shear_numbers.h.
#pragma once
#include "inventions/cosine_shear_numbers.h"
#include "math/triangle.h"

struct CosineShear : Condition<2> {
  // C, and in dCdy its derivatives by w_u and by w_v.
  CosineShear(const Triangle& t, const Vecs<2>& w_) : sqrt_area(t.sqrt_area), w(w_) {
    not_written("D3.1", "CosineShear::CosineShear");
  }

  // The four blocks ∂²C/∂w_m∂w_n
  Mats<2> second() const { not_written("D3.1", "CosineShear::second"); }

  // The four numbers nᵀ ∂²C/∂w_m∂w_n n with the normal n of the triangle: see math/tension.h
  Square<2> across() const { not_written("D3.1", "CosineShear::across"); }

  double sqrt_area;  // m
  Vecs<2> w;
};

struct CosineShearTerm : Term {
  using Term::Term;
  static constexpr TermInfo info = {.table = "cosine_shear"};

  template <class Act>
  void conditions(const Triangle& t, const Vecs<2>& w, const Act& act) const {
    act(*this, CosineShear(t, w));
  }
};
