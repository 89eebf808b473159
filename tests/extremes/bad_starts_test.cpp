// The default settings, from states that no cloth was ever in. What they hold of energy at the start,
// up to 1e11 J, is thrown out in the first steps, often with more than there was: a single Newton step
// overshoots. But the next steps, however long, bring the cloth back.
#include "support/table.h"
#include "ways/simulator.h"

namespace extremes::bad_starts_test {

// From h = 0.01 s on, after a second and 60 steps. At shorter steps little energy is lost in a second,
// and a tangle of 1e5 J rightly has not come to rest: only watched for 0.2 and 0.02 s.
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

// Where a thread has no length its direction is zero, not 0/0; its neighbours pull it open.
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
    EXPECT_LT(lowest(end.x), -0.5);  // m: it has fallen like the rest
    for (const auto& [a, b] : {std::pair(vertex(6, 6), vertex(7, 6)),
                               {vertex(3, 3), vertex(4, 3)},
                               {vertex(8, 8), vertex(9, 8)},
                               {vertex(8, 8), vertex(8, 9)}})
      EXPECT_GT(distance(end.x, a, b), 0.5 / cells);
  }
}

}  // namespace extremes::bad_starts_test
