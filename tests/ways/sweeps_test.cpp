// What XPBD and VBD share: forces, pins, refusals, counts.
#include <gtest/gtest.h>

#include "support/extreme_scenes.h"
#include "ways/local_scenes.h"

namespace ways_test {

Model damped_threads() {
  Model m;
  m.add(StretchTerm(100, 0.02)).add(ShearTerm(50, 0.01)).add(DihedralBend(0.01, 1e-4));
  return m;
}

const std::vector<Configuration> both = {xpbd_of(4), vbd_of(4)};

TEST(Sweeps, HaveTheForcesOfTheSteps) {
  const TestScene scene = disturbed_sheet(damped_threads(), Held::by_two_corners);
  for (const Configuration& way : both) {
    Cloth cloth = scene.cloth, same = scene.cloth;
    const VecX f = make_simulator(way, cloth)->forces(scene.start);
    const auto five = make_simulator({5}, same);
    EXPECT_LT((f - five->forces(scene.start)).norm(), 1e-12 * f.norm());
  }
}

TEST(Sweeps, FallFreelyAsBackwardEulerDoes) {
  TestScene scene = sheet(3, Held::free, 100, 50, Gravity::on);
  for (const Configuration& way : both) {
    const State end = after(scene, way, 0.01, 10), same = after(scene, {3}, 0.01, 10);
    EXPECT_LT((end.x - same.x).norm(), 1e-13);
  }
}

// A pin that moves, and one that lets its vertex slide along x.
TEST(Sweeps, FollowTheirPins) {
  const Mat3 along_x = Vec3::UnitX() * Vec3::UnitX().transpose();
  for (const Configuration& way : both) {
    TestScene scene = disturbed_sheet(damped_threads(), Held::by_two_corners);
    const Vec3 x20 = scene.start.x.segment<3>(60), x24 = scene.start.x.segment<3>(72);
    const Vec3 velocity(0.1, 0.2, -0.3);
    scene.cloth.pins = {Pin(20, Mat3::Zero(), velocity), Pin(24, along_x)};
    scene.cloth.inverse_mass.segment<3>(72) = scene.cloth.mass.segment<3>(72).cwiseInverse();
    const State end = after(scene, way, 0.01, 10);
    EXPECT_LT((end.x.segment<3>(60) - (x20 + 0.1 * velocity)).norm(), 1e-15);
    const Vec3 slid = end.x.segment<3>(72) - x24;
    EXPECT_GT(std::abs(slid.x()), 1e-4);
    EXPECT_EQ(slid.tail<2>(), Vec2::Zero());
  }
}

TEST(Sweeps, StayFiniteInATangle) {
  for (const Configuration& way : both)
    for (const double k : {10.0, 1e5})
      EXPECT_TRUE(after(extremes::tangled(k), way, 0.02, 10).x.allFinite()) << k;
}

TEST(Sweeps, RefuseNone) {
  Cloth cloth = sheet(3, Held::free, 100, 50, Gravity::on).cloth;
  for (const Scheme scheme : {Scheme::xpbd, Scheme::vbd})
    EXPECT_THROW(make_simulator({.scheme = scheme, .sweeps = 0}, cloth), std::invalid_argument);
}

// A triangle has three conditions, and XPBD visits it once for each; VBD once for each corner, and at least
// twice more for its energy.
TEST(Sweeps, CountWhatTheyRead) {
  const auto counts = [](const Configuration& way) {
    TestScene scene = disturbed_sheet(Model().add(StretchTerm(100)).add(ShearTerm(50)), Held::free);
    const auto simulator = make_simulator(way, scene.cloth);
    for (int n = 0; n < 10; ++n) simulator->step(0.01, scene.start);
    return simulator->counts();
  };
  const Counts xpbd = counts(xpbd_of(4)), vbd = counts(vbd_of(4));
  for (const Counts& c : {xpbd, vbd}) {
    EXPECT_EQ(c.iterations, 40);
    EXPECT_EQ(c.forces, 3 * 40);
    EXPECT_EQ(c.assemblies, 0);
  }
  EXPECT_EQ(xpbd.energies, 0);
  EXPECT_GE(vbd.energies, 2 * 3 * 40);
  EXPECT_LE(vbd.energies, 4 * 3 * 40);
  const long triangles = 32, vector = 24, vertices = 25;
  const long corner = 3 * vector + 9 * 8 + 8;
  EXPECT_EQ(xpbd.bytes,
            10 * 9 * vector * vertices + 120 * triangles * (long(sizeof(Triangle)) + 3 * corner));
  EXPECT_GT(vbd.bytes, xpbd.bytes);
}

}  // namespace ways_test
