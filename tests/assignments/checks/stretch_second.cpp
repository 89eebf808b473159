#include "assignments/checks/check.h"
#include "math/triangle.h"

namespace {

TEST(StretchSecond, IsTheSlopeOfTheGradient) {
  Random random(seed());
  for (const Pose pose : all_poses) {
    const Triangle t = make_triangle(random_rest(random));
    const Vecs<2> w = pose_w(pose, random);
    for (int m = 0; m < 2; ++m) {
      const auto gradient = [&](const VecX& w_m) -> VecX {
        Vecs<2> moved = w;
        moved[m] = w_m;
        return Stretch(t, moved, m).dCdy[0];
      };
      const MatX expected = slope_of(gradient, w[m], 1e-3 * w[m].norm());
      AGREES(std::string("∂²C/∂w² of a triangle in the pose ") + name(pose),
             Stretch(t, w, m).second()[0][0], expected, 1e-7 * expected.norm() + 1e-9);
    }
  }
}

TEST(StretchSecond, IsZeroAlongTheThread) {
  Random random(seed() + 1);
  const Triangle t = make_triangle(random_rest(random));
  const Vecs<2> w = pose_w(Pose::random, random);
  AGREES("∂²C/∂w² times the direction of w: pulling a thread does not turn it",
         Stretch(t, w, 0).second()[0][0] * w[0].normalized(), VecX::Zero(3), 1e-9);
}

}  // namespace
