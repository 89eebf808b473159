// XPBD against backward Euler: the same step where ∂C/∂x is constant, and a near one elsewhere.
#include <gtest/gtest.h>

#include <cstdio>

#include "support/momenta.h"
#include "ways/local_scenes.h"

namespace ways_test {

// Two vertices of 0.3 kg, the first of them held.
TestScene one_spring(bool held) {
  TestScene scene;
  scene.cloth.mass = VecX::Constant(6, 0.3);
  scene.cloth.inverse_mass = scene.cloth.mass.cwiseInverse();
  scene.cloth.gravity = Vec3(0, -g, 0);
  scene.cloth.springs.elements = {make_spring(0, 1, 0.8)};
  scene.cloth.term<SpringTerm>() = SpringTerm(40);
  scene.start.x = (VecX(6) << 0, 0, 0, 1, 0.2, -0.4).finished();
  scene.start.v = (VecX(6) << 0, 0, 0, -1, 2, 3).finished();
  if (held) {
    scene.cloth.pins = {0};
    scene.cloth.inverse_mass.head<3>().setZero();
  }
  return scene;
}

// A spring moves its ends along its line, and ∂C/∂x keeps its direction: one sweep is all.
TEST(Xpbd, IsBackwardEulerForOneSpring) {
  for (const bool held : {false, true})
    for (const double h : {1e-3, 0.03, 0.3}) {
      const TestScene scene = one_spring(held);
      const State end = after(scene, xpbd_of(1), h);
      EXPECT_LT(residual(scene, h, end), 1e-14) << h;
      EXPECT_LT((end.x - after(scene, newton, h).x).norm(), 1e-7 * h) << h;
    }
}

// Linear membranes and quadratic bending, damped: γ is in it, too.
TEST(Xpbd, IsBackwardEulerWhereGradientsAreConstant) {
  const TestScene scene = disturbed_sheet(
      with_membrane("linear", {40, 20}, 0.02).add(QuadraticBend(0.05, 1e-3)), Held::by_two_corners);
  const VecX exact = after(scene, newton, 0.02).x;
  const auto error = [&](int sweeps) {
    return (after(scene, xpbd_of(sweeps), 0.02).x - exact).norm();
  };
  EXPECT_GT(error(1), 1e-3);
  EXPECT_LT(error(500), 1e-12);
}

// Where ∂C/∂x turns, no number of sweeps comes nearer than this.
TEST(Xpbd, EndsNearBackwardEulerElsewhere) {
  const TestScene scene = disturbed_sheet(threads(), Held::by_two_corners);
  const double h = 0.02;
  const State end = after(scene, xpbd_of(500), h), more = after(scene, xpbd_of(1000), h);
  EXPECT_LT((end.x - more.x).norm(), 1e-14);
  const double apart = (end.x - after(scene, newton, h).x).norm();
  std::printf("  XPBD with 500 sweeps: residual %.2e m, %.2e m from backward Euler\n",
              residual(scene, h, end), apart);
  EXPECT_NEAR(residual(scene, h, end), 2.75e-3, 1e-4);
  EXPECT_NEAR(apart, 5.8e-4, 2e-5);
  EXPECT_LT(residual(scene, h, after(scene, newton, h)), 1e-10);
}

// A step turns ∂C/∂x by h² C, and λ is h² k C: so the two steps differ by h⁴, and both are of order 1 in h.
TEST(Xpbd, DiffersFromBackwardEulerByHToTheFourth) {
  const TestScene scene = disturbed_sheet(threads(), Held::by_two_corners);
  const auto distance = [&](double h) {
    return (after(scene, xpbd_of(200), h).x - after(scene, vbd_of(200), h).x).norm();
  };
  const double order = std::log2(distance(2.5e-4) / distance(1.25e-4));
  std::printf("  order %.3f\n", order);
  EXPECT_NEAR(order, 4, 0.1);
}

// Every Δλ moves all vertices of a condition, and ∂C/∂x adds up to zero over them.
TEST(Xpbd, KeepsLinearMomentum) {
  const TestScene scene = thrown_sheet();
  const Momenta start = momenta(scene.cloth, scene.start);
  for (const int sweeps : {1, 4, 16}) {
    const Momenta end = momenta(scene.cloth, after(scene, xpbd_of(sweeps), 0.01, 30));
    EXPECT_LT((end.linear - start.linear).norm(), 1e-12 * start.linear_scale) << sweeps;
  }
}

}  // namespace ways_test
