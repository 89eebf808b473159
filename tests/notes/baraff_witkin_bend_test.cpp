// The ten steps to bending of the Baraff–Witkin note (notes 000 in the bibliography), line by line. The lines
// that decide are right. Some between them are not, and some use names that nothing defines: the note renamed
// the edges of the program that it follows, but not everywhere.
//
//   the note's rule   v_ab = p_a − p_b,   so v10 = p1 − p0
//   that program      v01 = p1 − p0,  v02 = p2 − p0,  v21 = p1 − p2,  v31 = p1 − p3,  v32 = p2 − p3
#include <gtest/gtest.h>

#include "support/folds.h"

namespace baraff_witkin_bend_test {

// Hinges of ordinary proportion, folded by less than a full fold.
std::vector<FoldCase> some_folds(unsigned seed) {
  std::vector<FoldCase> folds = all_folds(seed);
  std::erase_if(folds, [](const FoldCase& fold) {
    return !fold.name.starts_with("plain") || std::abs(fold.theta) > 2.5 || fold.theta == 0;
  });
  return folds;
}

// The names of the note, read as the note's rule has them.
struct Named {
  explicit Named(const FoldCase& fold) : Named(points(fold.x)) {}
  explicit Named(const Vecs<4>& p)
      : f(make_fold(p)), v10(p[1] - p[0]), v20(p[2] - p[0]), v23(p[2] - p[3]), v13(p[1] - p[3]),
        v12(p[1] - p[2]), n0(f[0].n), n1(f[1].n), theta(angle(p)) {
    for (size_t vertex = 0; vertex < 3; ++vertex) {
      m0[vertex] = f[0].m[vertex];
      d0[vertex] = f[0].d[vertex];
      c0[vertex] = f[0].c[vertex];
      m1[3 - vertex] = f[1].m[vertex];
      d1[3 - vertex] = f[1].d[vertex];
      c1[3 - vertex] = f[1].c[vertex];
    }
  }

  Fold f;
  Vec3 v10, v20, v23, v13, v12;
  Vec3 n0, n1;
  double theta;
  Vecs<4> m0, m1;  // m0[2] is m02, of triangle 0 at vertex 2; m1[2] is m12
  std::array<double, 4> d0, d1, c0, c1;
};

double off(const Vec3& printed, const Vec3& right) {
  return (printed - right).norm() / right.norm();
}

// 3. The listing by projection uses e01, e02, e21, e31 and e32. As edges of the program that it follows all
// six binormals are right. By the note's rule, e01 = p0 − p1, all six point away from their edge.
TEST(Notes000, BinormalsByProjectionNeedTheOldNames) {
  const auto square_to = [](const Vec3& v, const Vec3& e) -> Vec3 {
    return (v - e * e.dot(v)).normalized();
  };
  for (const FoldCase& fold : some_folds(91)) {
    const Named n(fold);
    for (const double sign : {1, -1}) {  // old names, the note's rule
      const Vec3 e01 = sign * n.v10.normalized(), e02 = sign * n.v20.normalized(),
                 e21 = sign * n.v12.normalized(), e31 = sign * n.v13.normalized(),
                 e32 = sign * n.v23.normalized();
      EXPECT_LT(off(square_to(e01, e21), sign * n.m0[0]), 1e-13);
      EXPECT_LT(off(square_to(-e01, e02), sign * n.m0[1]), 1e-13);
      EXPECT_LT(off(square_to(-e02, e01), sign * n.m0[2]), 1e-13);
      EXPECT_LT(off(square_to(e32, e21), sign * n.m1[3]), 1e-13);
      EXPECT_LT(off(square_to(-e32, e31), sign * n.m1[2]), 1e-13);
      EXPECT_LT(off(square_to(-e31, e32), sign * n.m1[1]), 1e-13);
    }
  }
}

// 5. The note: sin θ = (n0 × n1)·e12 in the text, sin θ = n1·m00 in the program. They have opposite signs.
// The program's is ours, and the gradient of step 7 belongs to it.
TEST(Notes000, PrintedSineHasTheSignOppositeToThatOfTheProgram) {
  for (const FoldCase& fold : some_folds(92)) {
    const Named n(fold);
    EXPECT_NEAR(n.n0.cross(n.n1).dot(n.v12.normalized()), -n.n1.dot(n.m0[0]), 1e-14);
    EXPECT_NEAR(std::atan2(n.n1.dot(n.m0[0]), n.n0.dot(n.n1)), n.theta, 1e-13);
  }
}

// Taken together, the printed sine and that gradient fold the cloth up: P3 of a unit cell, lifted by 0.1, is
// pushed up by 0.195 k where it should be pushed down.
TEST(Notes000, PrintedSineFoldsTheClothUp) {
  const Vecs<4> p = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(1, 1, 0.1)};
  const Named n(p);
  const double sine = n.n0.cross(n.n1).dot(n.v12.normalized());
  const double printed = std::atan2(sine, n.n0.dot(n.n1));
  const Vec3 gradient = angle_gradient(n.f)[3];
  EXPECT_NEAR(-printed * gradient.z(), 0.195, 5e-4);
  EXPECT_NEAR(-n.theta * gradient.z(), -0.195, 5e-4);
  EXPECT_NEAR(family_forces(one_hinge(hinge_near(0), 1), flat(p))[11], -0.195, 5e-4);
}

