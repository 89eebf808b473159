#include "inventions/wind.h"
#include "assignments/checks/check.h"
#include "assignments/checks/cloths.h"

namespace {

// A crumpled cloth in a random motion and a random wind.
struct Case {
  explicit Case(Random& random)
      : state{small.x + random.vector(27, 0.1), random.vector(27, 2)}, wind(random.vector(3, 2)) {}
  VecX force(const State& at, const Vec3& blows) const {
    VecX f = VecX::Zero(27);
    add_wind(small.cloth, at, blows, f);
    return f;
  }
  VecX force() const { return force(state, wind); }

  SmallCloth small{2};
  State state;
  Vec3 wind;
};

VecX everywhere(const Vec3& v) {
  return v.replicate(9, 1);
}

// Half a square metre at rest in the plane z = 0, stretched to a whole one.
TEST(Wind, IsTheForceOfTheStatement) {
  Cloth cloth;
  cloth.mass = VecX::Ones(9);
  cloth.triangles.elements = {make_triangle({0, 1, 2}, {0, 0}, {1, 0}, {0, 1})};
  State state{VecX::Zero(9), VecX::Zero(9)};
  state.x << 0, 0, 0, 2, 0, 0, 0, 1, 0;
  state.v[8] = 3;
  VecX f = VecX::Zero(9), expected = VecX::Zero(9);
  add_wind(cloth, state, {5, 0, -1}, f);
  for (const int z : {2, 5, 8}) expected[z] = -wind_drag * 2 / 3;
  AGREES(
      "the force on a triangle of 1 m² across z whose corner 2 moves with (0, 0, 3) m/s, in a "
      "wind of (5, 0, −1) m/s",
      f, expected, 1e-9);
}

TEST(Wind, IsAddedToTheForce) {
  Random random(seed());
  const Case c(random);
  const VecX before = random.vector(27, 1);
  VecX f = before;
  add_wind(c.small.cloth, c.state, c.wind, f);
  AGREES("f after add_wind, minus f before", f - before, c.force(), 1e-9);
}

TEST(Wind, TakesEnergyFromTheMotionAgainstTheAir) {
  Random random(seed() + 1);
  for (int i = 0; i < 20; ++i) {
    const Case c(random);
    const double power = c.force().dot(c.state.v - everywhere(c.wind));
    HOLDS(
        "The force of the wind drives the cloth against the air: its power, for an observer who "
        "moves with the air, is " +
            std::to_string(power) + " W",
        power < 0);
  }
}

TEST(Wind, SeesOnlyTheMotionAgainstTheAir) {
  Random random(seed() + 2);
  const Case c(random);
  const Vec3 train(3, -2, 5);
  AGREES("the force where cloth and wind both move 6 m/s faster",
         c.force({c.state.x, c.state.v + everywhere(train)}, c.wind + train), c.force(), 1e-9);
}

TEST(Wind, TurnsWithTheCloth) {
  Random random(seed() + 3);
  const Case c(random);
  const Mat3 R = random.rotation();
  const State turned{moved(c.state.x, R, Vec3(1, 2, 3)), moved(c.state.v, R, Vec3::Zero())};
  AGREES("the force where cloth, velocities and wind are turned", c.force(turned, R * c.wind),
         moved(c.force(), R, Vec3::Zero()), 1e-9);
}

TEST(Wind, LetsPassWhatSlidesInThePlane) {
  Random random(seed() + 4);
  Case c(random);
  c.state.x = c.small.x;
  for (int z = 2; z < 27; z += 3) c.state.v[z] = 0;
  AGREES("the force on a flat cloth that moves within its plane, in a wind along the plane",
         c.force(c.state, Vec3(2, 1, 0)), VecX::Zero(27), 1e-12);
}

TEST(Wind, DoesNotTouchALine) {
  Random random(seed() + 5);
  Case c(random);
  for (int i = 0; i < 27; i += 3) c.state.x.segment<3>(i) = Vec3(double(i), 0, 0);
  HOLDS(
      "The force on a cloth whose triangles are lines is not a finite number. Such a triangle has "
      "no normal: `across` in math/triangle.h shows what to take",
      c.force().allFinite());
  AGREES("the force on a cloth whose triangles are lines", c.force(), VecX::Zero(27), 1e-9);
}

}  // namespace
