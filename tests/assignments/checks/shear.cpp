#include "assignments/checks/check.h"
#include "math/triangle.h"

namespace {

Triangle half_a_square(double size) {
  return make_triangle({0, 1, 2}, {0, 0}, {size, 0}, {0, size});
}

TEST(Shear, IsZeroForPerpendicularThreads) {
  AGREES("C of perpendicular threads",
         Shear(half_a_square(1), {1.2 * Vec3::UnitX(), 0.7 * Vec3::UnitZ()}).C, 0, 1e-12);
}

TEST(Shear, IsTheRootOfTheAreaTimesTheProduct) {
  const Vecs<2> w = {Vec3(1, 0, 0), Vec3(0.5, 1, 0)};
  AGREES("C of a triangle of 0.5 m² with w_u·w_v = 0.5", Shear(half_a_square(1), w).C, 0.353553391,
         1e-8);
}

// k/2 C²: of two equal shapes, the larger has as many times the energy as it has the area.
TEST(Shear, EnergyIsProportionalToTheArea) {
  const Vecs<2> w = {Vec3(1, 0, 0), Vec3(0.5, 1, 0)};
  const double small = Shear(half_a_square(1), w).C, large = Shear(half_a_square(3), w).C;
  AGREES("C² of a triangle of 9 times the area, divided by C²", large * large / (small * small), 9,
         1e-9);
}

TEST(Shear, GradientIsTheSlopeOfC) {
  Random random(seed());
  for (const Pose pose : all_poses) {
    const Triangle t = make_triangle(random_rest(random));
    const Vecs<2> w = pose_w(pose, random);
    const auto C = [&](const VecX& y) { return one_number(Shear(t, split<2>(y)).C); };
    AGREES(std::string("∂C/∂(w_u, w_v) of a triangle in the pose ") + name(pose),
           joined(Shear(t, w).dCdy), slope_of(C, joined(w), 1e-3).transpose(), 1e-8);
  }
}

}  // namespace
