// A net of springs as a sheet: its elastic constants by differences of the energy. With the strains e1 and e2
// along u and v, and the shear e6, the change of the angle between them,
//
//   ψ = ½ Σ C_ij e_i e_j        energy per area
//
// On square cells with the stiffness k along the edges, kd on the diagonals and kb between vertices that are
// two cells apart, whatever the size of a cell:
//
//                    C11 = C22       C12 = C66   C16 = C26
//   one diagonal     k + kd/2        kd/2        ± kd/2      by the direction of the diagonal
//   two diagonals    k + kd          kd          0
//   two apart        4 kb more       –           –
//
// Springs act along their own line, so a net cannot have C12 and C66 apart: C12 = C66, Cauchy's relation.
#include <gtest/gtest.h>

#include "math/energy.h"
#include "sheets.h"

namespace spring_net_test {

constexpr double k = 10, kd = 4, kb = 1;  // N/m
constexpr double size = 1.5;              // m

struct Net {
  Net(const SpringTerm& term, int cells, Diagonals diagonals = Diagonals::same)
      : scene(scene_of(make_grid({size, size}, {cells, cells}, diagonals), Model().add(term),
                       Gravity::off)) {}

  // Where (u, v) lies at u w_u + v w_v, in the plane: energy per area.
  double psi(const Vec2& wu, const Vec2& wv) const {
    const VecX x = field(scene.mesh, [&](double u, double v) {
      const Vec2 at = u * wu + v * wv;
      return Vec3(at.x(), 0, -at.y());
    });
    return potential_energy(scene.cloth, x) / (size * size);
  }
  double psi(const Vec3& e) const {
    return psi(Vec2(1 + e[0], e[2] / 2), Vec2(e[2] / 2, 1 + e[1]));
  }
  // C_ij, by differences of second order.
  Mat3 constants() const {
    const double d = 1e-4;
    Mat3 C;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        const Vec3 a = d * Vec3::Unit(i), b = d * Vec3::Unit(j);
        C(i, j) = (psi(a + b) - psi(a - b) - psi(b - a) + psi(-a - b)) / (4 * d * d);
      }
    return C;
  }

  TestScene scene;
};

Mat3 constants(double C11, double C12, double C16) {
  return (Mat3() << C11, C12, C16, C12, C11, C16, C16, C16, C12).finished();
}

void expect_constants(const char* name, const Mat3& C, const Mat3& exact) {
  std::printf("%-28s C11 %.6f, C22 %.6f, C12 %.6f, C66 %.6f, C16 %+.6f, C26 %+.6f\n", name, C(0, 0),
              C(1, 1), C(0, 1), C(2, 2), C(0, 2), C(1, 2));
  EXPECT_LT((C - exact).cwiseAbs().maxCoeff(), 2e-6) << name;
}

SpringTerm one_diagonal() {
  SpringTerm term = springs(k, kd);
  term.both_diagonals = false;
  return term;
}

TEST(ElasticConstants, OfANetAreThoseOfItsSprings) {
  for (const int cells : {2, 6}) {
    expect_constants("edges", Net(springs(k), cells).constants(), constants(k, 0, 0));
    expect_constants("one diagonal, along (-1, 1)", Net(one_diagonal(), cells).constants(),
                     constants(k + kd / 2, kd / 2, -kd / 2));
    expect_constants("one diagonal, alternating",
                     Net(one_diagonal(), cells, Diagonals::alternating).constants(),
                     constants(k + kd / 2, kd / 2, 0));
    expect_constants("two diagonals", Net(springs(k, kd), cells).constants(),
                     constants(k + kd, kd, 0));
  }
}

// Of n cells in a row, n − 1 springs are two cells long. So the constants approach 18, 4 and 0 as 1/n.
TEST(ElasticConstants, OfSpringsTwoCellsLongAreFourTimesTheirStiffness) {
  for (const int cells : {4, 8, 16})
    expect_constants("two diagonals, two apart", Net(springs(k, kd, kb), cells).constants(),
                     constants(k + kd + 4 * kb * (1 - 1.0 / cells), kd, 0));
}

