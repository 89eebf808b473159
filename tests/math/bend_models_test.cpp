// The four models of bending: folds beyond a full one, collapsed flaps, and the properties that each model
// is known for.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "math/quadratic_bend.h"
#include "scene/mesh_edges.h"
#include "step03_implicit/time_step.h"
#include "support/dense.h"
#include "support/folds.h"

namespace bend_models_test {

constexpr double k = 3, small_fold = 0.02;  // N·m, rad

QuadraticHinges one_quadratic(const FlatHinge& flat_hinge) {
  QuadraticHinges hinges;
  hinges.elements = {quadratic(flat_hinge)};
  hinges.term<QuadraticBend>() = QuadraticBend(k);
  return hinges;
}

constexpr FlatHinge plain = {0.8, 0.4, 0.6, 0.7};

// Forces -----------------------------------------------------------------------------------------

TEST(Bend, P3LiftedIsPushedBack) {
  VecX x = flat(plain.folded(-0.1));
  ASSERT_GT(x[11], 0) << "lifted to the front";
  for (const BendModel model : {BendModel::dihedral, BendModel::bridson})
    EXPECT_LT(family_forces(one_hinge(hinge_near(0, 0, 1), k, model), x)[11], 0);
  EXPECT_LT(family_forces(one_quadratic(plain), x)[11], 0);
}

// A full fold and beyond -------------------------------------------------------------------------

// P3 on its circle, at 0.5 m/s in steps of 2 ms, from `first` to `last`.
template <class Look>
void sweep(Hinges& hinges, double first, double last, const Look& look) {
  const double step = std::copysign(0.5 * 2e-3 / plain.height1, last - first);
  for (double theta = first; std::abs(theta - first) <= std::abs(last - first); theta += step) {
    const VecX x = flat(plain.folded(theta));
    look(theta, x);
    follow(hinges.elements, x);
  }
}

// The force on P3 along its path, in the direction of growing θ.
double push(const Hinges& hinges, double theta, const VecX& x) {
  const Vec3 along(-std::sin(theta), 0, -std::cos(theta));
  return family_forces(hinges, x).tail<3>().dot(along);
}

struct Sweep {
  double rest_angle, first, last;
};

class FullFold : public testing::TestWithParam<Sweep> {};
INSTANTIATE_TEST_SUITE_P(Sweeps, FullFold,
                         testing::Values(Sweep{0, 0.1, 5.5}, Sweep{0, -0.1, -5.5},
                                         Sweep{1, 1.1, 5.5}, Sweep{-2, -1.9, 5.5},
                                         Sweep{2.5, 2.4, -5.5}),
                         [](const auto& sweep) {
                           const int degrees = int(std::lround(100 * sweep.param.rest_angle));
                           return "rest_" + std::string(degrees < 0 ? "minus_" : "") +
                                  std::to_string(std::abs(degrees)) +
                                  (sweep.param.last > 0 ? "_up" : "_down");
                         });

TEST_P(FullFold, KeepsItsEnergyAndTheSignOfItsForce) {
  const Sweep& s = GetParam();
  Hinges hinges = one_hinge(hinge_near(0, s.rest_angle), k);
  follow(hinges.elements, flat(plain.folded(s.first)));
  sweep(hinges, s.first, s.last, [&](double theta, const VecX& x) {
    const double away = theta - s.rest_angle;
    EXPECT_NEAR(energy(hinges, x), k / 2 * away * away, 1e-12) << theta;
    EXPECT_NEAR(push(hinges, theta, x), -k * away / plain.height1, 1e-11) << theta;
  });
}

// Without θ of the last step the force changes its sign at π, and pushes the fold further.
TEST(Bend, WithoutTheLastAngleAFullFoldFlips) {
  Hinges hinges = one_hinge(hinge_near(0), k);
  EXPECT_LT(push(hinges, pi - 0.01, flat(plain.folded(pi - 0.01))), 0);
  EXPECT_GT(push(hinges, pi + 0.01, flat(plain.folded(pi + 0.01))), 0);
}

TEST(Bend, AHingeStartsWithinHalfATurn) {
  for (const double theta : {-3.1, -1.0, 0.0, 2.0, 3.1, pi}) {
    Hinges hinges = one_hinge(hinge_near(0), k);
    follow(hinges.elements, flat(plain.folded(theta)));
    EXPECT_NEAR(std::abs(hinges.elements[0].theta), std::abs(theta), 1e-15);
    EXPECT_LE(std::abs(hinges.elements[0].theta), pi);
  }
}

// A flap that is a line ---------------------------------------------------------------------------

// Such a fold has no angle: the energy is that of the last step, and the force is zero.
TEST(Bend, ACollapsedFlapKeepsItsEnergyAndHasNoForce) {
  const Vec3 p0(-1, 0.5, 0), p1(0, 0, 0), p2(0, 1, 0), p3(0.5, 0.5, -0.5);
  for (const Vecs<4>& p : {Vecs<4>{p1, p1, p2, p3},  // P0 on P1
                           Vecs<4>{Vec3(0, 0.3, 0), p1, p2, p3}, Vecs<4>{Vec3(0, 7, 0), p1, p2, p3},
                           Vecs<4>{p0, p1, p1, p3},  // an edge without length
                           Vecs<4>{p0, p1, p2, Vec3(0, 0.5, 0)}, Vecs<4>{p0, p0, p0, p0},
                           Vecs<4>{Vec3(1e-9, 0.4, 0), p1, p2, p3}})
    for (const BendModel model : {BendModel::dihedral, BendModel::bridson}) {
      Hinges hinges = one_hinge(hinge_near(0.7, 0.2, 0.5), k, model);
      const double before = energy(hinges, flat(plain.folded(0.7)));
      EXPECT_NEAR(energy(hinges, flat(p)), before, 1e-14);
      EXPECT_EQ(family_forces(hinges, flat(p)), VecX::Zero(12).eval());
      hinges.conditions(hinges.elements[0], p, [](const Term&, const auto& c) {
        EXPECT_TRUE(std::isfinite(c.C));
        for (const auto& row : c.second())
          for (const Mat3& block : row) EXPECT_EQ(block, Mat3::Zero().eval());
      });
      follow(hinges.elements, flat(p));
      EXPECT_EQ(hinges.elements[0].theta, 0.7);
    }
}

// |∂θ/∂x_i| is at most 1/d for the vertex of a flap of height d, and twice that at the ends of the edge.
TEST(Bend, ForceOfALowFlapIsBounded) {
  Random random(44);
  for (double height = 1; height > 1e-20; height /= 3)
    for (int i = 0; i < 20; ++i) {
      const FlatHinge low = {height, random.between(0, 1), random.between(0.1, 1),
                             random.between(0, 1)};
      const double theta = random.between(-3, 3);
      const VecX x = moved(flat(low.folded(theta)), random.rotation(), random.vector(3, 1));
      const VecX f = family_forces(one_hinge(hinge_near(theta), k), x);
      ASSERT_TRUE(f.allFinite());
      EXPECT_LE(f.norm(), k * pi * 4 / Hinge{}.lowest) << "height " << height;
    }
}

// The matrix -------------------------------------------------------------------------------------

// −K of one condition: k (g gᵀ + kept · H).
MatX stiffness(const Condition<4>& c, const Mats<4>& second, double kept) {
  MatX K(12, 12);
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      K.block<3, 3>(3 * i, 3 * j) = c.dCdy[i] * c.dCdy[j].transpose() + kept * second[i][j];
  return K;
}
double lowest_over_highest(const MatX& K) {
  const VecX values = eigenvalues(K);
  return values.minCoeff() / values.cwiseAbs().maxCoeff();
}

TEST(Bend, GaussNewtonIsPositiveSemidefiniteAndTheFullMatrixIsNot) {
  for (const FoldCase& fold : all_folds(45)) {
    const Dihedral c(hinge_near(fold.theta), points(fold.x));
    EXPECT_GE(lowest_over_highest(stiffness(c, c.second(), 0)), -1e-14) << fold.name;
    if (fold.theta != 0) {
      EXPECT_LT(lowest_over_highest(stiffness(c, c.second(), c.C)), -1e-3) << fold.name;
    }
  }
}

// The numbers of a cell of unit legs, hinged on its diagonal: g gᵀ + θ H reaches down to −1.5 at half a
// radian.
TEST(Bend, TheFullMatrixOfAUnitCellIsIndefinite) {
  const double half = std::sqrt(0.5);
  FlatHinge cell = {half, half, half, half};  // the edge is √2 long
  for (const auto& [theta, lowest] : std::map<double, double>{{0.5, -1.495}, {1.5, -3.941}}) {
    Vecs<4> p = cell.folded(theta);
    p[2] *= std::sqrt(2);
    const Dihedral c(hinge_near(0), p);
    const MatX K = stiffness(c, c.second(), theta);
    EXPECT_NEAR(eigenvalues(K)[0], lowest, 1e-3);
  }
}

// The force and matrices that the steps assemble from blocks, against the same in dense matrices. The four
// vertices are numbered in every order, so that there are blocks above and below the diagonal.
template <class Family>
Evaluated assembled(const Family& family, const State& state, Jacobian jacobian) {
  Cloth cloth = bare_cloth(4);
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < i; ++j) cloth.springs.elements.push_back(make_spring(i, j, 1));  // pattern
  Method method;
  method.jacobian = jacobian;
  step03::System system(cloth, method);
  system.D = system.K;
  system.f.setZero();
  system.slots.of(family) = find_slots(family, system.K);
  step03::add_family(family, state, system);
  return {system.f, dense(system.K), dense(system.D)};
}

