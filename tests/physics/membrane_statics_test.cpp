// Cloths of every model at rest under their weight, against exact curves.
#include <gtest/gtest.h>

#include "physics/sheet_statics.h"

namespace membrane_statics_test {

using namespace sheet_statics;

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

// The first column of the lesson's table of errors. Where the stress is linear in the stretch, the strip is
// exact.
TEST(HangingStrip, OfSixteenRowsHasTheErrorsOfTheLesson) {
  const auto expect_error = [](const Sheet& sheet, double printed) {
    const double exact = exact_elongation(sheet);
    const TestScene scene = vertical_strip(sheet, L / 16, {1, 16});
    const double error = elongation(scene, Rows::level, 1 + exact) / exact - 1;
    EXPECT_NEAR(error, printed, 0.01 * std::abs(printed) + 1e-12) << sheet.name;
  };
  for (const char* name : {"threads", "linear", "corotated", "arap"})
    expect_error(membrane_sheet(name, moduli_of(10, 0)), 0);
  expect_error(spring_sheet("springs", 10, 0), 0);
  expect_error(membrane_sheet("stvk", moduli_of(10, 0)), 1.28e-4);
  expect_error(membrane_sheet("neo-hookean", moduli_of(10, 0)), -6.16e-5);
  expect_error(membrane_sheet("neo-hookean-barrier", moduli_of(10, 0)), -5.88e-5);
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
      EXPECT_NEAR(fine.sag / exact.sag() - 1, 5.2e-4, 1e-5);
      EXPECT_NEAR(fine.H / exact.H - 1, -2.6e-4, 2e-5);
      EXPECT_NEAR(std::log2((coarse.sag - exact.sag()) / (fine.sag - exact.sag())), 2, 0.05);
      EXPECT_NEAR(std::log2((coarse.H - exact.H) / (fine.H - exact.H)), 2, 0.05);
    }
  }
}

}  // namespace membrane_statics_test
