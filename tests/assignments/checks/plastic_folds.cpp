#include "inventions/plastic_folds.h"
#include "assignments/checks/check.h"

namespace {

// Two triangles with the edge along y, folded by θ, and turned in space.
VecX folded(double theta, const Mat3& R = Mat3::Identity()) {
  VecX x(12);
  x << -1, 0.4, 0, 0, 0, 0, 0, 1, 0, std::cos(theta), 0.6, -std::sin(theta);
  return moved(x, R, Vec3(1, 2, 3));
}

// A hinge that followed the fold to θ, and rests at θ0.
Hinge hinge(double theta, double rest_angle) {
  Hinge h;
  h.vertices = {0, 1, 2, 3};
  h.theta = theta, h.rest_angle = rest_angle;
  return h;
}

// θ0 after the fold yielded.
double rest_angle_after(double theta, double rest_angle, const Mat3& R = Mat3::Identity()) {
  std::array<Hinge, 1> one = {hinge(theta, rest_angle)};
  yield_folds(one, folded(theta, R));
  return one[0].rest_angle;
}

std::string shown(double theta, double rest_angle) {
  return "θ0 after a fold by θ = " + std::to_string(theta) +
         " with θ0 = " + std::to_string(rest_angle);
}

TEST(PlasticFolds, StayBelowTheYieldAngle) {
  for (const double share : {-0.99, -0.5, 0.0, 0.5, 0.99})
    for (const double rest_angle : {-1.0, 0.0, 0.7}) {
      const double theta = rest_angle + share * yield_angle;
      AGREES(shown(theta, rest_angle) + ", which is below the yield angle",
             rest_angle_after(theta, rest_angle), rest_angle, 0);
    }
}

TEST(PlasticFolds, YieldUntilTheAngleIsTheYieldAngle) {
  Random random(seed());
  for (int i = 0; i < 20; ++i) {
    const double rest_angle = random.between(-1, 1), side = i % 2 ? 1 : -1;
    const double theta = rest_angle + side * (yield_angle + random.between(0.01, 1));
    AGREES(shown(theta, rest_angle), rest_angle_after(theta, rest_angle, random.rotation()),
           theta - side * yield_angle, 1e-9);
  }
}

TEST(PlasticFolds, DoNotYieldTwice) {
  const double once = rest_angle_after(2, 0);
  AGREES("θ0 after the same fold yielded again", rest_angle_after(2, once), once, 1e-9);
}

TEST(PlasticFolds, GainNoEnergy) {
  Random random(seed() + 1);
  for (int i = 0; i < 20; ++i) {
    const double theta = random.between(-3, 3), rest_angle = random.between(-3, 3);
    std::array<Hinge, 1> one = {hinge(theta, rest_angle)};
    const VecX x = folded(theta);
    const double before = std::abs(Dihedral(one[0], gather(one[0], x)).C);
    yield_folds(one, x);
    const double after = std::abs(Dihedral(one[0], gather(one[0], x)).C);
    HOLDS("|C| of a fold grew from " + std::to_string(before) + " to " + std::to_string(after) +
              ", and with it the energy k/2 C²",
          after <= before + 1e-12);
  }
}

// A fold by 3.3 looks like one by 3.3 − 2π. The hinge stores θ, so that the two differ.
TEST(PlasticFolds, FollowAFoldBeyondPi) {
  AGREES(shown(3.3, 0) + ", beyond π: `angle` in math/hinge.h knows it", rest_angle_after(3.3, 0),
         3.3 - yield_angle, 1e-9);
}

TEST(PlasticFolds, KeepTheAngleOfALine) {
  std::array<Hinge, 1> one = {hinge(0.1 * yield_angle, 0)};
  VecX line(12);
  line << 0, 0.4, 0, 0, 0, 0, 0, 1, 0, 0, 0.6, 0;
  yield_folds(one, line);
  AGREES("θ0 of a hinge whose triangles are lines, and whose stored θ is below the yield angle",
         one[0].rest_angle, 0, 0);
}

TEST(PlasticFolds, YieldEachByItself) {
  std::array<Hinge, 2> two = {hinge(0.5 * yield_angle, 0), hinge(2, 0)};
  two[1].vertices = {4, 5, 6, 7};
  VecX x(24);
  x << folded(0.5 * yield_angle), folded(2);
  yield_folds(two, x);
  AGREES("θ0 of the first of two hinges, which is below the yield angle", two[0].rest_angle, 0, 0);
  AGREES("θ0 of the second of two hinges, which is beyond it", two[1].rest_angle, 2 - yield_angle,
         1e-9);
}

}  // namespace
