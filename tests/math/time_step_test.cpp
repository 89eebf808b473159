// Step 1's symplectic Euler against exact results.
#include <gtest/gtest.h>

#include "support/energy.h"
#include "support/poses.h"
#include "support/scenes.h"

namespace time_step_test {

TEST(Step01, CarriesNoElementsThatTheSceneDoesNotName) {
  const Mesh mesh = make_grid({1, 1}, {4, 4}, Diagonals::same);
  const Cloth bare = make_cloth(mesh, {});
  EXPECT_TRUE(bare.triangles.elements.empty());
  EXPECT_EQ(bare.triangles.elements.capacity(), 0u);
  EXPECT_EQ(bare.springs.elements.capacity(), 0u);
  EXPECT_FALSE(bare.gravity);
  EXPECT_EQ(forces(bare, 2 * mesh.x), VecX::Zero(mesh.x.size()).eval());

  EXPECT_EQ(make_cloth(mesh, model(0, 1, Gravity::off)).triangles.elements.size(), 32u);
}

// Stretch and shear are two tables of the scene: each acts alone, and together they add up.
TEST(Step01, ForcesOfTheTermsAddUp) {
  const Mesh mesh = make_grid({1, 1}, {3, 3}, Diagonals::alternating);
  Random random(51);
  const VecX x = mesh.x + random.vector(int(mesh.x.size()), 0.1);
  const auto forces_of = [&](double k, double k_shear, Gravity gravity) {
    return forces(make_cloth(mesh, model(k, k_shear, gravity)), x);
  };
  const VecX weight = forces_of(0, 0, Gravity::on);
  const VecX sum = forces_of(100, 0, Gravity::off) + forces_of(0, 50, Gravity::off) + weight;
  EXPECT_LT((forces_of(100, 50, Gravity::on) - sum).norm(), 1e-14 * sum.norm());
  EXPECT_NEAR(weight.sum(), -g * density, 1e-14);  // of a square metre
}

// A free fall is exact for every vertex:  v_n = n h g,   x_n = x_0 + h² g n (n + 1)/2
TEST(Step01, FreeClothFallsLikeAStone) {
  const auto [mesh, cloth, start, end] = sheet(4, Held::free, 100, 50, Gravity::on);
  State state = start;
  step01::System system(cloth);
  const int n = 100;
  const double h = 1e-3;
  for (int i = 0; i < n; ++i) step01::time_step(cloth, h, state, system);
  for (int i = 0; i < mesh.vertices(); ++i) {
    const Vec3 fallen = state.x.segment<3>(3 * i) - mesh.x.segment<3>(3 * i);
    EXPECT_LT((fallen - h * h * n * (n + 1) / 2 * *cloth.gravity).norm(), 1e-13) << "vertex " << i;
    EXPECT_LT((state.v.segment<3>(3 * i) - n * h * *cloth.gravity).norm(), 1e-13) << "vertex " << i;
  }
}

// Momentum changes by weight and nothing else, in every motion of the cloth.
TEST(Step01, MomentumIsThatOfTheWeightAlone) {
  const Mesh mesh = make_grid({1, 0.7}, {4, 3}, Diagonals::alternating);
  Cloth cloth = make_cloth(mesh, model(100, 50, Gravity::on));
  cloth.gravity = Vec3(1, -9.81, 2);
  Random random(52);
  State state{mesh.x, random.vector(int(mesh.x.size()), 2)};
  step01::System system(cloth);
  const auto momentum = [&] {
    Vec3 p = Vec3::Zero();
    for (int i = 0; i < cloth.vertices(); ++i) p += cloth.mass[3 * i] * state.v.segment<3>(3 * i);
    return p;
  };
  const Vec3 before = momentum();
  for (int i = 0; i < 500; ++i) step01::time_step(cloth, 1e-3, state, system);
  EXPECT_LT((momentum() - before - 0.5 * density * 0.7 * *cloth.gravity).norm(), 1e-12);
}

// Not "nearly": a pinned vertex has the same bits after the run.
TEST(Step01, PinsDoNotMove) {
  const auto [mesh, cloth, begin, end] = sheet(4, Held::by_two_corners, 100, 50, Gravity::on);
  State state = begin;
  step01::System system(cloth);
  for (int i = 0; i < 1000; ++i) step01::time_step(cloth, 1e-3, state, system);
  ASSERT_EQ(cloth.pins.size(), 2u);
  for (const Pin& pin : cloth.pins) {
    const Vec3 x = state.x.segment<3>(3 * pin.vertex), start = mesh.x.segment<3>(3 * pin.vertex);
    EXPECT_EQ(x, start) << "pin " << pin.vertex;
    EXPECT_EQ(state.v.segment<3>(3 * pin.vertex), Vec3::Zero()) << "pin " << pin.vertex;
  }
  EXPECT_GT((state.x - mesh.x).norm(), 0.1) << "nothing moved at all";
}

// The new v moves x. With the old one (forward Euler) the first step of a fall would not move x.
TEST(Step01, NewVelocityMovesThePositions) {
  Cloth cloth = bare_cloth(1);
  cloth.gravity = Vec3(0, -10, 0);
  State state{Vec3(0, 0, 0), Vec3(1, 0, 0)};
  step01::System system(cloth);
  step01::time_step(cloth, 0.1, state, system);
  EXPECT_LT((state.v - Vec3(1, -1, 0)).norm(), 1e-15);
  EXPECT_LT((state.x - Vec3(0.1, -0.1, 0)).norm(), 1e-15);
}

// Vertex 0 on a spring, vertex 1 pinned at the origin: ω = √(k/m).
struct Oscillator {
  Oscillator(double rest_length, double k, double m)
      : cloth(one_spring(make_spring(0, 1, rest_length), k)), system(cloth) {
    cloth.mass.setConstant(m);
    cloth.inverse_mass << 1 / m, 1 / m, 1 / m, 0, 0, 0;
    cloth.pins = {1};
    state = {VecX::Zero(6), VecX::Zero(6)};
  }
  void step(double h) { step01::time_step(cloth, h, state, system); }

