// Cloths of every model at rest under their weight, against exact curves.
#include <gtest/gtest.h>

#include "sheets.h"
#include "support/statics.h"

namespace membrane_statics_test {

constexpr double L = 1, w = density * g;  // m; N/m², the weight per area

// A strip in the plane z = 0, with its top, v = 1, at y = 0.
TestScene vertical_strip(const Sheet& sheet, double width, const std::array<int, 2>& cells) {
  TestScene scene =
      scene_of(make_grid({width, L}, cells, Diagonals::same), sheet.model, Gravity::on);
  lay(scene, [](double u, double v) { return Vec3(u, v - L, 0); });
  return scene;
}

// Which coordinates of the strip move together. `level`: the rows stay level, and their width is free, at the
// top as well. `pinned`: every vertex moves in the plane of the strip, and the top is pinned.
enum class Rows { level, pinned };

std::vector<std::vector<int>> unknowns(const Grid& grid, Rows rows) {
  const auto [columns, top] = grid.cells;
  const auto x = [&](int i, int j) { return 3 * grid.vertex(i, j); };
  std::vector<std::vector<int>> all;
  if (rows == Rows::level)
    for (int j = 0; j <= top; ++j) {
      all.push_back({x(1, j)});
      if (j < top) all.push_back({x(0, j) + 1, x(1, j) + 1});
    }
  else
    for (int j = 0; j < top; ++j)
      for (int i = 0; i <= columns; ++i)
        for (const int axis : {0, 1}) all.push_back({x(i, j) + axis});
  return all;
}

// The mean elongation of the strip at rest, by Newton's method from a uniform stretch.
double elongation(const TestScene& scene, Rows rows, double stretch) {
  const Grid& grid = *scene.mesh.grid;
  VecX x = scene.start.x;
  for (int i = 1; i < x.size(); i += 3) x[i] *= stretch;
  x = equilibrium(scene.cloth, freedom(x.size(), unknowns(grid, rows)), x);
  double lowest = 0;
  for (int i = 0; i <= grid.cells[0]; ++i) lowest += x[3 * i + 1] / (grid.cells[0] + 1);
  return -lowest - L;
}

// At the distance s from the lower end the strip carries the weight w s. With its sides free it is stretched
// there as the uniaxial law says:
//
//   elongation = ∫ (λ(w s) − 1) ds,   pull(λ) = w s           by Simpson's rule
double exact_elongation(const Sheet& sheet) {
  constexpr int n = 40;
  double sum = 0;
  for (int i = 0; i <= n; ++i) {
    const double weight = i == 0 || i == n ? 1 : i % 2 == 1 ? 4 : 2;
    sum += weight * (sheet.stretch_under(w * L * i / n) - 1);
  }
  return sum * L / (3 * n);
}

// The strip is one cell wide, and so the narrower the finer it is.
TEST(HangingStrip, OfEveryModelIsLongerByTheIntegralOfItsUniaxialLaw) {
  for (const double E : {10.0, 100.0})
    for (const Sheet& sheet : all_sheets(E)) {
      SCOPED_TRACE(sheet.name);
      const double exact = exact_elongation(sheet);
      std::printf("%-28s E = %3.0f: exact %.8f", sheet.name.c_str(), E, exact);
      std::array<double, 3> error;
      for (const int i : {0, 1, 2}) {
        const int rows = 8 << i;
        const TestScene scene = vertical_strip(sheet, L / rows, {1, rows});
        error[i] = elongation(scene, Rows::level, 1 + exact) / exact - 1;
        std::printf("  %+.2e", error[i]);
      }
      std::printf("  order %.2f\n", std::log2(error[1] / error[2]));
      EXPECT_LT(std::abs(error[2]), 2e-4);
      // Nodally exact models have no order.
      EXPECT_LT(std::abs(error[2]), std::abs(error[1]) / 3.5 + 1e-9);
    }
}

// The exact elongations, from the same integral by an independent program, and where ν = 0, a quarter wide
// and pinned at the top, those of 4, 8 and 16 rows of it.
TEST(HangingStrip, OfFourEightAndSixteenRowsHasTheElongationsOfAnIndependentProgram) {
  struct Case {
    const char* name;
    double E, exact;
    std::array<double, 3> at_4_8_16_rows;
  };
  for (const Case& c : {
           Case{"corotated", 10, .09810000, {.09800557, .09807876, .09809711}},
           Case{"corotated", 100, .00981000, {.00980733, .00980876, .00980978}},
           Case{"stvk", 10, .08393494, {.08401155, .08395672, .08394280}},
           Case{"stvk", 100, .00962471, {.00962451, .00962414, .00962467}},
           Case{"neo-hookean", 10, .09889999, {.09846323, .09865382, .09874012}},
           Case{"neo-hookean", 100, .00981093, {.00980783, .00980937, .00981049}},
           Case{"neo-hookean-barrier", 10, .10447919, {.10428646, .10443337, .10447016}},
           Case{"neo-hookean-barrier", 100, .00987415, {.00987060, .00987268, .00987387}},
       }) {
    const Sheet sheet = membrane_sheet(c.name, moduli_of(c.E, 0));
    std::printf("%s %g: %.8f\n", c.name, c.E, exact_elongation(sheet));
    EXPECT_NEAR(exact_elongation(sheet), c.exact, 6e-9) << c.name << ", E = " << c.E;
    for (const int i : {0, 1, 2}) {
      const int rows = 4 << i;
      const TestScene scene = vertical_strip(sheet, 0.25, {rows / 4, rows});
      EXPECT_NEAR(elongation(scene, Rows::pinned, 1 + c.exact), c.at_4_8_16_rows[i], 6e-9)
          << c.name << ", E = " << c.E << ", rows = " << rows;
    }
  }
}

// A strip that hangs between its two ends, at the distance D. With the horizontal force H, and s from the
// middle, the tension of a thread with P = E (λ − 1) gives
//
//   x(s) = H/w asinh(w s/H) + H s/E,   y(s) = H/w (√(1 + (w s/H)²) − 1) + w s²/(2 E)
//
// for a strip 1 m wide. The first terms are the catenary of a thread that cannot stretch.
struct Catenary {
  Catenary(double D, double E_) : E(E_) {
    H = zero_of([&](double guess) { return (H = guess, x(L / 2) - D / 2); }, 1e-3, 1e3);
  }
  double x(double s) const { return H / w * std::asinh(w * s / H) + H * s / E; }
  double y(double s) const { return H / w * (std::hypot(1, w * s / H) - 1) + w * s * s / (2 * E); }
  double sag() const { return y(L / 2); }

