// The numbers and claims of the elasticity note (notes 004 in the bibliography), computed again: energies,
// stresses, forces, the two programs that relax a triangle, and the one that finds 58 %.
// elasticity_matrix_test.cpp has the implicit part. Each test says what the note prints and what is right.
//
// The note has no α. Its ψ is per area at rest, and so is the cloth's: both have the same μ and λ.
#include <gtest/gtest.h>

#include "plane.h"
#include "support/differences.h"

namespace elasticity_test {

using namespace plane;

const Rest unit_rest = {Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)};
const Moduli two = {2, 2};  // the note's μ and λ
const Mat2 I = Mat2::Identity();
const Mat2 stretched = diagonal(2, 1);
const Mat2 sheared = matrix(1.2, 0.3, 0, 0.9);

void expect_close(const Eigen::MatrixXd& actual, const Eigen::MatrixXd& expected,
                  double tolerance = 1e-14) {
  EXPECT_LT((actual - expected).norm(), tolerance) << "got\n" << actual << "\nnot\n" << expected;
}

Nodal<2> columns(const Vec2& f0, const Vec2& f1, const Vec2& f2) {
  return (Nodal<2>() << f0, f1, f2).finished();
}

// Worked numbers ----------------------------------------------------------------------------------

// The note: the Dirichlet energy |F|² of a triangle that only moved is 2, and so useless. Right; minus 2 it
// is negative for a triangle that shrank. (The note's sums run over the indices 0 to 2; F has 0 and 1.)
TEST(Notes004, DirichletEnergyIsTwoAtRestAndLessThanThatBelow) {
  EXPECT_EQ(I.squaredNorm(), 2);
  EXPECT_EQ((0.5 * I).squaredNorm() - 2, -1.5);
}

// The note: ε = diag(1, 0), ψ = μ + λ/2, which is 3. Right. It is a density: the triangle stores 1.5.
TEST(Notes004, LinearEnergyOfAStretchedTriangle) {
  expect_close(small_strain(stretched), diagonal(1, 0));
  EXPECT_NEAR(linear.psi(two, stretched), 3, 1e-15);
  EXPECT_NEAR(linear.psi({5, 7}, stretched), 5 + 7 / 2.0, 1e-14);
  EXPECT_NEAR(cloth_psi("linear", two, stretched), 3, 1e-14);
  const Cloth one = cloth(unit_rest, "linear", two);
  EXPECT_NEAR(energy(one.triangles, plane::positions(unit_rest, stretched)), 1.5, 1e-14);
}

// The note: P = diag(6, 2), f0 = (3, 1), f1 = (−3, 0), f2 = (0, −1). Right, and the cloth has these forces.
TEST(Notes004, LinearForcesOfAStretchedTriangle) {
  const Mat2 P = linear.P(two, stretched);
  expect_close(P, diagonal(6, 2));
  const Nodal<2> f = columns({3, 1}, {-3, 0}, {0, -1});
  expect_close(nodal_forces(unit_rest, P), f);
  expect_close(cloth_forces(unit_rest, "linear", two, stretched), f);
}

// The note writes E into the formula of that P, the letter of Green's strain. With Green's strain, StVK, the
// numbers are others: E = diag(1.5, 0), ψ = 6.75, P = diag(18, 3). So StVK pulls three times as hard.
TEST(Notes004, StvkOfTheSameTriangleHasOtherNumbers) {
  expect_close(green_strain(stretched), diagonal(1.5, 0));
  EXPECT_NEAR(stvk.psi(two, stretched), 6.75, 1e-14);
  EXPECT_NEAR(cloth_psi("stvk", two, stretched), 6.75, 1e-14);
  expect_close(stvk.P(two, stretched), diagonal(18, 3));
  const Nodal<2> f = columns({9, 1.5}, {-9, 0}, {0, -1.5});
  expect_close(nodal_forces(unit_rest, stvk.P(two, stretched)), f);
  expect_close(cloth_forces(unit_rest, "stvk", two, stretched), f);
}

