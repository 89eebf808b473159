#include "assignments/checks/check.h"
#include "math/angle.h"

namespace {

// Four vertices of a hinge, with flaps that are no lines.
Vecs<4> random_fold(Random& random) {
  Vecs<4> p;
  do
    for (Vec3& point : p) point = random.vector(3, 1);
  while (!has_angle(p, 0.2) || std::abs(angle(p)) > 3);
  return p;
}

TEST(Levers, AddUpToZero) {
  Random random(seed());
  for (int i = 0; i < 20; ++i) {
    const Corners a = levers(make_fold(random_fold(random))[0]);
    AGREES("a_0 + a_1 + a_2, the net force of a hinge", a[0] + a[1] + a[2], 0, 1e-9);
  }
}

// A right angle at P1, and flaps 2 m high on an edge of 1 m.
TEST(Levers, OfAFlapByHand) {
  const Corners a = levers(make_flap(Vec3(-2, 0, 0), Vec3(0, 0, 0), Vec3(0, 1, 0)));
  Vec3 expected(-0.5, 0.5, 0);  // the height stands on P1: P1 holds all
  AGREES("the levers of a flap, 2 m high, whose height stands on corner 1",
         VecX(Vec3(a[0], a[1], a[2])), expected, 1e-12);
}

TEST(Levers, MakeTheGradientTheSlopeOfTheAngle) {
  Random random(seed() + 1);
  for (int i = 0; i < 20; ++i) {
    const Vecs<4> p = random_fold(random);
    const auto theta = [](const VecX& x) { return one_number(angle(split<4>(x))); };
    AGREES("∂θ/∂x of a random fold", joined(angle_gradient(make_fold(p))),
           slope_of(theta, joined(p), 1e-3).transpose(), 1e-5);
  }
}

TEST(Levers, HaveNoTorque) {
  Random random(seed() + 2);
  const Vecs<4> p = random_fold(random), f = angle_gradient(make_fold(p));
  Vec3 torque = Vec3::Zero();
  for (int i = 0; i < 4; ++i) torque += p[i].cross(f[i]);
  AGREES("the net torque Σ x_i × ∂θ/∂x_i", VecX(torque), VecX::Zero(3), 1e-9);
}

}  // namespace
