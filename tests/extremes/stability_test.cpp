// A coarse stability map of every configuration, cell by cell: if a step becomes more or less
// stable, its map changes. And the theory of such maps.
#include "extremes/stability.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

namespace extremes {

inline void PrintTo(Verdict verdict, std::ostream* out) {
  *out << name(verdict);
}

}  // namespace extremes

namespace extremes::stability_test {

constexpr Watch coarse = {.cells = 4, .most = 60};

const MapWay& configuration(const std::string& searched) {
  for (const MapWay& map : map_ways())
    if (map.name == searched) return map;
  throw std::invalid_argument(searched + ": no such way");
}

// Rows: k from 1e8 N/m down to 1 N/m, then the strip. Columns: h from 1e-4 s to 0.2 s.
std::string map_of(const char* name) {
  std::string text = "\n";
  const auto line = [&](MapScene scene, double k) {
    for (const double h : {1e-4, 5e-4, 2e-3, 1e-2, 5e-2, 0.2})
      text += letter(watch_cell(configuration(name), scene, h, k, coarse).verdict);
    text += '\n';
  };
  for (const double k : {1e8, 1e6, 1e4, 1e2, 1.0}) line(MapScene::drop, k);
  line(MapScene::strip, 1e4);
  return text;
}

TEST(StabilityMap, OfTheExplicitStep) {
  EXPECT_EQ(map_of("step01"), R"(
XXXXXX
XXXXXX
..XXXX
..+XXX
..++XX
+XXXXX
)");
}

TEST(StabilityMap, OfTheExplicitStepWithDamping) {
  EXPECT_EQ(map_of("step02"), R"(
XXXXXX
XXXXXX
..XXXX
..+XXX
..++XX
.XXXXX
)");
}

// How far an indefinite matrix throws a cloth is chance: 1000-fold (X) or less (+).
// So both count as the same.
TEST(StabilityMap, OfThePrintedMatrix) {
  std::string map = map_of("step03_bw98");
  std::replace(map.begin(), map.end(), 'X', '+');
  EXPECT_EQ(map, R"(
...+++
...+++
....++
.....+
.....+
.++FFF
)");
}

TEST(StabilityMap, OfTheDefiniteMatrixAlone) {
  EXPECT_EQ(map_of("step03_bare"), R"(
...+++
....++
....++
.....+
.....+
..+..+
)");
}

// With the guard or with many Newton iterations, solved directly or by conjugate gradients: all stable.
TEST(StabilityMap, OfTheGuardedSteps) {
  for (const char* name : {"step03", "step03_newton", "step04_block", "step04_multigrid", "step05"})
    EXPECT_EQ(map_of(name), R"(
......
......
......
......
......
......
)") << name;
}

// The line in the picture: h ω_max = 2, with the damping of step 2. Below it the energy
// oscillates by less than a tenth of m g L. Above it the energy grows without bound, or until
// damping throws a torn cloth about.
TEST(ExplicitLimit, PartsWhatGainsEnergyFromWhatDoesNot) {
  for (const char* name : {"step01", "step02"})
    for (const double k : {1e1, 1e3, 1e5, 1e7}) {
      const double limit = explicit_limit(configuration(name), k, coarse);
      const auto gain = [&](double h) {
        return watch_cell(configuration(name), MapScene::drop, h, k, coarse).gain;
      };
      EXPECT_LT(gain(0.8 * limit), 0.1) << name << ", k = " << k;
      EXPECT_FALSE(gain(1.25 * limit) < 10) << name << ", k = " << k;
    }
}

// 2/ω_max is proportional to k^−1/2. Damping makes the limit shorter. Where damping dominates, with
// kd = k τ, the limit is one of h kd and so proportional to 1/k.
TEST(ExplicitLimit, GoesWithTheRootOfKAndWithDampingWithK) {
  const auto limit = [&](const char* name, double k) {
    return explicit_limit(configuration(name), k, coarse);
  };
  EXPECT_NEAR(limit("step01", 1e2) / limit("step01", 1e6), 100, 0.1);
  EXPECT_LT(limit("step02", 1e2), limit("step01", 1e2));
  EXPECT_NEAR(limit("step02", 1e7) / limit("step02", 1e8), 10, 0.5);
}

// The table of the lesson of step 2.
TEST(ExplicitLimit, IsThatOfTheLessons) {
  struct Case {
    double k, step01, step02;  // N/m, s, s
  };
  for (const Case& c : {Case{1e2, 3.2e-3, 3.1e-3}, Case{1e4, 3.2e-4, 2.3e-4},
                        Case{1e6, 3.2e-5, 4.9e-6}, Case{1e8, 3.2e-6, 5.0e-8}}) {
    const double one = explicit_limit(configuration("step01"), c.k, {}),
                 two = explicit_limit(configuration("step02"), c.k, {});
    std::printf("k = %.0e: h_crit of step 1 %.2e s, of step 2 %.2e s\n", c.k, one, two);
    EXPECT_NEAR(one / c.step01, 1, 0.02) << "k = " << c.k;
    EXPECT_NEAR(two / c.step02, 1, 0.02) << "k = " << c.k;
  }
}

// The lesson of step 5: of all cells with bending only two gain energy. Their weight stretches the threads
// more than fivefold. The next longer step gains none.
TEST(StabilityMap, WithBendingTwoCellsOfASoftClothGainEnergy) {
  for (const auto& [h, verdict] : {std::pair{1e-3, '+'}, {1.78e-3, '+'}, {3.16e-3, '.'}}) {
    const Cell cell = watch_cell(configuration("step05"), MapScene::drop, h, std::sqrt(10.0), {});
    std::printf("h = %.2e s: gain %.1e m g L, stretched %.1f-fold\n", h, cell.gain, cell.stretch);
    EXPECT_EQ(letter(cell.verdict), verdict) << "h = " << h;
    EXPECT_NEAR(cell.stretch, 5.5, 0.2);
  }
}

// The last cell before the border and the first beyond it, in the four rows that the lesson of step 1 prints.
TEST(StabilityMap, HasTheBordersThatTheLessonPrints) {
  struct Case {
    double k;  // N/m
    int whole;  // columns before the first X; the first column is h = 10 µs, and four are a factor of ten
    char before;  // the verdict in the last of them
  };
  for (const Case& c :
       {Case{1e6, 3, '+'}, Case{1e4, 7, '.'}, Case{1e2, 10, '+'}, Case{1, 12, '+'}}) {
    const auto cell = [&](int column) {
      return watch_cell(configuration("step01"), MapScene::drop, 1e-5 * std::pow(10, column / 4.0),
                        c.k, {});
    };
    const Cell whole = cell(c.whole - 1);
    EXPECT_EQ(letter(whole.verdict), c.before) << "k = " << c.k;
    EXPECT_EQ(letter(cell(c.whole).verdict), 'X') << "k = " << c.k;
    if (c.k == 1) {
      const double part = 1e-2 / explicit_limit(configuration("step01"), 1, {});
      std::printf("softest cloth: stretched %.1f-fold, explodes at %.2f h_crit\n", whole.stretch,
                  part);
      EXPECT_NEAR(whole.stretch, 10, 0.5);  // 9.7 measured
      EXPECT_NEAR(part, 0.32, 0.005);
    }
  }
}

TEST(Frozen, IsThePrintedMatrixWhereTheDefiniteOneBuckles) {
  for (const double h : {1e-2, 1e-1, 1.0}) {
    const Cell bw98 = watch_cell(configuration("step03_bw98"), MapScene::strip, h, 1e4, coarse);
    EXPECT_EQ(bw98.verdict, Verdict::frozen) << "h = " << h;
    EXPECT_EQ(bw98.indefinite, bw98.steps) << "every matrix must count as indefinite; h = " << h;
    const Cell definite = watch_cell(configuration("step03"), MapScene::strip, h, 1e4, coarse);
    EXPECT_GT(definite.height, 0.1) << "h = " << h;
    EXPECT_EQ(definite.indefinite, 0);
  }
}

// The guard spares conjugate gradients the systems of a cloth that was thrown far out.
TEST(Guard, SparesTheSolverSystemsThatItCannotSolve) {
  const Watch watch = {.cells = 8, .fewest = 40, .most = 40};
  MapWay map = configuration("step04_block");
  const Cell guarded = watch_cell(map, MapScene::drop, 0.3, 1e8, watch);
  map.configuration.method.guard = false;
  const Cell bare = watch_cell(map, MapScene::drop, 0.3, 1e8, watch);
  EXPECT_GT(bare.capped, 0);
  EXPECT_EQ(guarded.capped, 0);
  EXPECT_GT(guarded.redone, 0);
}

TEST(Guard, GainsNoEnergyWhereOneLinearSystemDoes) {
  for (const double k : {1e2, 1e5, 1e8})
    for (const double h : {0.1, 0.5}) {
      EXPECT_GT(watch_cell(configuration("step03_bare"), MapScene::drop, h, k, coarse).gain, 0.01);
      for (const char* name : {"step03", "step03_newton"})
        EXPECT_LT(watch_cell(configuration(name), MapScene::drop, h, k, coarse).gain, 1e-9);
    }
}

}  // namespace extremes::stability_test