// The note: a rotation by 90° has ε = (−1 −1; 1 −1) and costs 4μ + 4 λ/2, which is 12. That is F − I; its
// symmetric part is ε = −I, and it costs 2μ + 2λ, which is 8.
TEST(Notes004, ARotationByAQuarterTurnCostsTwoMuAndTwoLambda) {
  const Mat2 R = rotation(pi / 2);
  expect_close(R - I, matrix(-1, -1, 1, -1));
  EXPECT_NEAR(psi(two, R - I), 12, 1e-14);

  expect_close(small_strain(R), -I);
  EXPECT_NEAR(linear.psi(two, R), 8, 1e-14);
  EXPECT_NEAR(linear.psi({5, 7}, R), 2 * 5 + 2 * 7, 1e-13);
  EXPECT_NEAR(cloth_psi("linear", two, R), 8, 1e-14);
  EXPECT_NEAR(cloth_psi("stvk", two, R), 0, 1e-14);
}

// Turned by any θ the linear model stores 2 κ (1 − cos θ)² per area, κ = λ + μ. All others store nothing.
TEST(Notes004, OnlyTheLinearModelTakesARotationForAStrain) {
  for (const Moduli& m : {Moduli{2, 2}, Moduli{5, 7}, Moduli{3, 0}})
    for (const double theta : {0.1, 1.0, pi, -2.0}) {
      const double false_energy = 2 * m.kappa() * std::pow(1 - std::cos(theta), 2);
      EXPECT_NEAR(linear.psi(m, rotation(theta)), false_energy, 1e-13) << theta;
      for (const std::string& name : membrane_names())
        EXPECT_NEAR(cloth_psi(name, m, rotation(theta)), name == "linear" ? false_energy : 0, 1e-13)
            << name << " at " << theta;
    }
}

// Stress and forces ------------------------------------------------------------------------------

VecX flat(const Mat2& A) {
  return A.reshaped();
}
Mat2 square(const VecX& a) {
  return a.reshaped(2, 2);
}

// The note: P = ∂ψ/∂F. Right for both models.
TEST(Notes004, StressIsTheSlopeOfTheEnergy) {
  for (const Material& material : {linear, stvk})
    EXPECT_TRUE(is_slope(
        [&](const VecX& F) {
          return VecX::Constant(1, material.psi({5, 7}, square(F)));
        },
        [&](const VecX& F) -> MatX {
          return flat(material.P({5, 7}, square(F))).transpose();
        },
        flat(sheared), 1))
        << material.name;
}

// The third statement: −P (Σ l N)/2 with the lengths l and the outward normals N, both at rest, of the two
// edges that end in the vertex.
Nodal<2> forces_of_normals(const Rest& rest, const Mat2& P, double divisor) {
  const double winding = rest_edges(rest).determinant() > 0 ? 1 : -1;
  const auto length_times_normal = [&](int from, int to) -> Vec2 {
    const Vec2 edge = rest[size_t(to)] - rest[size_t(from)];
    return winding * Vec2(edge.y(), -edge.x());
  };
  Nodal<2> f;
  for (int i = 0; i < 3; ++i) {
    const int next = (i + 1) % 3, last = (i + 2) % 3;
    f.col(i) = -P * (length_times_normal(last, i) + length_times_normal(i, next)) / divisor;
  }
  return f;
}

// The note has three statements of the nodal force: H = −a P Dm⁻ᵀ; G = P B with B = −a Dm⁻ᵀ; and by normals.
// They agree, they are −∂(aψ)/∂x, and the three conditions of the cloth's membrane give the same forces.
// (The note's fourth one, f = ∇P, is a slip: f = −a P : ∂F/∂x.)
TEST(Notes004, StatementsOfTheNodalForceAgreeWithEachOtherAndWithTheConditions) {
  Random random(81);
  for (int n = 0; n < 20; ++n)
    for (const Material& material : {linear, stvk}) {
      const Rest rest = random_rest(random);
      const Mat2 F = square(random.vector(4, 1.5));
      const Mat2 P = material.P(two, F), Dm = rest_edges(rest);
      const double area = std::abs(Dm.determinant()) / 2;
      const Nodal<2> f = nodal_forces(rest, P);
      const double rounding = 1e-13 * (1 + f.norm());

      const Mat2 B = -area * Dm.inverse().transpose();
      expect_close(P * B, f.rightCols<2>(), rounding);
      expect_close(forces_of_normals(rest, P, 2), f, rounding);
      expect_close(cloth_forces(rest, material.name, two, F), f, rounding);

      const auto energy_at = [&](const VecX& x) {
        const Mat2 Ds =
            (Mat2() << x.segment<2>(2) - x.head<2>(), x.tail<2>() - x.head<2>()).finished();
        return VecX::Constant(1, area * material.psi(two, Ds * Dm.inverse()));
      };
      const VecX x = (F * (Nodal<2>() << rest[0], rest[1], rest[2]).finished()).reshaped();
      const auto slope = [&](const VecX&) -> MatX { return -f.reshaped().transpose(); };
      EXPECT_TRUE(is_slope(energy_at, slope, x, std::sqrt(area))) << material.name;
    }
}

