// Removes the damping of one term at compile time. act() is a template. With an Undamped instead
// of a Term it compiles to a function without kd and all that kd needs: k C + kd Ċ is k C, and
// nothing is subtracted from D.
#pragma once
#include "math/condition.h"

struct Nothing {};
template <class X>
Nothing operator*(Nothing, const X&) {
  return {};
}
inline Mat3 operator*(Nothing, const Mat3&) {
  return Mat3::Zero();
}
inline double operator+(double sum, Nothing) {
  return sum;
}
inline Nothing operator-(Nothing) {
  return {};
}
constexpr bool operator>(Nothing, int) {
  return false;
}

struct Undamped {
  double k;
  static constexpr Nothing kd = {};

  operator Term() const { return Term(k); }  // for functions that ask for its energy
};
inline Undamped undamped(const Term& term) {
  return {term.k};
}
