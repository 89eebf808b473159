#include "assignments/checks/check.h"
#include "assignments/checks/cloths.h"
#include "step04_cg/time_step.h"

namespace {

const Vec3 p = Vec3(2, 1, 2) / 3;  // the direction that the slider holds
const Vec3 velocity(0.3, -0.2, 0.1);

VecX prescribed(const VecX& v) {
  SmallCloth small(2);
  small.hold(Pin(0, Mat3::Zero(), velocity));
  small.hold(Pin(3, Mat3::Identity() - p * p.transpose(), velocity));
  VecX z = VecX::Constant(27, 99);
  step04::prescribe(small.cloth, v, z);
  return z;
}

TEST(MovingPins, AHeldVertexGetsTheVelocityOfThePin) {
  Random random(seed());
  const VecX v = random.vector(27, 1);
  AGREES("v + z of vertex 0, whose pin moves", VecX(v.head<3>() + prescribed(v).head<3>()),
         VecX(velocity), 1e-12);
}

TEST(MovingPins, ASliderIsMovedOnlyAlongTheDirectionThatItHolds) {
  Random random(seed() + 1);
  const VecX v = random.vector(27, 1);
  const Vec3 z = prescribed(v).segment<3>(9), after = v.segment<3>(9) + z;
  AGREES("v + z of the slider, along the direction that it holds", after.dot(p), velocity.dot(p),
         1e-12);
  AGREES("z of the slider, across that direction", VecX(z - p * p.dot(z)), VecX::Zero(3), 1e-12);
}

TEST(MovingPins, FreeVerticesAreLeftAlone) {
  Random random(seed() + 2);
  const VecX z = prescribed(random.vector(27, 1));
  for (const int i : {1, 2, 4, 5, 6, 7, 8})
    AGREES("z of vertex " + std::to_string(i) + ", which is free", z.segment<3>(3 * i),
           VecX::Zero(3), 0);
}

}  // namespace