// The note divides the normals by 3. That is for tetrahedra, whose faces have three corners. An edge has two:
// divided by 3 the forces of a triangle are 2/3 of the right ones.
TEST(Notes004, NormalsOfATriangleAreDividedByTwo) {
  const Mat2 P = linear.P(two, stretched);
  const Nodal<2> f = columns({3, 1}, {-3, 0}, {0, -1});
  expect_close(forces_of_normals(unit_rest, P, 2), f);
  expect_close(forces_of_normals(unit_rest, P, 3), 2 / 3.0 * f);
}

// The note quotes a library in the section on linear elasticity. Its strain is Green's, and its "force" J is
// the slope of the energy, +a P Dm⁻ᵀ.
TEST(Notes004, QuotedStrainIsGreensAndQuotedForceIsTheSlope) {
  const Mat2& F = sheared;
  const double quoted = 0.5 * (F(0, 0) * F(0, 0) + F(1, 0) * F(1, 0) - 1);
  EXPECT_NEAR(quoted, green_strain(F)(0, 0), 1e-15);
  EXPECT_GT(std::abs(quoted - small_strain(F)(0, 0)), 0.01);
  const Mat2 sigma = stvk.P(two, F), J = sigma * 0.5;
  expect_close(J, -nodal_forces(unit_rest, sigma).rightCols<2>());
}

// The note: E = (F Fᵀ − I)/2 and P = F (2μE + λ tr E I). The energy is the same as with FᵀF. But P is not its
// slope. Right are F S(FᵀF) and, equal to it, S(FFᵀ) F.
TEST(Notes004, StrainFromTheWrongSideHasTheSameEnergyAndAWrongStress) {
  const Mat2 left = (sheared * sheared.transpose() - I) / 2, right = green_strain(sheared);
  EXPECT_NEAR(psi(two, left), psi(two, right), 1e-15);
  const Mat2 P = stvk.P(two, sheared);
  expect_close(stress(two, left) * sheared, P);
  const Mat2 printed = sheared * stress(two, left);
  EXPECT_NEAR((printed - P).norm() / P.norm(), 0.193, 5e-4);

  // Turn the triangle: its stress turns with it, RP. The printed one does not.
  const Mat2 R = rotation(1);
  expect_close(stvk.P(two, R * sheared), R * P);
  const Mat2 F = R * sheared, turned = F * stress(two, (F * F.transpose() - I) / 2);
  EXPECT_GT((turned - R * printed).norm(), 0.1 * P.norm());
}

// The programs that relax a triangle -------------------------------------------------------------

// The note's loop: x_i += 0.1 ψ/Σ|f|² f_i, from the triangle stretched to F = diag(2, 1), until Σ|f|² <
// 1e-10. It solves for ψ = 0, as position based dynamics does; no time passes in it.
struct Relaxed {
  Nodal<2> x;
  int iterations;  // the last one included, which finds that it is done

  Mat2 F() const { return (Mat2() << x.col(1) - x.col(0), x.col(2) - x.col(0)).finished(); }
  double area() const { return F().determinant() / 2; }
};

template <class Energy, class Stress>
Relaxed relax(int limit, const Energy& energy, const Stress& P) {
  Relaxed r{columns({0, 0}, {2, 0}, {0, 1}), 0};
  while (r.iterations < limit) {
    ++r.iterations;
    const Nodal<2> f = nodal_forces(unit_rest, P(r.F()));
    if (f.squaredNorm() < 1e-10) break;
    r.x += 0.1 * energy(r.F()) / f.squaredNorm() * f;
  }
  return r;
}
Relaxed relax(int limit, const Material& material) {
  return relax(
      limit, [&](const Mat2& F) { return material.psi(two, F); },
      [&](const Mat2& F) { return material.P(two, F); });
}

