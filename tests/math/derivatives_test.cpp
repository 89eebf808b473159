// Conditions: the gradient is the slope of C, the second derivative the slope of the gradient, and
// the force is the falling slope of the energy.
#include "support/differences.h"
#include "support/energy.h"
#include "support/poses.h"

namespace derivatives_test {

constexpr int triangles_per_pose = 20;

VecX flat(const Vecs<2>& w) {
  VecX y(6);
  y << w[0], w[1];
  return y;
}
Vecs<2> unflat(const VecX& y) {
  return {y.head<3>(), y.tail<3>()};
}

VecX one_number(double value) {
  return VecX::Constant(1, value);
}

// A condition of a triangle as functions of all six numbers of (w_u, w_v).
template <class Condition>
MatX gradient(const Condition& c) {
  MatX row = MatX::Zero(1, 6);
  for (size_t m = 0; m < c.dCdy.size(); ++m)
    row.middleCols<3>(3 * (c.first + Eigen::Index(m))) = c.dCdy[m].transpose();
  return row;
}
template <class Blocks>
MatX matrix(const Blocks& blocks, int first = 0) {
  MatX all = MatX::Zero(6, 6);
  for (size_t m = 0; m < blocks.size(); ++m)
    for (size_t n = 0; n < blocks.size(); ++n)
      all.block<3, 3>(3 * (first + Eigen::Index(m)), 3 * (first + Eigen::Index(n))) = blocks[m][n];
  return all;
}

double shortest(const Vecs<2>& w) {
  return std::min(w[0].norm(), w[1].norm());
}

class Derivatives : public testing::TestWithParam<Pose> {};

TEST_P(Derivatives, StretchGradientIsTheSlopeOfC) {
  Random random(1);
  for (int i = 0; i < triangles_per_pose; ++i)
    for (const int m : {0, 1})
      for (const double b : {1.0, 0.7, 1.3}) {
        const Triangle t = make_triangle(random_rest(random));
        const Vecs<2> w = pose_w(GetParam(), random);
        EXPECT_TRUE(
            is_slope([&](const VecX& y) { return one_number(Stretch(t, unflat(y), m, b).C); },
                     [&](const VecX& y) { return gradient(Stretch(t, unflat(y), m, b)); }, flat(w),
                     w[m].norm()))
            << "triangle " << i << ", m = " << m << ", b = " << b;
      }
}

TEST_P(Derivatives, StretchSecondDerivativeIsTheSlopeOfTheGradient) {
  Random random(2);
  for (int i = 0; i < triangles_per_pose; ++i)
    for (const int m : {0, 1})
      for (const double b : {1.0, 0.7}) {
        const Triangle t = make_triangle(random_rest(random));
        const Vecs<2> w = pose_w(GetParam(), random);
        EXPECT_TRUE(is_slope(
            [&](const VecX& y) -> VecX {
              return gradient(Stretch(t, unflat(y), m, b)).transpose();
            },
            [&](const VecX& y) { return matrix(Stretch(t, unflat(y), m).second(), m); }, flat(w),
            w[m].norm()))
            << "triangle " << i << ", m = " << m << ", b = " << b;
      }
}

TEST_P(Derivatives, ShearGradientIsTheSlopeOfC) {
  Random random(3);
  for (int i = 0; i < triangles_per_pose; ++i) {
    const Triangle t = make_triangle(random_rest(random));
    const Vecs<2> w = pose_w(GetParam(), random);
    EXPECT_TRUE(is_slope([&](const VecX& y) { return one_number(Shear(t, unflat(y)).C); },
                         [&](const VecX& y) { return gradient(Shear(t, unflat(y))); }, flat(w),
                         shortest(w)))
        << "triangle " << i;
  }
}

TEST_P(Derivatives, ShearSecondDerivativeIsTheSlopeOfTheGradient) {
  Random random(4);
  for (int i = 0; i < triangles_per_pose; ++i) {
    const Triangle t = make_triangle(random_rest(random));
    const Vecs<2> w = pose_w(GetParam(), random);
    EXPECT_TRUE(
        is_slope([&](const VecX& y) -> VecX { return gradient(Shear(t, unflat(y))).transpose(); },
                 [&](const VecX&) { return matrix(Shear(t, zero_vectors<2>()).second()); }, flat(w),
                 shortest(w)))
        << "triangle " << i;
  }
}

// f = −∂E/∂x, through gather and scatter, from all nine coordinates of the triangle.
TEST_P(Derivatives, ForceIsTheFallingSlopeOfTheEnergy) {
  struct Case {
    const char* name;
    double k_stretch, k_shear;
  };
  Random random(5);
  for (const Case& c : {Case{"stretch", 7, 0}, Case{"shear", 0, 3}, Case{"both", 7, 3}})
    for (const std::array<double, 2>& b : {std::array{1.0, 1.0}, std::array{0.8, 1.3}})
      for (int i = 0; i < triangles_per_pose; ++i) {
        const Rest rest = random_rest(random);
        const Triangle t = make_triangle(rest);
        const Vecs<2> w = pose_w(GetParam(), random);
        const VecX x = positions(rest, w, random.vector(3, 1));
        Cloth cloth = one_triangle(t, c.k_stretch, c.k_shear);
        if (auto& stretch = cloth.term<StretchTerm>()) stretch->b = b;
        EXPECT_TRUE(
            is_slope([&](const VecX& at) { return one_number(potential_energy(cloth, at)); },
                     [&](const VecX& at) -> MatX { return -forces(cloth, at).transpose(); }, x,
                     shortest(w) / t.weight.cwiseAbs().maxCoeff()))
            << c.name << ", triangle " << i << ", b_u = " << b[0];
      }
}

INSTANTIATE_TEST_SUITE_P(Triangle, Derivatives, testing::ValuesIn(all_poses),
                         [](const auto& pose) { return std::string(name(pose.param)); });

TEST(Spring, DerivativesAreSlopes) {
  Random random(6);
  for (const double length : {1e-3, 0.5, 1.0, 2.0})  // of a rest length 1
    for (const double share : {1.0, 0.3})
      for (int i = 0; i < triangles_per_pose; ++i) {
        const Spring s = make_spring(0, 1, random.between(0.9, 1.1), share);
        const VecX y = length * random.direction();
        EXPECT_TRUE(
            is_slope([&](const VecX& at) { return one_number(Elongation(s, at).C); },
                     [&](const VecX& at) -> MatX { return Elongation(s, at).dCdy[0].transpose(); },
                     y, length))
            << "C, length " << length << ", share " << share;
        EXPECT_TRUE(is_slope(
            [&](const VecX& at) -> VecX { return Elongation(s, at).dCdy[0]; },
            [&](const VecX& at) -> MatX { return Elongation(s, at).second()[0][0]; }, y, length))
            << "dC/dy, length " << length << ", share " << share;
      }
}

// The share multiplies the stiffness: E = share k/2 (|y| − L)².
TEST(Spring, ForceIsTheFallingSlopeOfTheEnergyAndPullsTogetherWhenLong) {
  Random random(7);
  for (const double share : {1.0, 0.3})
    for (int i = 0; i < triangles_per_pose; ++i) {
      const Cloth cloth = one_spring(make_spring(0, 1, 0.8, share), 11);
      const VecX x = random.vector(6, 1);
      const double length = (x.head<3>() - x.tail<3>()).norm();
      EXPECT_NEAR(potential_energy(cloth, x), share * 11 / 2 * std::pow(length - 0.8, 2), 1e-14);
      EXPECT_TRUE(is_slope([&](const VecX& at) { return one_number(potential_energy(cloth, at)); },
                           [&](const VecX& at) -> MatX { return -forces(cloth, at).transpose(); },
                           x, length));
      const Vec3 towards = x.tail<3>() - x.head<3>();
      EXPECT_EQ(forces(cloth, x).head<3>().dot(towards) > 0, length > 0.8) << "length " << length;
    }
}

// A condition reads its own vectors only, and says which.
TEST(Stretch, ReadsOneThreadAndSaysWhich) {
  const Triangle t = make_triangle({Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)});
  const Vecs<2> w = {Vec3(2, 0, 0), Vec3(0, 3, 0)};
  EXPECT_EQ(Stretch(t, w, 0).first, 0);
  EXPECT_EQ(Stretch(t, w, 1).first, 1);
  EXPECT_NEAR(Stretch(t, w, 0).C, std::sqrt(0.5) * 1, 1e-15);
  EXPECT_NEAR(Stretch(t, w, 1).C, std::sqrt(0.5) * 2, 1e-15);
}

// The judge judged: order 2 for a right slope, and one wrong part in a million is seen.
TEST(Differences, HaveOrderTwoAndFindASmallWrongTerm) {
  const Function f = [](const VecX& x) -> VecX { return x.array().exp(); };
  const Slope right = [](const VecX& x) -> MatX { return x.array().exp().matrix().asDiagonal(); };
  const Slope wrong = [&](const VecX& x) -> MatX { return right(x) * (1 + 1e-6); };
  const VecX x = VecX::Constant(2, 0.3);
  EXPECT_NEAR(order(f, right, x, 1e-2), 2, 0.01);
  EXPECT_TRUE(is_slope(f, right, x, 1));
  EXPECT_FALSE(is_slope(f, wrong, x, 1));
  EXPECT_FALSE(is_slope(
      f, [&](const VecX& at) -> MatX { return -right(at); }, x, 1));
  EXPECT_FALSE(is_slope(
      f, [&](const VecX& at) -> MatX { return right(at) * std::nan(""); }, x, 1));
}

}  // namespace derivatives_test
