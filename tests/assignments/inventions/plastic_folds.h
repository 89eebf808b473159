// Plastic folds: a hinge that is bent too far keeps a crease. C = θ − θ0 is the angle beyond the rest angle.
//
//   |θ − θ0| ≤ yield_angle      θ0 stays
//   |θ − θ0| > yield_angle      θ0 moves towards θ, until |θ − θ0| = yield_angle
//
// θ may lie beyond ±π, where a fold is swept through: see math/hinge.h. Your yield_angle, rad, stands in
// plastic_folds_numbers.h.
#pragma once
#include "inventions/plastic_folds_numbers.h"
#include "math/hinge.h"

// Moves the rest_angle of the hinges that yield at the positions x.
inline void yield_folds(std::span<Hinge> hinges, const VecX& x) {
  not_written("D5.1", "yield_folds");
}