// The note: the linear program does not give the right result. Right, and this is what it gives: its ψ is
// zero for every F whose symmetric part is I. It ends at F = (1 −¼; ¼ 1), whose area is 6.25 % too large.
TEST(Notes004, LinearRelaxationEndsInATriangleThatIsTooLarge) {
  const Relaxed after = relax(100, linear);
  expect_close(after.x, columns({0.41667, -0.08333}, {1.41668, 0.16665}, {0.16665, 0.91668}), 2e-5);
  EXPECT_NEAR(after.area(), 0.53126, 5e-6);

  const Relaxed end = relax(1000, linear);
  EXPECT_EQ(end.iterations, 121);
  expect_close(end.F(), matrix(1, -0.25, 0.25, 1), 1e-5);
  EXPECT_NEAR(end.area(), 0.5 * (1 + 1 / 16.0), 1e-5);
}

// StVK, with F S(FᵀF) and its own ψ: the triangle is at rest, turned by 11.6°.
TEST(Notes004, StvkRelaxationEndsInATurnedTriangleAtRest) {
  const Relaxed end = relax(1000, stvk);
  EXPECT_EQ(end.iterations, 125);
  expect_close(end.x, columns({0.4071, -0.0602}, {1.3867, 0.1407}, {0.2062, 0.9195}), 1.5e-4);
  const double angle = std::atan2(end.F()(1, 0), end.F()(0, 0));
  EXPECT_NEAR(angle * 180 / pi, 11.6, 0.05);
  expect_close(end.F(), rotation(angle), 1e-5);
}

// The note's StVK program exchanges three lines of the linear one. Its E is that of the wrong side, and its
// energy still reads the linear strain. After 100 iterations it is not at rest, and later it diverges.
TEST(Notes004, PrintedStvkProgramDiverges) {
  const auto E = [](const Mat2& F) -> Mat2 { return (F * F.transpose() - I) / 2; };
  const auto printed_energy = [&](const Mat2& F) {
    return two.mu * small_strain(F).squaredNorm() + two.lambda / 2 * std::pow(E(F).trace(), 2);
  };
  const auto printed_P = [&](const Mat2& F) -> Mat2 { return F * stress(two, E(F)); };
  const Relaxed after = relax(100, printed_energy, printed_P);
  EXPECT_EQ(after.iterations, 100);
  expect_close(after.x, columns({0.401, -0.065}, {1.401, 0.150}, {0.199, 0.915}), 1.5e-3);
  EXPECT_NEAR(2 * green_strain(after.F()).cwiseAbs().maxCoeff(), 4.6e-2, 5e-4);
  EXPECT_GT(green_strain(relax(20000, printed_energy, printed_P).F()).norm(), 1);
}

// The note's end state of StVK. It is that of a program whose stress lost its leading F: with a P that is
// symmetric, x1.y and x2.x get the same increments, and remain equal. A rotation with this property, and with
// the centre of the start, has F10 = 1/4 exactly: these are the note's digits, cut off after three.
TEST(Notes004, PublishedStvkEndStateIsThatOfAStressWithoutItsLeadingF) {
  const auto S = [](const Mat2& F) { return stress(two, green_strain(F)); };
  const Relaxed end = relax(
      1000, [](const Mat2& F) { return stvk.psi(two, F); }, S);
  const double c = std::sqrt(15) / 4, s = 0.25;
  expect_close(end.F(), matrix(c, -s, s, c), 1e-5);

  const auto cut = [](double number) { return std::trunc(1000 * number) / 1000; };
  const Nodal<2> exact =
      columns({(2 - c + s) / 3, (1 - s - c) / 3}, {(2 + 2 * c + s) / 3, (1 + 2 * s - c) / 3},
              {(2 - 2 * s - c) / 3, (1 - s + 2 * c) / 3});
  expect_close(end.x, exact, 1e-5);
  expect_close(exact.unaryExpr(cut), columns({0.427, -0.072}, {1.395, 0.177}, {0.177, 0.895}));
  expect_close(matrix(c, -s, s, c).unaryExpr(cut), matrix(0.968, -0.250, 0.250, 0.968));
  EXPECT_GT((exact - relax(1000, stvk).x).norm(), 0.05) << "not that of StVK";
}

