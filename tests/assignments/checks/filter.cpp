#include "assignments/checks/check.h"
#include "assignments/checks/cloths.h"
#include "step04_cg/time_step.h"

namespace {

const Vec3 p = Vec3(1, 2, 2) / 3;  // the direction that the slider holds

// Vertex 0 is held, vertex 3 slides in the plane that is perpendicular to p.
SmallCloth pinned() {
  SmallCloth small(2);
  small.hold(Pin(0));
  small.hold(Pin(3, Mat3::Identity() - p * p.transpose()));
  return small;
}

VecX filtered(VecX r) {
  step04::filter(pinned().cloth, r);
  return r;
}

TEST(Filter, RemovesAllOfAHeldVertex) {
  Random random(seed());
  AGREES("the residual of vertex 0, which is held", filtered(random.vector(27, 1)).head<3>(),
         VecX::Zero(3), 0);
}

TEST(Filter, LeavesTheFreeDirectionsOfASlider) {
  Random random(seed() + 1);
  const VecX r = random.vector(27, 1);
  const Vec3 before = r.segment<3>(9), after = filtered(r).segment<3>(9);
  AGREES("the part of r along the direction that the slider holds", after.dot(p), 0, 1e-12);
  AGREES("the part of r across it", VecX(after), VecX(before - p * p.dot(before)), 1e-12);
}

TEST(Filter, LeavesFreeVerticesAlone) {
  Random random(seed() + 2);
  const VecX r = random.vector(27, 1), f = filtered(r);
  for (const int i : {1, 2, 4, 5, 6, 7, 8})
    AGREES("the residual of vertex " + std::to_string(i) + ", which is free", f.segment<3>(3 * i),
           r.segment<3>(3 * i), 0);
}

}  // namespace