TEST(ElasticConstants, OfTheTrianglesOfAMeshAreThoseOfOneDiagonal) {
  SpringTerm term(k);
  term.on_grid = false;
  expect_constants("edges of a mesh", Net(term, 4).constants(), constants(1.5 * k, k / 2, -k / 2));
}

TEST(ElasticConstants, OfEveryNetKeepCauchysRelation) {
  SpringTerm mesh(k);
  mesh.on_grid = false;
  mesh.apart = kb;
  for (const SpringTerm& term : {springs(k, kd, kb), one_diagonal(), mesh})
    for (const Diagonals diagonals : {Diagonals::same, Diagonals::alternating}) {
      const Mat3 C = Net(term, 5, diagonals).constants();
      EXPECT_NEAR(C(0, 1), C(2, 2), 2e-6);
    }
}

// With free sides:   E = C11 − C12²/C11
TEST(ElasticConstants, OfTwoDiagonalsMakeYoungsModulus) {
  const Sheet sheet = spring_sheet("", k, kd);
  const double d = 1e-4, E = (sheet.pull(1 + d) - sheet.pull(1 - d)) / (2 * d);
  std::printf("E = %.6f\n", E);
  EXPECT_NEAR(E, k + kd - kd * kd / (k + kd), 1e-6);
}

// A trellis: u and v keep their lengths, and the angle between them changes by θ. A diagonal with the length
// h √(2 ± 2 sin θ) resists one way more than the other. Shear of [shear] does not:
//
//   one diagonal   kd/2 (√(2 ∓ 2 sin θ) − √2)²      [shear]   kd/2 sin² θ
TEST(Trellis, OfOneDiagonalResistsOneWayMore) {
  const auto sheared = [](const Net& net, double angle) {
    const double c = std::cos(angle / 2), s = std::sin(angle / 2);
    return net.psi(Vec2(c, s), Vec2(s, c));
  };
  Net threads(springs(k), 3);
  threads.scene = scene_of(threads.scene.mesh, Model().add(ShearTerm(kd)), Gravity::off);
  const Net one(one_diagonal(), 3), two(springs(k, kd), 3);
  for (const double angle : {0.3, -0.3})
    std::printf("%+.1f: one diagonal %.6f, two %.6f, [shear] %.6f J/m²\n", angle,
                sheared(one, angle), sheared(two, angle), sheared(threads, angle));
  EXPECT_NEAR(sheared(one, 0.3), 0.103256, 5e-7);
  EXPECT_NEAR(sheared(one, -0.3), 0.076407, 5e-7);
  for (const double angle : {0.3, -0.3}) {
    const double diagonal = std::sqrt(2 - 2 * std::sin(angle)) - std::sqrt(2);
    EXPECT_NEAR(sheared(one, angle), kd / 2 * diagonal * diagonal, 1e-12);
    EXPECT_NEAR(sheared(two, angle), 0.179663, 5e-7);
    EXPECT_NEAR(sheared(threads, angle), 0.174664, 5e-7);
  }
}

// A fold by θ across a spring of two cells shortens it from 2h to 2h cos(θ/2):
//
//   2 kb h² (1 − cos(θ/2))² = kb h² θ⁴/32 + …
//
// A spring resists small folds not at all: its energy is of order 4, where that of a hinge is of order 2. A
// grid of two cells by two has the springs of two whole rows across its fold.
TEST(Fold, OfACrossSpringCostsTheFourthPowerOfItsAngle) {
  const Net net(springs(k, 0, kb), 2);
  const auto folded = [&](double angle) {
    const double h = size / 2, c = std::cos(angle), s = std::sin(angle);
    const VecX x = field(net.scene.mesh, [&](double u, double v) {
      return u > h ? Vec3(h + (u - h) * c, (u - h) * s, -v) : Vec3(u, 0, -v);
    });
    return potential_energy(net.scene.cloth, x) / (2 * kb * h * h);
  };
  std::printf("0.05: %.6e, 0.3: %.6e\n", folded(0.05), folded(0.3));
  EXPECT_NEAR(folded(0.05), 1.952922e-7, 5e-14);
  EXPECT_NEAR(folded(0.3), 2.521774e-4, 5e-11);
  EXPECT_NEAR(std::log2(folded(0.1) / folded(0.05)), 4, 0.002);
}

}  // namespace spring_net_test
