// [oblique_thread]: one more thread in every triangle, at the angle φ = thread_angle to the threads along u.
//
//   w_φ = cos φ w_u + sin φ w_v,        C = √a (|w_φ| − 1)
//
// a is the area of the triangle at rest, m². Your angle stands in oblique_thread_numbers.h.
#pragma once
#include "inventions/oblique_thread_numbers.h"
#include "math/triangle.h"

struct ObliqueThread : Condition<2> {
  // C, and in dCdy its derivatives by w_u and by w_v.
  ObliqueThread(const Triangle& t, const Vecs<2>& w_) : sqrt_area(t.sqrt_area), w(w_) {
    not_written("D1.2", "ObliqueThread::ObliqueThread");
  }

  // The four blocks ∂²C/∂w_m∂w_n
  Mats<2> second() const { not_written("D1.2", "ObliqueThread::second"); }

  // The four numbers nᵀ ∂²C/∂w_m∂w_n n with the normal n of the triangle: see math/tension.h
  Square<2> across() const { not_written("D1.2", "ObliqueThread::across"); }

  double sqrt_area;  // m
  Vecs<2> w;
};

struct ObliqueThreadTerm : Term {
  using Term::Term;
  static constexpr TermInfo info = {.table = "oblique_thread"};

  template <class Act>
  void conditions(const Triangle& t, const Vecs<2>& w, const Act& act) const {
    act(*this, ObliqueThread(t, w));
  }
};
