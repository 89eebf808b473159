// The damping of one term, taken out when the program is compiled. act() is written once for all terms;
// handed an Undamped instead of a Term it becomes a function in which kd, and all that is computed only
// for it, does not exist: k C + kd Ċ is k C, and nothing is subtracted from D.
#pragma once
#include "math/condition.h"

struct Nothing {};
template <class X>
Nothing operator*(Nothing, const X&) {
  return {};
}
inline double operator+(double sum, Nothing) {
  return sum;
}
inline void operator-=(Mat3&, Nothing) {}
constexpr bool operator>(Nothing, int) {
  return false;
}

struct Undamped {
  double k;
  static constexpr Nothing kd = {};

  operator Term() const { return Term(k); }  // for whoever asks for its energy
};
inline Undamped undamped(const Term& term) {
  return {term.k};
}