TEST(Bend, TheStepsAssembleForceAndMatricesOfAHinge) {
  Random random(46);
  const double kd = 0.4;
  std::array<int, 4> order = {0, 1, 2, 3};
  do {
    const FoldCase fold = all_folds(47)[4];
    VecX x(12);
    for (int i = 0; i < 4; ++i) x.segment<3>(3 * order[i]) = fold.x.segment<3>(3 * i);
    const State state{x, random.vector(12, 1)};
    Hinges hinges = one_hinge(hinge_near(fold.theta, 0.3), k);
    hinges.elements[0].vertices = order;
    hinges.term<DihedralBend>()->kd = kd;
    VecX g(12);
    MatX H(12, 12);
    const Fold at = make_fold(gather(hinges.elements[0], x));
    const Vecs<4> gradient = angle_gradient(at);
    const Mats<4> second = angle_second(at);
    for (int i = 0; i < 4; ++i) {
      g.segment<3>(3 * order[i]) = gradient[i];
      for (int j = 0; j < 4; ++j) H.block<3, 3>(3 * order[i], 3 * order[j]) = second[i][j];
    }
    const double C = fold.theta - 0.3, Cdot = g.dot(state.v);
    for (const Jacobian jacobian : {Jacobian::definite, Jacobian::bw98}) {
      const Evaluated found = assembled(hinges, state, jacobian);
      const double kept = jacobian == Jacobian::bw98 ? k * C + kd * Cdot : 0;
      EXPECT_LT(relative(found.f, -(k * C + kd * Cdot) * g), 1e-12);
      EXPECT_LT(relative(found.K, -(k * g * g.transpose() + kept * H)), 1e-12);
      EXPECT_LT(relative(found.D, -kd * g * g.transpose()), 1e-12);
    }
  } while (std::next_permutation(order.begin(), order.end()));
}