// Forces inside a body cannot turn it. Those of a stress without its leading F do.
TEST(Notes004, AStressWithoutItsLeadingFHasATorque) {
  const auto torque = [](const Mat2& P) {
    const Nodal<2> x =
        sheared * (Nodal<2>() << unit_rest[0], unit_rest[1], unit_rest[2]).finished();
    const Nodal<2> f = nodal_forces(unit_rest, P);
    return (x.row(0).cwiseProduct(f.row(1)) - x.row(1).cwiseProduct(f.row(0))).sum();
  };
  EXPECT_NEAR(torque(stvk.P(two, sheared)), 0, 1e-15);
  EXPECT_NEAR(torque(stress(two, green_strain(sheared))), -0.129, 5e-4);
}

// 58 % -------------------------------------------------------------------------------------------

// The note's program squeezes F = diag(1, i/100) and finds its largest |P22| at i = 58. Right. (The loop
// needs an indent; its E has no ½ and its μ and λ are 1, so that P22 is 3 s (s² − 1).)
TEST(Notes004, ProgramFindsItsPeakAtFiftyEight) {
  const auto P22 = [](int i) {
    const Mat2 F = diagonal(1, i / 100.0), E = F * F.transpose() - I;
    return (F * (2 * E + E.trace() * I))(1, 1);
  };
  int peak = 0;
  for (int i = 0; i < 100; ++i)
    if (std::abs(P22(i)) > std::abs(P22(peak))) peak = i;
  EXPECT_EQ(peak, 58);
  EXPECT_NEAR(-P22(57), 1.15442, 5e-6);
  EXPECT_NEAR(-P22(58), 1.15466, 5e-6);
  EXPECT_NEAR(-P22(59), 1.15386, 5e-6);
}

// P of the cloth, from its forces on the unit triangle: [f1 f2] = −P/2.
Mat2 cloth_P(const Moduli& m, const Mat2& F) {
  return -2 * cloth_forces(unit_rest, "stvk", m, F).rightCols<2>();
}
// The s in (0, 1) at which a force has its largest value: the interval shrinks by a third each time.
template <class Force>
double peak(const Force& force) {
  double low = 0, high = 1;
  while (high - low > 1e-9) {
    const double a = low + (high - low) / 3, b = high - (high - low) / 3;
    (force(a) < force(b) ? low : high) = force(a) < force(b) ? a : b;
  }
  return low;
}

// The note: StVK's force rises as long as the area changes by 0 to 58 %. Right is: pressed along one axis it
// rises until the length that remains is 1/√3, which is 57.7 %, whatever μ and λ are, and whether the sides
// are held, free or pressed alike. The area that remains is 1/√3, more, or 1/3. With free sides the largest
// force per width is √3/9 E.
TEST(Notes004, PressedStvkIsStrongestAtOneOverRootThree) {
  const double s = 1 / std::sqrt(3);
  for (const Moduli& m : {Moduli{2, 2}, Moduli{5, 0}, Moduli{3, 11}}) {
    const auto held = [&](double length) { return -cloth_P(m, diagonal(1, length))(1, 1); };
    EXPECT_NEAR(peak(held), s, 1e-7);
    EXPECT_NEAR(held(s), (2 * m.mu + m.lambda) / 2 * s * (1 - s * s), 1e-13);

    const auto with_free_sides = [&](double length) {
      const double E11 = -m.lambda / (2 * m.mu + m.lambda) * (length * length - 1) / 2;
      return diagonal(std::sqrt(1 + 2 * E11), length);
    };
    const auto free = [&](double length) { return -cloth_P(m, with_free_sides(length))(1, 1); };
    EXPECT_NEAR(cloth_P(m, with_free_sides(s))(0, 0), 0, 1e-13);
    EXPECT_NEAR(peak(free), s, 1e-7);
    EXPECT_NEAR(free(s), std::sqrt(3) / 9 * m.E(), 1e-13);

    const auto alike = [&](double length) { return -cloth_P(m, diagonal(length, length))(1, 1); };
    EXPECT_NEAR(peak(alike), s, 1e-7);
    EXPECT_NEAR(alike(s), m.kappa() * s * (1 - s * s), 1e-13);
  }
  EXPECT_NEAR(s, 0.577, 5e-4);
  const double E11 = -1 / 3.0 * (s * s - 1) / 2;  // μ = λ
  EXPECT_NEAR(s * std::sqrt(1 + 2 * E11), 0.638, 5e-4) << "area that remains with free sides";
}

