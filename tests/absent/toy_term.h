// A term that exists only in the tests of the lists. [toy]: the mean of both threads wants its rest length.
#pragma once
#include "math/triangle.h"

//   C = √a (½ |w_u|² + ½ |w_v|² − 1),   ∂C/∂w = √a w
struct ToyDilation : Condition<2> {
  ToyDilation(const Triangle& t, const Vecs<2>& w) : sqrt_area(t.sqrt_area) {
    C = sqrt_area * (0.5 * w[0].squaredNorm() + 0.5 * w[1].squaredNorm() - 1);
    dCdy = {sqrt_area * w[0], sqrt_area * w[1]};
  }
  Mats<2> second() const {
    const Mat3 O = Mat3::Zero(), I = sqrt_area * Mat3::Identity();
    return {{{I, O}, {O, I}}};
  }
  Square<2> across() const { return sqrt_area * Square<2>::Identity(); }

  double sqrt_area;
};

struct ToyTerm : Term {
  using Term::Term;
  static constexpr TermInfo info = {.table = "toy", .first_step = 3};

  template <class Act>
  void conditions(const Triangle& t, const Vecs<2>& w, const Act& act) const {
    act(*this, ToyDilation(t, w));
  }
};