// 6. Three lines on the way to ∂n0/∂x. The note: ∇(u × v) = (u × ∇v − v × ∇u)/|u × v|; without the division
// it is right. The second part has m02/h01; right is m02/h02. And −(m00 + m02)/d01; right is −(m00/d00 +
// m02/d02), which is m01/d01. The results are right again (GradientsOfAFlap).
TEST(Notes000, LinesBetweenOfStepSix) {
  const Vec3 u(2, 1, 0), v(0, 3, 1), du(1e-3, 0, 2e-3), dv(0, -1e-3, 1e-3);
  const Vec3 change = (u + du).cross(v + dv) - u.cross(v) - du.cross(dv);
  EXPECT_LT(off(u.cross(dv) - v.cross(du), change), 1e-12);
  EXPECT_GT(off((u.cross(dv) - v.cross(du)) / u.cross(v).norm(), change), 0.5);

  for (const FoldCase& fold : some_folds(93)) {
    const Named n(fold);
    const auto along_n0 = [&](int vertex) -> Vec3 {  // ∂n0/∂x = (this) n0ᵀ
      return normal_gradients(n.f[0])[size_t(vertex)] * n.n0;
    };
    EXPECT_LT(off(n.m0[2] / n.d0[2], along_n0(2)), 1e-12);
    EXPECT_GT(off(n.m0[2] / n.d0[1], along_n0(2)), 1e-3);
    EXPECT_LT(off(-(n.m0[0] / n.d0[0] + n.m0[2] / n.d0[2]), along_n0(1)), 1e-12);
    EXPECT_GT(off(-(n.m0[0] + n.m0[2]) / n.d0[1], along_n0(1)), 1e-3);
  }
}

// 7. The note: n0ᵀ∇n1/sin θ = (|e12| n1ᵀ∇e32 − (ê12·e32) n1ᵀ∇e12)/|n1|. Right with sin θ of the program, and
// only with e32 = p3 − p2: here the note's rule holds, and the old name would be wrong.
TEST(Notes000, StepSevenReadsOneEdgeByTheNotesRule) {
  for (const FoldCase& fold : some_folds(94)) {
    const Named n(fold);
    const double length = n.v12.norm(), twice_the_area = length * n.d1[3];
    const auto error = [&](const Vec3& e32, double sine) {
      const double sign = e32.dot(n.v23) < 0 ? 1 : -1;  // ∇e32 = sign (0, 0, −I, I)
      const double share = n.v12.normalized().dot(e32);
      const std::array<double, 4> printed = {0, -share, share - sign * length, sign * length};
      double sum = 0;
      for (const size_t vertex : {1u, 2u, 3u})
        sum += std::abs(printed[vertex] / twice_the_area -
                        n.n0.dot(n.m1[vertex]) / n.d1[vertex] / sine);
      return sum;
    };
    const double sine = n.n1.dot(n.m0[0]);
    EXPECT_LT(error(-n.v23, sine), 1e-12);
    EXPECT_GT(error(n.v23, sine), 0.1);
    EXPECT_GT(error(-n.v23, -sine), 0.1);
  }
}

