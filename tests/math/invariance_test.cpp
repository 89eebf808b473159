// What no condition may notice, and what every element owes to Newton's third law: rigid motion
// costs nothing, forces inside an element add up to no force and no torque, and they turn with the
// cloth.
#include <gtest/gtest.h>
#include <Eigen/Eigenvalues>

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

// In double precision a place 1000 m away has the grain 1e-13 m, and C feels the grain times
// weight.
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

TEST_P(EveryPose, NoNetForceAndNoNetTorque) {
  Random random(23);
  for (int i = 0; i < 50; ++i) {
    const Rest rest = random_rest(random);
    const VecX x = positions(rest, pose_w(GetParam(), random), random.vector(3, 1));
    const VecX f = forces(one_triangle(make_triangle(rest), k_stretch, k_shear), x);
    Vec3 force = Vec3::Zero(), torque = Vec3::Zero();
    for (int v = 0; v < 9; v += 3) {
      force += f.segment<3>(v);
      torque += x.segment<3>(v).cross(f.segment<3>(v));
    }
    EXPECT_LT(force.norm(), 1e-15 * f.norm()) << "triangle " << i;
    EXPECT_LT(torque.norm(), 1e-14 * f.norm()) << "triangle " << i;
    EXPECT_GT(f.norm(), 1e-6) << "triangle " << i << " shows nothing";
  }
}

// f(R x + t) = R f(x)
TEST_P(EveryPose, ForcesTurnWithTheCloth) {
  Random random(24);
  for (int i = 0; i < 50; ++i) {
    const Rest rest = random_rest(random);
    const Triangle t = make_triangle(rest);
    const VecX x = positions(rest, pose_w(GetParam(), random), Vec3::Zero());
    const Cloth cloth = one_triangle(t, k_stretch, k_shear);
    const Mat3 R = random.rotation();
    const VecX turned_forces = moved(forces(cloth, x), R, Vec3::Zero());
    const VecX forces_turned = forces(cloth, moved(x, R, random.vector(3, 1)));
    // Rounding of x, 1e-15, turns a thread of length |w| by 1e-15 · weight/|w|.
    const double shortest = GetParam() == Pose::collapsed ? 1e-3 : 0.3;
    EXPECT_LT((turned_forces - forces_turned).norm(),
              1e-14 * largest_weight(t) / shortest * turned_forces.norm())
        << "triangle " << i;
  }
}

// Winding and order of the vertices are only names.
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

// The right angle between a positive area and a number that may have a sign: a clockwise rest
// triangle.
TEST(Element, AreaIsPositiveWhicheverWayTheTriangleIsListed) {
  const Vec2 a(0, 0), b(3, 0), c(0, 4);
  EXPECT_DOUBLE_EQ(make_triangle({0, 1, 2}, a, b, c).area, 6);
  EXPECT_DOUBLE_EQ(make_triangle({0, 1, 2}, a, c, b).area, 6);
  EXPECT_DOUBLE_EQ(make_triangle({0, 1, 2}, a, c, b).sqrt_area, std::sqrt(6));
}

// The blocks of a second derivative as one matrix.
template <class Blocks>
Eigen::MatrixXd matrix(const Blocks& blocks) {
  const auto size = Eigen::Index(blocks.size());
  Eigen::MatrixXd all(3 * size, 3 * size);
  for (Eigen::Index m = 0; m < size; ++m)
    for (Eigen::Index n = 0; n < size; ++n)
      all.block<3, 3>(3 * m, 3 * n) = blocks[size_t(m)][size_t(n)];
  return all;
}

TEST_P(EveryPose, SecondDerivativeOfStretchIsSymmetricAndConvex) {
  Random random(27);
  for (int i = 0; i < 50; ++i)
    for (const int m : {0, 1}) {
      const Triangle t = make_triangle(random_rest(random));
      const Vecs<2> w = pose_w(GetParam(), random);
      const Mat3 H = matrix(Stretch(t, w, m).second());
      const double bend =
          t.sqrt_area / w[size_t(m)].norm();  // the two eigenvalues across the thread
      EXPECT_EQ(H, H.transpose().eval());
      const Vec3 eigenvalues = Eigen::SelfAdjointEigenSolver<Mat3>(H).eigenvalues();
      EXPECT_LT((eigenvalues - Vec3(0, bend, bend)).norm(), 1e-11 * bend)
          << eigenvalues.transpose();
      EXPECT_TRUE(Stretch(t, w, m).convex);
    }
}

TEST_P(EveryPose, SecondDerivativeOfASpringIsSymmetricAndConvex) {
  Random random(28);
  for (int i = 0; i < 50; ++i) {
    const Vec3 y = pose_w(GetParam(), random)[0];
    const Spring s = make_spring(0, 1, 0.5, 0.25);
    const Mat3 H = matrix(Elongation(s, y).second());
    const double bend = 0.5 / y.norm();
    EXPECT_EQ(H, H.transpose().eval());
    const Vec3 eigenvalues = Eigen::SelfAdjointEigenSolver<Mat3>(H).eigenvalues();
    EXPECT_LT((eigenvalues - Vec3(0, bend, bend)).norm(), 1e-11 * bend) << eigenvalues.transpose();
    EXPECT_TRUE(Elongation(s, y).convex);
  }
}

// ±√a three times each, wherever w is: half of all directions are against shear's second
// derivative.
TEST(Shear, SecondDerivativeIsSymmetricAndNotConvex) {
  Random random(29);
  for (int i = 0; i < 50; ++i) {
    const Triangle t = make_triangle(random_rest(random));
    const Eigen::Matrix<double, 6, 6> H = matrix(Shear(t, zero_vectors<2>()).second());
    EXPECT_EQ(H, H.transpose().eval());
    Eigen::Matrix<double, 6, 1> expected;
    expected << -1, -1, -1, 1, 1, 1;
    const Eigen::Matrix<double, 6, 1> eigenvalues =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>>(H).eigenvalues();
    EXPECT_LT((eigenvalues - t.sqrt_area * expected).norm(), 1e-14 * t.sqrt_area);
    EXPECT_FALSE(Shear(t, {Vec3::UnitX(), random.direction()}).convex);
  }
}

}  // namespace invariance_test
