// The ten steps to the second derivative of the angle of a hinge, one by one: the first five
// against geometry, the others against finite differences. A mistake in one step fails the test of that
// step first.
#include "support/differences.h"
#include "support/folds.h"

namespace hinge_test {

// The corners of one flap as nine numbers, its own vertex first; and the flap with these corners.
VecX flap_points(const FoldCase& fold, int flap) {
  const Vecs<4> p = points(fold.x);
  VecX x(9);
  for (int i = 0; i < 3; ++i) x.segment<3>(3 * i) = p[corners[flap][i]];
  return x;
}
Flap flap_at(const VecX& x) {
  return make_flap(x.head<3>(), x.segment<3>(3), x.tail<3>());
}

template <class Test>
void for_each_flap(unsigned seed, const Test& test) {
  for (const FoldCase& fold : all_folds(seed))
    for (const int flap : {0, 1}) {
      SCOPED_TRACE(fold.name + ", flap " + std::to_string(flap));
      test(flap_points(fold, flap), fold.length);
    }
}

VecX numbers(const Corners& c) {
  return Eigen::Map<const Vec3>(c.data());
}
VecX one_number(double value) {
  return VecX::Constant(1, value);
}

// Rows of three gradients ∂/∂x_0, ∂/∂x_1, ∂/∂x_2 each.
MatX rows(const std::array<Vecs<3>, 3>& gradients) {
  MatX all(3, 9);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) all.block<1, 3>(i, 3 * j) = gradients[i][j].transpose();
  return all;
}

// 1
TEST(Hinge, EdgesPointFromTheSecondIndexToTheFirst) {
  const Vec3 p0(1, 2, 3), p1(4, 2, 3), p2(1, 7, 3);
  const Edges e = edges(p0, p1, p2);
  EXPECT_EQ(e.v10, Vec3(3, 0, 0));
  EXPECT_EQ(e.v20, Vec3(0, 5, 0));
  EXPECT_EQ(e.v12, Vec3(3, -5, 0));
  EXPECT_EQ(e.e10, Vec3(1, 0, 0));
  EXPECT_EQ(e.e20, Vec3(0, 1, 0));
  EXPECT_NEAR((e.e12 - Vec3(3, -5, 0) / std::sqrt(34)).norm(), 0, 1e-15);
}

// 2
TEST(Hinge, CosinesObeyTheLawOfCosines) {
  for_each_flap(1, [](const VecX& x, double) {
    const Flap f = flap_at(x);
    for (int i = 0; i < 3; ++i) {
      const Vec3 a = x.segment<3>(3 * ((i + 1) % 3)) - x.segment<3>(3 * i);
      const Vec3 b = x.segment<3>(3 * ((i + 2) % 3)) - x.segment<3>(3 * i);
      const double law =
          (a.squaredNorm() + b.squaredNorm() - (a - b).squaredNorm()) / (2 * a.norm() * b.norm());
      EXPECT_NEAR(f.c[i], law, 1e-13) << "corner " << i;
    }
  });
}

// 2
TEST(Hinge, NormalIsTowardsTheSideFromWhichTheFlapIsCounterClockwise) {
  for_each_flap(2, [](const VecX& x, double) {
    const Vec3 a = x.segment<3>(3) - x.head<3>(), b = x.tail<3>() - x.head<3>();
    const Vec3 n = flap_at(x).n;
    EXPECT_NEAR(n.norm(), 1, 1e-14);
    EXPECT_LT((n - a.cross(b).normalized()).norm(), 1e-11);
  });
}

// 3
TEST(Hinge, BinormalsPointFromEachCornerSquareToTheOppositeEdge) {
  for_each_flap(3, [](const VecX& x, double length) {
    const Flap f = flap_at(x);
    for (int i = 0; i < 3; ++i) {
      const Vec3 m = f.m[i];
      const Vec3 p = x.segment<3>(3 * i), q = x.segment<3>(3 * ((i + 1) % 3));
      const Vec3 edge = x.segment<3>(3 * ((i + 2) % 3)) - q;
      EXPECT_NEAR(m.norm(), 1, 1e-14);
      EXPECT_LT(std::abs(m.dot(f.n)), 1e-15 / length) << "corner " << i;
      EXPECT_LT(std::abs(m.dot(edge.normalized())), 1e-14) << "corner " << i;
      EXPECT_GT(m.dot(q - p), 0) << "corner " << i;
    }
  });
}

// 4
TEST(Hinge, HeightsTimesOppositeEdgesAreTwiceTheArea) {
  for_each_flap(4, [](const VecX& x, double length) {
    const Flap f = flap_at(x);
    const Vec3 a = x.segment<3>(3) - x.head<3>(), b = x.tail<3>() - x.head<3>();
    const double twice_the_area = a.cross(b).norm();
    for (int i = 0; i < 3; ++i) {
      const Vec3 edge = x.segment<3>(3 * ((i + 2) % 3)) - x.segment<3>(3 * ((i + 1) % 3));
      EXPECT_NEAR(f.d[i] * edge.norm() / twice_the_area, 1, 1e-14 / length) << "corner " << i;
    }
  });
}

// 5
TEST(Hinge, AngleIsTheOneByWhichItIsFolded) {
  for (const FoldCase& fold : all_folds(5))
    EXPECT_NEAR(angle(points(fold.x)), fold.theta, 1e-14 / fold.length) << fold.name;
}

