// The default settings, from starts that no real cloth reaches. A start holds up to 1e11 J. A single linear
// system often adds to this energy, because it overshoots. The guard takes such a step again, and the steps,
// however long, bring the cloth back.
#include "support/table.h"
#include "ways/simulator.h"

namespace extremes::bad_starts_test {

// The stretch is checked from h = 0.01 s on, after one second and at least 60 steps. Shorter steps
// lose little energy in a second, and a tangle of 1e5 J is rightly not at rest by then. So these
// runs last only 0.2 s or 0.02 s, and must only stay finite and definite.
void expect_survived(const char* title, MakeScene make, MakeScene at_rest) {
  const auto seconds = [](double h) { return h < 1e-3 ? 0.02 : h < 1e-2 ? 0.2 : 1; };
  for (const auto& [h, k, rest, o] : run_table(title, make, at_rest, seconds, 60)) {
    EXPECT_TRUE(o.finite) << "h = " << h << ", k = " << k;
    EXPECT_EQ(o.indefinite, 0) << "h = " << h << ", k = " << k;
    if (h >= 1e-2 && k >= 1e2) {
      EXPECT_LT(o.last, 1.2 * rest) << "h = " << h << ", k = " << k;
    }
  }
}

TEST(BadStart, AClothSqueezedToAHundredthUnfolds) {
  expect_survived("squeezed", squeezed, squeezed);
}

TEST(BadStart, ATangleComesApart) {
  expect_survived("tangled", tangled, dropped);
}

TEST(BadStart, VerticesAtOnePointPart) {
  expect_survived("coincident", coincident, dropped);
}

TEST(BadStart, TrianglesWithoutAreaOpen) {
  expect_survived("collapsed", collapsed, dropped);
}

TEST(BadStart, AVertexAtAKilometrePerSecondIsCaught) {
  expect_survived("shot", shot, dropped);
}

double distance(const VecX& x, int a, int b) {
  return (x.segment<3>(3 * a) - x.segment<3>(3 * b)).norm();
}

// A thread of length zero gets the direction zero, not 0/0. Its neighbours pull it open.
TEST(BadStart, CollapsedThreadsHaveFiniteForcesAndRegainTheirLength) {
  for (const MakeScene make : {coincident, collapsed}) {
    const TestScene scene = make(1e3);
    for (const Jacobian jacobian : {Jacobian::definite, Jacobian::bw98}) {
      Cloth cloth = scene.cloth;
      const VecX f = make_simulator({3, {jacobian}}, cloth)->forces(scene.start);
      EXPECT_TRUE(f.allFinite());
      EXPECT_GT(f.lpNorm<Eigen::Infinity>(), 1);  // N
    }
    const State end = watch(scene, 1.0 / 60, 60).end;
    EXPECT_LT(lowest(end.x), -0.5);  // m: the cloth has fallen
    for (const auto& [a, b] : {std::pair(vertex(6, 6), vertex(7, 6)),
                               {vertex(3, 3), vertex(4, 3)},
                               {vertex(8, 8), vertex(9, 8)},
                               {vertex(8, 8), vertex(8, 9)}})
      EXPECT_GT(distance(end.x, a, b), 0.5 / cells);
  }
}

}  // namespace extremes::bad_starts_test
