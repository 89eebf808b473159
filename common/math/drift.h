// Standing still: the motion against which an implicit step is measured, and from which Newton's method
// begins.
#pragma once
#include "math/cloth.h"

// z, m/s: the cloth moves as a whole and does not deform. A vertex has the velocity of its pin in the
// directions that the pin holds. The rest of z is one velocity for the whole cloth: the mean of what the
// pins hold or, without pins, the mean of v by mass,
//
//   v̄ = Σ m v / Σ m
//
// and v̄ too in directions in which a pin slides. So z moves with the frame: the same cloth, seen from a
// moving train, takes the same step.
inline void stand_still(const Cloth& cloth, const VecX& v, VecX& z) {
  Vec3 momentum = Vec3::Zero();
  double mass = 0;
  for (int i = 0; i < cloth.vertices(); ++i) {
    momentum += cloth.mass[3 * i] * v.segment<3>(3 * i);
    mass += cloth.mass[3 * i];
  }
  const auto held = [](const Pin& pin, const Vec3& free) {
    return Vec3(pin.velocity + pin.S * (free - pin.velocity));
  };
  Vec3 drift = momentum / mass;
  if (!cloth.pins.empty()) {
    Vec3 sum = Vec3::Zero();
    for (const Pin& pin : cloth.pins) sum += held(pin, drift);
    drift = sum / double(cloth.pins.size());
  }
  for (int i = 0; i < cloth.vertices(); ++i) z.segment<3>(3 * i) = drift;
  for (const Pin& pin : cloth.pins) z.segment<3>(3 * pin.vertex) = held(pin, drift);
}