TEST(Hinge, LiftingP3ToTheFrontMakesTheAngleNegative) {
  Vecs<4> p = FlatHinge{1, 0.5, 1, 0.5}.folded(0);
  EXPECT_EQ(angle(p), 0);
  p[3] += 0.1 * make_fold(p)[0].n;
  EXPECT_NEAR(angle(p), -std::atan(0.1), 1e-15);
  std::swap(p[1], p[2]);  // seen from the other side
  EXPECT_NEAR(angle(p), std::atan(0.1), 1e-15);
}

TEST(Hinge, TurnedByHalfATurnItIsTheSame) {
  for (const FoldCase& fold : all_folds(6)) {
    const auto [p0, p1, p2, p3] = points(fold.x);
    const Vecs<4> there = {p0, p1, p2, p3}, back = {p3, p2, p1, p0};
    EXPECT_NEAR(angle(there), angle(back), 1e-14 / fold.length) << fold.name;
    const Vecs<4> a = angle_gradient(make_fold(there)), b = angle_gradient(make_fold(back));
    for (int i = 0; i < 4; ++i) EXPECT_EQ(a[i], b[3 - i]) << fold.name;
  }
}

// 7
TEST(Hinge, AngleGradientIsTheSlopeOfTheAngle) {
  for (const FoldCase& fold : all_folds(8))
    EXPECT_TRUE(is_slope(
        [&](const VecX& at) { return one_number(angle(hinge_near(fold.theta), points(at))); },
        [](const VecX& at) -> MatX {
          return flat(angle_gradient(make_fold(points(at)))).transpose();
        },
        fold.x, fold.length))
        << fold.name;
}

// 6, 8, 9, 10: a function of a flap, three numbers, and its slope as the step computes it.
struct FlapDerivative {
  const char* name;
  VecX (*value)(const Flap&);
  MatX (*slope)(const Flap&);
};
void PrintTo(const FlapDerivative& derivative, std::ostream* out) {
  *out << derivative.name;
}

const std::vector<FlapDerivative> flap_derivatives = {
    {"Normal", [](const Flap& f) -> VecX { return f.n; },
     [](const Flap& f) -> MatX {
       const std::array<Mat3, 3> dndx = normal_gradients(f);
       MatX all(3, 9);
       all << dndx[0], dndx[1], dndx[2];
       return all;
     }},
    {"Heights", [](const Flap& f) { return numbers(f.d); },
     [](const Flap& f) {
       return rows({height_gradients(f, 0), height_gradients(f, 1), height_gradients(f, 2)});
     }},
    {"Cosines", [](const Flap& f) { return numbers(f.c); },
     [](const Flap& f) {
       return rows({cosine_gradients(f, 0), cosine_gradients(f, 1), cosine_gradients(f, 2)});
     }},
    {"Levers", [](const Flap& f) { return numbers(levers(f)); },
     [](const Flap& f) { return rows(lever_gradients(f, levers(f))); }},
};

class GradientsOfAFlap : public testing::TestWithParam<FlapDerivative> {};
INSTANTIATE_TEST_SUITE_P(Steps, GradientsOfAFlap, testing::ValuesIn(flap_derivatives),
                         [](const auto& step) { return std::string(step.param.name); });

TEST_P(GradientsOfAFlap, AreSlopes) {
  for_each_flap(10, [](const VecX& x, double length) {
    EXPECT_TRUE(is_slope([](const VecX& at) { return GetParam().value(flap_at(at)); },
                         [](const VecX& at) { return GetParam().slope(flap_at(at)); }, x, length));
  });
}

MatX matrix(const Mats<4>& blocks) {
  MatX all(12, 12);
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) all.block<3, 3>(3 * i, 3 * j) = blocks[i][j];
  return all;
}

// 10. every_model_test.cpp checks that it is the slope of the gradient.
// It is symmetric, although the part of one flap is not: what a rotation of the edge adds to both parts
// cancels. It has no block of P0 and P3. Moving all four vertices together changes nothing.
TEST(Hinge, SecondDerivativeIsSymmetricWithoutABlockOfP0AndP3) {
  for (const FoldCase& fold : all_folds(14)) {
    const MatX H = matrix(angle_second(make_fold(points(fold.x))));
    const double rounding = 1e-14 / fold.length * H.norm();
    EXPECT_LT((H - H.transpose()).norm(), rounding) << fold.name;
    EXPECT_EQ(H.topRightCorner(3, 3).norm(), 0) << fold.name;
    MatX sum = MatX::Zero(12, 3);
    for (int j = 0; j < 4; ++j) sum += H.middleCols<3>(3 * j);
    EXPECT_LT(sum.norm(), rounding) << fold.name;
  }
}

// 10 km from the origin positions are rounded to 2e-12 m. A hinge has no other error than this one.
TEST(Hinge, FarFromTheOriginOnlyTheGrainOfThePlaceIsLost) {
  const double grain = 2e-12;
  for (const FoldCase& fold : all_folds(15)) {
    const VecX far = moved(fold.x, Mat3::Identity(), Vec3(1e4, -1e4, 1e4));
    const Hinge hinge = hinge_near(fold.theta);
    const Vecs<4> p = gather(hinge, fold.x), q = gather(hinge, far);
    const Fold here = make_fold(p), there = make_fold(q);
    const VecX g = flat(angle_gradient(here));
    EXPECT_NEAR(angle(hinge, q), angle(hinge, p), 8 * grain * g.norm()) << fold.name;
    const double turned = 16 * grain / fold.length;
    EXPECT_LT((flat(angle_gradient(there)) - g).norm(), turned * g.norm()) << fold.name;
    const MatX H = matrix(angle_second(here));
    EXPECT_LT((matrix(angle_second(there)) - H).norm(), 2 * turned * H.norm()) << fold.name;
  }
}

}  // namespace hinge_test
