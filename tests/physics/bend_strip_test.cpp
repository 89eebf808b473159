// The stiffness of a strip of cloth that may warp across its width as it bends. It is softer than on a
// cylinder, because the twist of its cells takes a part of the bend from the hinges. Its stiffness B is that
// of the elastica that droops as much.
//
// One cell wide, with curvature κ along and twist τ, a strip with hinges of Baraff and Witkin has one
// hinge across and one on the diagonal in each cell, which see κ + τ and √2 τ:
//
//   E per area = k/2 ((κ + τ)² + 2 τ²),   least at τ = −κ/3:   2/3 k κ²/2
//
// The other two models weigh the diagonal twice as much: (κ + τ)² + 4 τ², least at τ = −κ/5, 4/5.
// The sign of τ follows the diagonal; where diagonals alternate, so does τ.
#include <gtest/gtest.h>

#include "cantilever.h"

namespace bend_strip_test {

// B of the strip over that of a cylinder along the grid.
double softened(const Cantilever& c, double Gamma) {
  const double droop = tips(c, {Gamma})[0].droop();
  return Gamma / gamma_of_droop(droop, 1.4 * Gamma);
}

struct Case {
  const char* name;
  BendModel bend_model;
  Diagonals diagonals;
  double exact;
};
void PrintTo(const Case& c, std::ostream* out) {
  *out << c.name;
}

class FreeStrip : public testing::TestWithParam<Case> {
 protected:
  Cantilever strip(int N, int across) const {
    Cantilever c;
    c.N = N;
    c.across = across;
    c.rows = Rows::free;
    c.diagonals = GetParam().diagonals;
    c.bend_model = GetParam().bend_model;
    c.membrane = 1e4;  // so soft that warping across is free, so stiff that stretch does not count
    return c;
  }
};
INSTANTIATE_TEST_SUITE_P(
    Models, FreeStrip,
    testing::Values(
        Case{"DihedralSame", BendModel::dihedral, Diagonals::same, 2.0 / 3},
        Case{"DihedralAlternating", BendModel::dihedral, Diagonals::alternating, 2.0 / 3},
        Case{"BridsonSame", BendModel::bridson, Diagonals::same, 0.8},
        Case{"BridsonAlternating", BendModel::bridson, Diagonals::alternating, 0.8},
        Case{"QuadraticSame", BendModel::quadratic, Diagonals::same, 0.8},
        Case{"QuadraticAlternating", BendModel::quadratic, Diagonals::alternating, 0.8}),
    [](const auto& test) { return std::string(test.param.name); });

// Near the clamp, on a length like its width h, a strip cannot warp. That is an error of first order; the
// hinges have one of second order. The limit of a + b h + c h² through three grids has neither.
TEST_P(FreeStrip, OneCellWideIsAsSoftAsTheTheorySays) {
  std::array<double, 3> B;
  for (int i = 0; i < 3; ++i) B[i] = softened(strip(16 << i, 1), 0.5);
  const double limit = (B[0] - 6 * B[1] + 8 * B[2]) / 3;
  std::printf("%s: N = 16, 32, 64: %.4f %.4f %.4f, limit %.4f\n", GetParam().name, B[0], B[1], B[2],
              limit);
  EXPECT_NEAR(limit / GetParam().exact, 1, 0.01);
  EXPECT_GT(B[0], B[1]);
  EXPECT_GT(B[1], B[2]);
}

// Wider strips, up to a quarter of their length.
TEST_P(FreeStrip, WiderIsBetweenThatAndTheCylinder) {
  std::printf("%s, N = 32:", GetParam().name);
  for (const int across : {1, 2, 4, 8}) {
    const double B = softened(strip(32, across), 0.5);
    std::printf("  %d wide %.4f", across, B);
    EXPECT_GT(B, 0.6);
    EXPECT_LT(B, 1);
  }
  std::printf("\n");
}

}  // namespace bend_strip_test
