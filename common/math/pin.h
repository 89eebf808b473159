// A pin holds a vertex in three, two or one direction.
#pragma once
#include "math/types.h"

struct Pin {
  Pin(int vertex_, const Mat3& S_ = Mat3::Zero(), const Vec3& velocity_ = Vec3::Zero())
      : vertex(vertex_), S(S_), velocity(velocity_) {}

  bool holds_all() const { return S.isZero(0); }
  bool moves() const { return !velocity.isZero(0); }

  int vertex;
  Mat3 S;         // I − Σ p pᵀ over the directions p that it holds: what it leaves free
  Vec3 velocity;  // m/s, in the directions that it holds
};
