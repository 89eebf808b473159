// A mass of 1 kg on a spring of 1 N/m, so that ω = 1/s, for the figures of vibrations. The mass moves along x.
#pragma once
#include "math/cloth.h"

namespace figures {

inline constexpr double rest_length = 10;  // m

// Vertex 0 is pinned. The damping ratio is ζ = kd ω/(2 k), so that kd = 2 ζ N·s/m.
inline Cloth mass_on_a_spring(double zeta = 0) {
  Cloth cloth;
  cloth.mass = VecX::Ones(6);
  cloth.inverse_mass = VecX::Ones(6);
  cloth.inverse_mass.head<3>().setZero();
  cloth.springs.elements = {make_spring(0, 1, rest_length)};
  cloth.term<SpringTerm>() = SpringTerm(1, 2 * zeta);
  return cloth;
}

// x: how much the spring is too long, m; v: its rate, m/s.
inline State moved(double x, double v) {
  State state{VecX::Zero(6), VecX::Zero(6)};
  state.x[3] = rest_length + x;
  state.v[3] = v;
  return state;
}

inline double x_of(const State& state) {
  return state.x[3] - rest_length;
}
inline double v_of(const State& state) {
  return state.v[3];
}

}  // namespace figures
