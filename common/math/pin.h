// A pin holds a vertex in three, two or one direction.
#pragma once
#include <span>

#include "math/types.h"

struct Pin {
  Pin(int vertex_, const Mat3& S_ = Mat3::Zero(), const Vec3& velocity_ = Vec3::Zero())
      : vertex(vertex_), S(S_), velocity(velocity_) {}

  bool holds_all() const { return S.isZero(0); }
  bool moves() const { return !velocity.isZero(0); }
  // The velocity of a vertex with the velocity v, once the pin holds it.
  Vec3 held(const Vec3& v) const { return velocity + S * (v - velocity); }

  int vertex;
  Mat3 S;         // I − Σ d dᵀ over the directions d that it holds: what it leaves free
  Vec3 velocity;  // m/s, in the directions that it holds
};

// The velocity u, m/s, of a rigid cloth that would move with v but has pins: of all u that follow the pins as
// well as possible in the directions that they hold, Σ |(I − S)(u − velocity)|² → min, the one nearest to v.
Vec3 led_by(std::span<const Pin> pins, const Vec3& v);
