#include "assignments/checks/check.h"
#include "math/triangle.h"

namespace {

// Half a square metre, with u and v along x and y.
Triangle half_a_square() {
  return make_triangle({0, 1, 2}, {0, 0}, {1, 0}, {0, 1});
}

TEST(Stretch, IsZeroAtRest) {
  const Vecs<2> w = {Vec3::UnitX(), Vec3::UnitY()};
  for (int m = 0; m < 2; ++m)
    AGREES("C of a thread as long as it was woven", Stretch(half_a_square(), w, m).C, 0, 1e-12);
}

TEST(Stretch, IsTheRootOfTheAreaTimesTheStretch) {
  const Vecs<2> w = {1.5 * Vec3::UnitZ(), 0.8 * Vec3::UnitY()};
  AGREES("C of the thread w_u, 1.5 times as long, of a triangle of 0.5 m²",
         Stretch(half_a_square(), w, 0).C, 0.353553391, 1e-8);
  AGREES("C of the thread w_v, 0.8 times as long, of a triangle of 0.5 m²",
         Stretch(half_a_square(), w, 1).C, -0.141421356, 1e-8);
  AGREES("C of the same thread, if its rest length is b = 0.8",
         Stretch(half_a_square(), w, 1, 0.8).C, 0, 1e-12);
}

TEST(Stretch, ReadsItsOwnThread) {
  const Vecs<2> w = {1.5 * Vec3::UnitZ(), 0.8 * Vec3::UnitY()};
  for (int m = 0; m < 2; ++m)
    AGREES("`first`, the number of the thread that C reads", Stretch(half_a_square(), w, m).first,
           m, 0);
}

TEST(Stretch, GradientIsTheSlopeOfC) {
  Random random(seed());
  for (const Pose pose : all_poses) {
    const Triangle t = make_triangle(random_rest(random));
    const Vecs<2> w = pose_w(pose, random);
    const auto C = [&](const VecX& w_u) {
      return one_number(Stretch(t, {Vec3(w_u), w[1]}, 0, 0.9).C);
    };
    const VecX got = Stretch(t, w, 0, 0.9).dCdy[0];
    const MatX expected = slope_of(C, w[0], 1e-3 * w[0].norm()).transpose();
    AGREES(std::string("∂C/∂w_u of a triangle in the pose ") + name(pose), got, expected, 1e-8);
  }
}

}  // namespace
