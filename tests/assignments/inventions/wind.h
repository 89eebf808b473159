// Wind: the air resists what moves through it across the cloth, and lets pass what slides along it.
//
// Each triangle has the area A, m², and the unit normal n now, and the mean v̄, m/s, of the velocities of its
// vertices. The force on it, N, of which each vertex gets a third:
//
//   −wind_drag A (n·(v̄ − wind)) n
//
// A triangle that is a line has no area, and no force. Your wind_drag, kg/(m²·s), stands in wind_numbers.h.
#pragma once
#include "inventions/wind_numbers.h"
#include "math/cloth.h"

// f, N, grows by the force of a wind of the velocity `wind`, m/s.
inline void add_wind(const Cloth& cloth, const State& state, const Vec3& wind, VecX& f) {
  not_written("D2.1", "add_wind");
}