// Bridson's forces -------------------------------------------------------------------------------

// u_1 … u_4 as Bridson, Marino and Fedkiw print them, for the edge from x3 to x4 and x1, x2 opposite.
std::array<Vec3, 4> printed_u(const Vec3& x1, const Vec3& x2, const Vec3& x3, const Vec3& x4) {
  const Vec3 E = x4 - x3, N1 = (x1 - x3).cross(x1 - x4), N2 = (x2 - x4).cross(x2 - x3);
  const Vec3 n1 = N1 / N1.squaredNorm(), n2 = N2 / N2.squaredNorm();
  const double e = E.norm();
  return {e * n1, e * n2, (x1 - x4).dot(E) / e * n1 + (x2 - x4).dot(E) / e * n2,
          -(x1 - x3).dot(E) / e * n1 - (x2 - x3).dot(E) / e * n2};
}

// With (x1, x2, x3, x4) = (P0, P3, P1, P2), u is −∂θ/∂x.
TEST(Bridson, PrintedDirectionsAreTheGradientOfTheAngle) {
  for (const FoldCase& fold : all_folds(50)) {
    const auto [p0, p1, p2, p3] = points(fold.x);
    const auto [u0, u3, u1, u2] = printed_u(p0, p3, p1, p2);
    const VecX g = flat(angle_gradient(make_fold({p0, p1, p2, p3})));
    EXPECT_LT((flat({u0, u1, u2, u3}) + g).norm(), 1e-14 / fold.length * g.norm()) << fold.name;
    EXPECT_LT((u0 + u1 + u2 + u3).norm(), 1e-14 / fold.length * g.norm());
    EXPECT_LT(std::abs((u2 - u1).dot(p2 - p1)), 1e-13 / fold.length * g.norm());
  }
}