  Cloth cloth;
  step01::System system;
  State state;
};

// The limit of symplectic Euler is h ω = 2. Below it the swing stays within 1/√(1 − (hω/2)²) of its
// start, here 7.1 times; above it each step multiplies it, here by 1.33.
TEST(Step01, SpringIsStableBelowTwoOverOmegaAndUnstableAbove) {
  const double k = 50, m = 0.02, critical = 2 / std::sqrt(k / m), start = 1e-6;
  for (const double share : {0.99, 1.01}) {
    Oscillator o(1, k, m);
    o.state.x[0] = 1 + start;
    double swing = start;
    for (int i = 0; i < (share < 1 ? 10000 : 40); ++i) {
      o.step(share * critical);
      swing = std::max(swing, std::abs(o.state.x[0] - 1));
    }
    if (share < 1)
      EXPECT_LT(swing, 7.2 * start) << "h = " << share << " of the limit";
    else
      EXPECT_GT(swing, 1000 * start) << "h = " << share << " of the limit";
  }
}

// For a linear force symplectic Euler conserves, instead of the energy, exactly
//
//   p²/2m + k x²/2 − h k p x / 2m
//
// A spring of rest length 0 is linear: f = −k x.
TEST(Step01, LinearSpringConservesTheShadowEnergyToRounding) {
  const double k = 50, m = 0.02, h = 0.9 * 2 / std::sqrt(k / m);
  Oscillator o(0, k, m);
  o.state.x.head<3>() = Vec3(0.3, 0, 0);
  o.state.v.head<3>() = Vec3(2, 0, 0);
  const auto energy = [&] {
    return m * o.state.v[0] * o.state.v[0] / 2 + k * o.state.x[0] * o.state.x[0] / 2;
  };
  const auto shadow = [&] { return energy() - h * k * o.state.v[0] * o.state.x[0] / 2; };
  const double start = shadow();
  double lowest = energy(), highest = energy();
  for (int i = 0; i < 10000; ++i) {
    o.step(h);
    ASSERT_NEAR(shadow(), start, 1e-11 * start) << "step " << i;
    lowest = std::min(lowest, energy());
    highest = std::max(highest, energy());
  }
  EXPECT_GT(highest / lowest, 2) << "at 0.9 of the limit the energy itself swings";
}

}  // namespace time_step_test