  double E, H;
};

struct Hung {
  double sag, H;  // m; N per m of width
};

// At rest, from the exact curve. A row of vertices moves as one.
Hung hang(const Sheet& sheet, const Catenary& exact, int rows) {
  TestScene scene =
      scene_of(make_grid({L / rows, L}, {1, rows}, Diagonals::same), sheet.model, Gravity::on);
  lay(scene, [&](double u, double v) { return Vec3(exact.x(v - L / 2), exact.y(v - L / 2), u); });
  const auto row = [&](int j, int axis) {
    return std::vector<int>{3 * (2 * j) + axis, 3 * (2 * j + 1) + axis};
  };
  std::vector<std::vector<int>> unknowns;
  for (int j = 1; j < rows; ++j)
    for (const int axis : {0, 1}) unknowns.push_back(row(j, axis));
  const VecX x = equilibrium(scene.cloth, freedom(scene.start.x.size(), unknowns), scene.start.x);
  Statics statics(scene.cloth);
  statics.evaluate(x);
  return {x[row(0, 1)[0]] - x[row(rows / 2, 1)[0]], statics.f(row(0, 0)).sum() / (L / rows)};
}

TEST(Catenary, OfAThreadThatCannotStretchHasTheKnownSagAndTension) {
  struct Case {
    double D, a, sag, tension;  // m, m, m, and in units of the weight
  };
  for (const Case& c :
       {Case{.9, .56009438, .19070900, .75080338}, Case{.8, .33820188, .26543751, .60363939},
        Case{.5, .11482011, .39819418, .51301429}}) {
    const Catenary exact(c.D, 1e12);
    EXPECT_NEAR(exact.H / w, c.a, 6e-9);
    EXPECT_NEAR(exact.sag(), c.sag, 6e-9);
    EXPECT_NEAR(std::hypot(exact.H / w, L / 2), c.tension, 6e-9);
  }
}

TEST(Catenary, OfThreadsCorotatedAndSpringsIsExactToSecondOrder) {
  struct Case {
    double E, sag, H;  // N/m, m, N/m
  };
  for (const Case& c : {Case{1e2, .27185899, .64604664}, Case{1e3, .26609285, .66172452},
                        Case{1e4, .26550318, .66336851}}) {
    const Catenary exact(0.8, c.E);
    EXPECT_NEAR(exact.sag(), c.sag, 6e-9);
    EXPECT_NEAR(exact.H, c.H, 6e-9);
    for (const Sheet& sheet :
         {membrane_sheet("threads", moduli_of(c.E, 0)),
          membrane_sheet("corotated", moduli_of(c.E, 0)), spring_sheet("springs", c.E, 0)}) {
      const Hung coarse = hang(sheet, exact, 16), fine = hang(sheet, exact, 32);
      std::printf("%-10s E = %5.0f: sag %.8f, %.8f, exact %.8f; H %.8f, %.8f, exact %.8f\n",
                  sheet.name.c_str(), c.E, coarse.sag, fine.sag, exact.sag(), coarse.H, fine.H,
                  exact.H);
      EXPECT_NEAR(fine.sag / exact.sag(), 1, 1e-3);
      EXPECT_NEAR(fine.H / exact.H, 1, 2e-3);
      EXPECT_NEAR(std::log2((coarse.sag - exact.sag()) / (fine.sag - exact.sag())), 2, 0.05);
      EXPECT_NEAR(std::log2((coarse.H - exact.H) / (fine.H - exact.H)), 2, 0.05);
    }
  }
}

}  // namespace membrane_statics_test
