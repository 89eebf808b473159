// A cloth at rest, moved and rotated as a rigid body, is still at rest, however far away. Forces do not
// depend on how vertices are numbered.
#include <gtest/gtest.h>

#include "support/energy.h"
#include "support/poses.h"

namespace invariance_test {

constexpr double k_stretch = 7, k_shear = 3;

double largest_weight(const Triangle& t) {
  return t.weight.cwiseAbs().maxCoeff();
}

class EveryPose : public testing::TestWithParam<Pose> {};
INSTANTIATE_TEST_SUITE_P(Triangle, EveryPose, testing::ValuesIn(all_poses),
                         [](const auto& pose) { return std::string(name(pose.param)); });

// Positions 1000 m away are rounded to 1e-13 m. The error of C is that rounding times the weight.
TEST(Invariance, RigidMotionCostsNothing) {
  Random random(21);
  for (const double distance : {0.0, 1.0, 1000.0})
    for (int i = 0; i < 50; ++i) {
      const Rest rest = random_rest(random);
      const Triangle t = make_triangle(rest);
      const VecX laid_out = positions(rest, {Vec3::UnitX(), Vec3::UnitY()}, Vec3::Zero());
      const VecX x = moved(laid_out, random.rotation(), random.vector(3, distance));
      const Cloth cloth = one_triangle(t, k_stretch, k_shear);
      const double grain = 1e-15 * (4 + distance), C = 4 * grain * largest_weight(t);
      EXPECT_LT(potential_energy(cloth, x), (k_stretch + k_shear) * t.area * C * C)
          << distance << " m away";
      EXPECT_LT(forces(cloth, x).norm(), 4 * (k_stretch + k_shear) * t.area * C * largest_weight(t))
          << distance << " m away";
    }
}

TEST(Invariance, RigidMotionOfASpringCostsNothing) {
  Random random(22);
  for (const double distance : {0.0, 1.0, 1000.0})
    for (int i = 0; i < 50; ++i) {
      VecX laid_out = VecX::Zero(6);
      laid_out[3] = 0.7;
      const VecX x = moved(laid_out, random.rotation(), random.vector(3, distance));
      const Cloth cloth = one_spring(make_spring(0, 1, 0.7), 11);
      const double grain = 1e-15 * (1 + distance);
      EXPECT_LT(potential_energy(cloth, x), 11 * grain * grain) << distance << " m away";
      EXPECT_LT(forces(cloth, x).norm(), 4 * 11 * grain) << distance << " m away";
    }
}

// The winding and the order of the vertices change nothing.
TEST_P(EveryPose, ForcesDoNotDependOnTheOrderOfTheVertices) {
  Random random(25);
  for (int i = 0; i < 50; ++i) {
    const Rest rest = random_rest(random);
    const VecX x = positions(rest, pose_w(GetParam(), random), Vec3::Zero());
    const VecX f = forces(one_triangle(make_triangle(rest), k_stretch, k_shear), x);
    for (const Face& order : {Face{1, 2, 0}, Face{2, 0, 1}, Face{0, 2, 1}, Face{2, 1, 0}}) {
      const Triangle same = make_triangle(order, rest[size_t(order[0])], rest[size_t(order[1])],
                                          rest[size_t(order[2])]);
      EXPECT_GT(same.area, 0);
      const double shortest = GetParam() == Pose::collapsed ? 1e-3 : 0.3;
      EXPECT_LT((forces(one_triangle(same, k_stretch, k_shear), x) - f).norm(),
                1e-14 * largest_weight(same) / shortest * f.norm())
          << "triangle " << i << ", order " << order[0] << order[1] << order[2];
    }
  }
}

TEST(Element, WeightsOfEachThreadAddUpToZero) {
  Random random(26);
  for (int i = 0; i < 50; ++i) {
    const Triangle t = make_triangle(random_rest(random));
    EXPECT_LT(t.weight.rowwise().sum().cwiseAbs().maxCoeff(), 1e-15 * largest_weight(t));
  }
  EXPECT_EQ(make_spring(0, 1, 1).weight.sum(), 0);
}

// Vertex 0 gets minus the sum of the other forces.
TEST(Element, ScatteredForcesAddUpToZero) {
  Random random(23);
  for (int i = 0; i < 50; ++i) {
    VecX f = VecX::Zero(9);
    scatter(make_triangle(random_rest(random)), {random.vector(3, 7), random.vector(3, 7)}, f);
    EXPECT_LT((f.head<3>() + f.segment<3>(3) + f.tail<3>()).norm(), 1e-15 * f.norm());
    EXPECT_GT(f.norm(), 1e-6);
  }
}

// The area of a clockwise rest triangle is positive, too.
TEST(Element, AreaIsPositiveWhicheverWayTheTriangleIsListed) {
  const Vec2 a(0, 0), b(3, 0), c(0, 4);
  EXPECT_DOUBLE_EQ(make_triangle({0, 1, 2}, a, b, c).area, 6);
  EXPECT_DOUBLE_EQ(make_triangle({0, 1, 2}, a, c, b).area, 6);
  EXPECT_DOUBLE_EQ(make_triangle({0, 1, 2}, a, c, b).sqrt_area, std::sqrt(6));
}

}  // namespace invariance_test