// k σ (sin(θ/2) − sin(θ0/2)) u: exactly our force for θ0 = 0, and for other θ0 our force times
// cos((θ + θ0)/4)/cos((θ − θ0)/4). Both are zero at the same fold, and have the same sign up to a full fold.
TEST(Bridson, PrintedForceIsOursUpToAKnownFactor) {
  for (const FoldCase& fold : all_folds(51))
    for (const double rest : {0.0, 0.6, -1.1}) {
      const double c = bridson_shape(fold.flat_hinge), theta = fold.theta;
      const VecX u = -flat(angle_gradient(make_fold(points(fold.x))));
      const VecX printed = k * c * (std::sin(theta / 2) - std::sin(rest / 2)) * u;
      const VecX ours =
          family_forces(one_hinge(hinge_near(theta, rest, c), k, BendModel::bridson), fold.x);
      const double factor = std::cos((theta + rest) / 4) / std::cos((theta - rest) / 4);
      EXPECT_GT(factor, 0);
      EXPECT_TRUE(rest != 0 || factor == 1);
      EXPECT_LT((printed - factor * ours).norm(), 1e-13 / fold.length * k * c * u.norm())
          << fold.name;
    }
}

// E = 2 k σ (1 − cos((θ − θ0)/2)): for small folds a hinge of stiffness k σ/2.
TEST(Bridson, EnergyIsThatOfItsForce) {
  for (const double theta : {-3.0, -0.5, 0.01, 1.0, 3.0}) {
    const Hinges hinges = one_hinge(hinge_near(theta, 0.2, 0.7), k, BendModel::bridson);
    EXPECT_NEAR(energy(hinges, flat(plain.folded(theta))),
                2 * k * 0.7 * (1 - std::cos((theta - 0.2) / 2)), 1e-14);
  }
}

// Quadratic bending ------------------------------------------------------------------------------

TEST(Quadratic, WeightsAddUpToZero) {
  for (const FoldCase& fold : all_folds(52)) {
    const QuadraticHinge hinge = quadratic(fold.flat_hinge);
    EXPECT_LT(std::abs(hinge.weight.sum()), 1e-15 * hinge.weight.cwiseAbs().maxCoeff());
  }
}

TEST(Quadratic, EveryAffineImageOfTheFlatHingeCostsNothing) {
  Random random(53);
  for (const FoldCase& fold : all_folds(54)) {
    const Mat3 A = Eigen::Map<const Mat3>(random.vector(9, 2).data());
    VecX x = flat(fold.flat_hinge.folded(0));
    for (int i = 0; i < 12; i += 3) x.segment<3>(i) = (A * x.segment<3>(i)).eval();
    const QuadraticHinges hinges = one_quadratic(fold.flat_hinge);
    const double size =
        hinges.elements[0].weight.cwiseAbs().maxCoeff() * x.norm() * hinges.elements[0].sqrt_weight;
    EXPECT_LT(energy(hinges, x), k * 1e-30 * size * size) << fold.name;
  }
}

// E = k 6|e|² sin²(θ/2)/(A0 + A1)
TEST(Quadratic, EnergyOfAFoldThatStretchesNothing) {
  for (const FoldCase& fold : all_folds(55)) {
    const double areas = two_areas(fold.flat_hinge) / 2, s = std::sin(fold.theta / 2);
    const double expected = k * 6 * s * s / areas;
    EXPECT_NEAR(energy(one_quadratic(fold.flat_hinge), fold.x), expected,
                1e-12 / fold.length * (expected + 1e-9))
        << fold.name;
  }
}

// Against k/2 · 3|e|²/(A0 + A1) θ², the angle's own energy with that weight: less for sharp folds.
TEST(Quadratic, SharpFoldsAreSofterThanTheirAngle) {
  for (const auto& [theta, ratio] :
       std::map<double, double>{{0.05, 0.9998}, {0.3, 0.9925}, {1, 0.919}, {2, 0.708}}) {
    const double by_angle = k / 2 * 6 / two_areas(plain) * theta * theta;
    EXPECT_NEAR(energy(one_quadratic(plain), flat(plain.folded(theta))) / by_angle, ratio, 5e-4);
  }
}