// 7, 8, 10. The results that the note prints are ours: ∇θ, ∇d00 and the first row of the second derivative.
TEST(Notes000, ResultsOfTheStepsAreRight) {
  for (const FoldCase& fold : some_folds(95)) {
    const Named n(fold);
    const auto& [m0, d0, d1, c0, c1] = std::tie(n.m0, n.d0, n.d1, n.c0, n.c1);
    const Vecs<4> dtheta = {-n.n0 / d0[0], c0[2] * n.n0 / d0[1] + c1[2] * n.n1 / d1[1],
                            c0[1] * n.n0 / d0[2] + c1[1] * n.n1 / d1[2], -n.n1 / d1[3]};
    for (int i = 0; i < 4; ++i) EXPECT_LT(off(dtheta[i], angle_gradient(n.f)[i]), 1e-12);

    const double square = n.v12.squaredNorm();
    const Vecs<3> dd00 = {-m0[0], m0[0] * -n.v12.dot(n.v20) / square,
                          m0[0] * n.v12.dot(n.v10) / square};
    const Mats<4> second = angle_second(n.f);
    for (int j = 0; j < 3; ++j) {
      EXPECT_LT((dd00[j] - height_gradients(n.f[0], 0)[j]).norm(), 1e-12);
      const Mat3 dn0 = m0[size_t(j)] * n.n0.transpose() / d0[size_t(j)];
      const Mat3 row = -dn0 / d0[0] + n.n0 * dd00[j].transpose() / (d0[0] * d0[0]);
      EXPECT_LT((row - second[0][size_t(j)]).norm(), 1e-11);
    }
    EXPECT_EQ(second[0][3], Mat3::Zero().eval());
  }
}

// 9. The derivatives of the cosines use v02, v21, v31 and v32: right as old names. By the note's rule, v02 =
// p0 − p2, all of c02, c11 and c12 have the wrong sign. c01 has new names throughout and is right.
TEST(Notes000, CosinesNeedTheOldNames) {
  for (const FoldCase& fold : some_folds(96)) {
    const Named n(fold);
    const auto& [m0, m1] = std::tie(n.m0, n.m1);
    const Vec3 &v10 = n.v10, &v20 = n.v20, &v12 = n.v12, &v13 = n.v13, &v23 = n.v23;
    const Vecs<3> dc01 = cosine_gradients(n.f[0], 1), dc02 = cosine_gradients(n.f[0], 2);
    const Vecs<3> dc12 = cosine_gradients(n.f[1], 1),
                  dc11 = cosine_gradients(n.f[1], 2);  // by P3, P2, P1
    EXPECT_LT(off(-m0[2] * m0[0].dot(v10) / v10.dot(v10), dc01[0]), 1e-12);
    EXPECT_LT(off(-m0[0] * m0[2].dot(v12) / v12.dot(v12), dc01[2]), 1e-12);
    for (const double sign : {1, -1}) {  // old names, the note's rule
      const Vec3 v02 = sign * v20, v21 = sign * v12, v31 = sign * v13, v32 = sign * v23;
      EXPECT_LT(off(-m0[1] * m0[0].dot(v20) / v02.dot(v20), sign * dc02[0]), 1e-12);
      EXPECT_LT(off(m0[0] * m0[1].dot(v12) / v21.dot(v12), sign * dc02[1]), 1e-12);
      EXPECT_LT(off(-m1[3] * m1[2].dot(v12) / v21.dot(v12), sign * dc11[1]), 1e-12);
      EXPECT_LT(off(-m1[2] * m1[3].dot(v13) / v31.dot(v13), sign * dc11[0]), 1e-12);
      EXPECT_LT(off(m1[3] * m1[1].dot(v12) / v21.dot(v12), sign * dc12[2]), 1e-12);
      EXPECT_LT(off(-m1[1] * m1[3].dot(v23) / v32.dot(v23), sign * dc12[0]), 1e-12);
    }
  }
}

}  // namespace baraff_witkin_bend_test
