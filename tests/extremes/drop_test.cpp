// The dropped cloth with the default settings, at every time step and stiffness.
#include "support/table.h"
#include "ways/simulator.h"

namespace extremes::drop_test {

TEST(Drop, TheStaticStretchIsThatOfAnEquilibrium) {
  for (double k : {1e2, 3e2, 1e3, 1e4, 1e5}) {
    const TestScene scene = dropped(k);
    Cloth cloth = scene.cloth;
    VecX f = make_simulator({3}, cloth)->forces(hanging(scene));
    for (const Pin& pin : scene.cloth.pins) f.segment<3>(3 * pin.vertex).setZero();
    const double weight = scene.cloth.mass.sum() / 3 * g;
    EXPECT_LT(f.lpNorm<Eigen::Infinity>(), 1e-6 * weight) << "k = " << k;
  }
}

// The bounds: an energy gain of 0.1 J, where the fall releases 0.98 J; and a thread that is 5 %
// longer than the longest at rest. Measured: no gain, and threads stretched by 3.0 and 2.3 %.
TEST(Drop, AtAFrameAStepTheEnergyAndTheStretchStaySmall) {
  for (double k : {1e3, 1e4}) {
    const Outcome o = watch(dropped(k), 1.0 / 60, 60);
    EXPECT_TRUE(o.finite);
    EXPECT_LT(o.gain, 0.1) << "k = " << k;
    EXPECT_LT(o.peak, 0.05 + static_stretch(dropped(k))) << "k = " << k;
    EXPECT_EQ(o.indefinite, 0);
  }
}

// The swing itself stretches a softer cloth more, in an exact computation, too: a pendulum that
// fell from the horizontal pulls at the bottom with three times its weight. Measured strains: 0.112
// here, 0.147 at h = 1e-4 s, 0.051 at rest.
TEST(Drop, AtTwoFramesAStepASoftClothIsStretchedAsAPendulumIsAndGainsNoEnergy) {
  const Outcome o = watch(dropped(3e2), 1.0 / 30, 30);
  EXPECT_TRUE(o.finite);
  EXPECT_LT(o.gain, 0.1);
  EXPECT_LT(o.peak - 1, 3 * (static_stretch(dropped(3e2)) - 1));
  EXPECT_EQ(o.indefinite, 0);
}

// The physics gives about three times the strain at rest. With short steps the largest strain is
// near that, at any stiffness.
TEST(Drop, AtShortStepsTheLargestStrainIsThatOfAPendulum) {
  for (double k : {3e2, 1e3, 1e4}) {
    const double at_rest = static_stretch(dropped(k)) - 1;
    EXPECT_NEAR((watch(dropped(k), 1e-3, 1000).peak - 1) / at_rest, 2.75, 0.25) << "k = " << k;
  }
}

// The runs at h = 1e-4 s last only 0.1 s, or the table would take a minute. The next test runs the
// softest cloth that has a bound for the whole second.
TEST(Drop, NoTimeStepAndNoStiffnessBreaksIt) {
  const auto seconds = [](double h) { return h < 1e-3 ? 0.1 : 1; };
  for (const auto& [h, k, rest, o] : run_table("dropped", dropped, dropped, seconds, 30)) {
    EXPECT_TRUE(o.finite) << "h = " << h << ", k = " << k;
    EXPECT_EQ(o.indefinite, 0) << "h = " << h << ", k = " << k;
    if (h >= 1e-3 && k >= 1e2) {
      EXPECT_LT(o.last, 1.2 * rest) << "h = " << h << ", k = " << k;
    }
    const bool within = h < 2e-3 || (h < 0.02 && k <= 1e4);
    if (within) {
      EXPECT_LT(o.gain, 0.1) << "h = " << h << ", k = " << k;
    }
  }
}

TEST(Drop, ASecondOfTheShortestStepsEndsAsTheLongOnesDo) {
  const Outcome o = watch(dropped(1e2), 1e-4, 10000);
  EXPECT_TRUE(o.finite);
  EXPECT_LT(o.last, 1.2 * static_stretch(dropped(1e2)));
  EXPECT_LT(o.gain, 0);
}

}  // namespace extremes::drop_test