// f = −Q x with one Q everywhere, of rank one for each axis.
TEST(Quadratic, ForceIsLinear) {
  Random random(56);
  const QuadraticHinges hinges = one_quadratic(plain);
  const State here{random.vector(12, 1), VecX::Zero(12)}, there{random.vector(12, 1), here.v};
  const Evaluated a = assembled(hinges, here, Jacobian::definite);
  const Evaluated b = assembled(hinges, there, Jacobian::bw98);
  EXPECT_LT(relative(a.K, b.K), 1e-15);
  EXPECT_LT(relative(a.f, a.K * here.x), 1e-13);
  const VecX values = eigenvalues(-a.K);
  EXPECT_LT(values.head(9).cwiseAbs().maxCoeff(), 1e-14 * values[11]);
  EXPECT_GT(values[9], 0.99 * values[11]);
}

// Springs ----------------------------------------------------------------------------------------

// Two flaps of height H whose feet coincide: |x03| = 2 H cos(θ/2), and E = k H² θ⁴/32 for small θ.
// Twice the fold costs sixteen times the energy: there is hardly any resistance to small folds.
TEST(BendSprings, EnergyGrowsWithTheFourthPowerOfTheFold) {
  const double H = 0.5;
  const FlatHinge hinge = {H, 0.5, H, 0.5};
  BendSprings springs;
  springs.elements = {make_spring(0, 3, 2 * H)};
  springs.term<SpringBend>() = SpringBend(k);
  for (const double theta : {0.02, 0.05, 0.2}) {
    const double exact = 2 * k * H * H * std::pow(1 - std::cos(theta / 2), 2);
    const double E = energy(springs, flat(hinge.folded(theta)));
    EXPECT_NEAR(E / exact, 1, 1e-9);
    EXPECT_NEAR(E / (k * H * H * std::pow(theta, 4) / 32), 1, theta * theta / 24 + 1e-9);
  }
}

// The table of the lesson of step 5: the energy of a small fold, and the moment at half a turn. The
// heights are equal and share their foot, as the springs of the table ask.
template <class Family>
void expect_energy_and_moment(const FlatHinge& hinge, Family& family, double energy_at_small,
                              double moment_at_half_a_turn) {
  EXPECT_NEAR(energy(family, flat(hinge.folded(small_fold))) / energy_at_small, 1, 1e-4);
  const double theta = pi - 2e-5;  // at π itself the spring has no length
  const Vec3 along(-std::sin(theta), 0, -std::cos(theta));
  const VecX f = family_forces(family, flat(hinge.folded(theta)));
  EXPECT_NEAR(-f.tail<3>().dot(along) * hinge.height1, moment_at_half_a_turn, 1e-3);
}

TEST(BendModels, HaveTheEnergyAndTheMomentOfTheLesson) {
  const double d = 0.5, sigma = 1 / two_areas(FlatHinge{d, 0.5, d, 0.5}), theta = small_fold;
  const FlatHinge hinge = {d, 0.5, d, 0.5};
  Hinges dihedral = one_hinge(hinge_near(0), k);
  expect_energy_and_moment(hinge, dihedral, k / 2 * theta * theta, k * pi);
  Hinges bridson = one_hinge(hinge_near(0, 0, sigma), k, BendModel::bridson);
  expect_energy_and_moment(hinge, bridson, k * sigma / 4 * theta * theta, k * sigma);
  QuadraticHinges flatness = one_quadratic(hinge);
  expect_energy_and_moment(hinge, flatness, 3 * k * sigma * theta * theta, 0);
  BendSprings springs;
  springs.elements = {make_spring(0, 3, 2 * d)};
  springs.term<SpringBend>() = SpringBend(k);
  expect_energy_and_moment(hinge, springs, k * d * d / 32 * std::pow(theta, 4), 2 * k * d * d);
}

// What is absent ---------------------------------------------------------------------------------

TEST(Bend, AFamilyWithoutATermActsOnNothing) {
  Hinges hinges;
  hinges.elements = {hinge_near(0)};
  QuadraticHinges quadratic_hinges;
  quadratic_hinges.elements = {quadratic(plain)};
  const VecX x = flat(plain.folded(1));
  EXPECT_EQ(energy(hinges, x), 0);
  EXPECT_EQ(energy(quadratic_hinges, x), 0);
}

}  // namespace bend_models_test
