// Cloth that bends under its own weight, compared with the heavy elastica. The measure is H/W: how far the
// end hangs down, divided by how far it reaches out. The weights go from nearly none to very large ones.
#include <gtest/gtest.h>

#include "cantilever.h"

namespace bend_cantilever_test {

// The elastica itself ----------------------------------------------------------------------------

// Results of an independent program, which also solved the boundary value problem.
struct Row {
  double Gamma, W, H, droop, chord, tip;  // the last two in degrees
};
constexpr std::array table = {Row{0.1, .999911, .012498, 0.012500, .7161, .9548},
                              Row{0.5, .997779, .062306, 0.062444, 3.5732, 4.7634},
                              Row{1, .991246, .123471, 0.124562, 7.1003, 9.4604},
                              Row{2, .966893, .238507, 0.246673, 13.8567, 18.4260},
                              Row{5, .846657, .495905, 0.585721, 30.3584, 39.9354},
                              Row{10, .656354, .700200, 1.066802, 46.8512, 60.3120},
                              Row{20, .445232, .829881, 1.863930, 61.7864, 76.7478},
                              Row{50, .245015, .907917, 3.705561, 74.8977, 87.4593},
                              Row{100, .159223, .937524, 5.888105, 80.3612, 89.6167},
                              Row{200, .107420, .956769, 8.906771, 83.5940, 89.9743},
                              Row{500, .065890, .973117, 14.768803, 86.1264, 90},
                              Row{1000, .045986, .981141, 21.335440, 87.3165, 90},
                              Row{10000, .014261, .994110, 69.708830, 89.1781, 90}};

TEST(Elastica, IsThatOfAnIndependentProgram) {
  const double degrees = 180 / pi;
  for (const Row& row : table) {
    const Elastica e = elastica(row.Gamma);
    EXPECT_NEAR(e.W, row.W, 1e-6) << "Γ = " << row.Gamma;
    EXPECT_NEAR(e.H, row.H, 1e-6) << "Γ = " << row.Gamma;
    EXPECT_NEAR(e.droop(), row.droop, 5e-6) << "Γ = " << row.Gamma;
    EXPECT_NEAR(degrees * std::atan2(e.H, e.W), row.chord, 1e-4) << "Γ = " << row.Gamma;
    EXPECT_NEAR(degrees * e.tip, row.tip, 2e-4) << "Γ = " << row.Gamma;
    EXPECT_NEAR(e.beyond, 0, 1e-12) << "Γ = " << row.Gamma;
    EXPECT_NEAR(elastica(row.Gamma, 1000).droop() / e.droop(), 1, 1e-6) << "steps too long";
  }
}

// A light strip is a beam with small slopes, H/W → Γ/8. A heavy strip hangs straight down, except for a
// short bend at the clamp: H/W → √(Γ/2) − 1.
TEST(Elastica, HasTheLimitsThatAreKnown) {
  EXPECT_NEAR(elastica(1e-3).droop() / (1e-3 / 8), 1, 1e-6);
  EXPECT_NEAR(elastica(1e4).droop(), std::sqrt(1e4 / 2) - 1, 0.003);
}

TEST(Elastica, GivesItsGammaBack) {
  for (const double Gamma : {0.1, 3.0, 40.0})
    EXPECT_NEAR(gamma_of_droop(elastica(Gamma).droop(), 0.7 * Gamma) / Gamma, 1, 1e-7);
}

// Cloth ------------------------------------------------------------------------------------------

const std::vector<double> Gammas = {0.5, 1, 2, 5, 10, 20, 50, 100, 200, 500, 1000};

double error(const Tip& tip, double Gamma) {
  return tip.droop() / elastica(Gamma).droop() - 1;
}

TEST(BendCantilever, IsTheElasticaToSecondOrder) {
  std::vector<std::vector<double>> errors;  // of a grid, of a Γ
  for (const int N : {8, 16, 32, 64}) {
    Cantilever c;
    c.N = N;
    const std::vector<Tip> all = tips(c, Gammas);
    errors.emplace_back();
    for (size_t i = 0; i < Gammas.size(); ++i) errors.back().push_back(error(all[i], Gammas[i]));
  }
  std::printf(
      "Error of H/W\n Gamma  exact H/W     N = 8        16        32        64  last order\n");
  for (size_t i = 0; i < Gammas.size(); ++i) {
    const double Gamma = Gammas[i], e16 = errors[1][i], e32 = errors[2][i], e64 = errors[3][i];
    const double order = std::log2(e32 / e64);
    std::printf("%6g  %9.6f  %+8.4f%% %+8.4f%% %+8.4f%% %+8.4f%%  %.2f\n", Gamma,
                elastica(Gamma).droop(), 100 * errors[0][i], 100 * e16, 100 * e32, 100 * e64,
                order);
    if (Gamma <= 10) {
      EXPECT_LE(std::abs(e32), 0.1e-2) << "Γ = " << Gamma;
      EXPECT_NEAR(std::log2(e16 / e32), 2, 0.1) << "Γ = " << Gamma;
    }
    if (Gamma == 10) {
      EXPECT_NEAR(e32, -0.08e-2, 0.005e-2);  // the lesson's
    }
    if (Gamma == 100) {
      EXPECT_NEAR(e32, -0.40e-2, 0.005e-2);
    }
    if (Gamma <= 100) {
      EXPECT_LE(std::abs(e32), 0.5e-2) << "Γ = " << Gamma;
      EXPECT_NEAR(order, 2, 0.1) << "Γ = " << Gamma;
    }
    // The bend of a heavy strip, √(B/ρ g L) long, is hardly longer than a cell.
    EXPECT_LE(std::abs(e64), 1e-2) << "Γ = " << Gamma;
    EXPECT_GT(order, 1.9) << "Γ = " << Gamma;
  }
}

// The errors that an independent program found.
TEST(BendCantilever, HasTheErrorsOfAnIndependentProgram) {
  struct Case {
    double Gamma, error_of_16;
  };
  Cantilever c;
  c.N = 16;
  for (const Case& known : {Case{1, -1.9e-3}, Case{10, -3.2e-3}, Case{100, -1.6e-2}})
    EXPECT_NEAR(error(tips(c, {known.Gamma})[0], known.Gamma) / known.error_of_16, 1, 0.04)
        << "Γ = " << known.Gamma;
}

// The same strip with the clamp counted at the second row: shorter by half a cell, L' = N h.
TEST(BendCantilever, CountedFromTheRowIsOfFirstOrder) {
  std::vector<double> errors;
  for (const int N : {16, 32}) {
    Cantilever c;
    c.N = N;
    const Tip tip = tips(c, {10})[0];
    const double Gamma = 10 * std::pow(N / (N + 0.5), 3);
    errors.push_back(tip.down / (tip.out - c.h() / 2) / elastica(Gamma).droop() - 1);
  }
  std::printf("clamp at the row, N = 16, 32: %+.1f %%, %+.1f %%\n", 100 * errors[0],
              100 * errors[1]);
  EXPECT_NEAR(errors[0], 0.129, 0.001);
  EXPECT_NEAR(errors[1], 0.064, 0.001);
  EXPECT_NEAR(std::log2(errors[0] / errors[1]), 1, 0.1);
}

// Where rows are locked, neither the diagonals nor the width matter. With the k that belongs to the same
// modulus, every model is the same plate.
TEST(BendCantilever, IsTheSameForAllModelsAndGrids) {
  for (const BendModel bend_model :
       {BendModel::dihedral, BendModel::bridson, BendModel::quadratic}) {
    Cantilever narrow, wide;
    narrow.bend_model = wide.bend_model = bend_model;
    wide.diagonals = Diagonals::alternating;
    wide.across = 4;
    const Tip tip = tips(narrow, {10})[0];
    std::printf("model %d, N = 32: %+.4f %%\n", int(bend_model), 100 * error(tip, 10));
    EXPECT_LE(std::abs(error(tip, 10)), 0.1e-2) << "model " << int(bend_model);
    EXPECT_NEAR(tips(wide, {10})[0].droop() / tip.droop(), 1, 1e-8) << "model " << int(bend_model);
  }
}

}  // namespace bend_cantilever_test