// With the side held at t ≠ 1 the peak is elsewhere: s² = (1 − λ (t² − 1)/(2μ + λ))/3.
TEST(Notes004, ASideHeldStretchedMovesThePeak) {
  const Moduli m = {3, 4};
  for (const double t : {0.8, 1.2}) {
    const double s = std::sqrt((1 - m.lambda * (t * t - 1) / (2 * m.mu + m.lambda)) / 3);
    EXPECT_NEAR(peak([&](double length) { return -cloth_P(m, diagonal(t, length))(1, 1); }), s,
                1e-7);
  }
}

// Stretched, StVK has no such limit: its force grows with the third power of the length.
TEST(Notes004, StretchedStvkGetsStifferAndStiffer) {
  double last = 0;
  for (double s = 1.1; s < 4; s += 0.1) {
    const double pull = cloth_P(two, diagonal(1, s))(1, 1);
    EXPECT_NEAR(pull, 3 * s * (s * s - 1), 1e-12);
    EXPECT_GT(pull, last);
    last = pull;
  }
}

// The note: StVK ignores the sign of the area. Right: at a line it has no force, and beyond it pushes on, to
// the reflected triangle, which it takes to be at rest. In space that triangle is only turned over.
TEST(Notes004, StvkPushesAnInvertedTriangleOn) {
  const auto push = [](double s) { return -cloth_P(two, diagonal(1, s))(1, 1); };
  EXPECT_GT(push(0.1), 0);
  EXPECT_EQ(push(0), 0);
  EXPECT_LT(push(-0.1), 0);
  EXPECT_NEAR(push(-1), 0, 1e-14);
  EXPECT_EQ(cloth_psi("stvk", two, diagonal(1, -1)), 0);
}

// The energy per area of a triangle that is squeezed to a line, and to a point. It is finite in all models but
// the one with a barrier: a force that is large enough collapses such a cloth. At a point StVK stores a quarter
// of what corotated stores.
TEST(Notes004, OnlyTheBarrierKeepsAClothFromCollapse) {
  const Moduli m = {3, 4}, no_lambda = {3, 0};
  const Mat2 line = diagonal(1, 0), point = Mat2::Zero();
  EXPECT_NEAR(cloth_psi("stvk", m, line), m.mu / 4 + m.lambda / 8, 1e-13);
  EXPECT_NEAR(cloth_psi("linear", m, line), m.mu + m.lambda / 2, 1e-13);
  EXPECT_NEAR(cloth_psi("corotated", m, line), m.mu + m.lambda / 2, 1e-7);
  EXPECT_NEAR(cloth_psi("arap", no_lambda, line), no_lambda.mu, 1e-7);
  EXPECT_NEAR(cloth_psi("neo-hookean", m, line), m.kappa() / 2 + m.mu / 2, 1e-7);
  EXPECT_GT(cloth_psi("neo-hookean-barrier", m, line), 100 * m.kappa());

  // J is smoothed to 1e-9, and the trace of √(FᵀF) to √2e-9.
  const double smoothed = 2e-4 * m.kappa();
  EXPECT_NEAR(cloth_psi("stvk", m, point), m.kappa() / 2, 1e-13);
  EXPECT_NEAR(cloth_psi("linear", m, point), 2 * m.kappa(), 1e-13);
  EXPECT_NEAR(cloth_psi("corotated", m, point), 2 * m.kappa(), smoothed);
  EXPECT_NEAR(cloth_psi("arap", no_lambda, point), 2 * no_lambda.mu, smoothed);
  EXPECT_NEAR(cloth_psi("neo-hookean", m, point), m.kappa() / 2, smoothed);
  EXPECT_GT(cloth_psi("neo-hookean-barrier", m, point), 100 * m.kappa());
}

}  // namespace elasticity_test
