// Cloth that bends, in motion: the order of the error in h, conservation of momentum and energy, and a hinge
// that is wound up beyond a full fold.
#include <gtest/gtest.h>

#include "math/energy.h"
#include "step05_bend/time_step.h"
#include "support/family_forces.h"
#include "support/momenta.h"
#include "support/poses.h"
#include "support/reference.h"

namespace bend_motion_test {

// The force without damping, for methods that need no K.
struct OnlyForces {
  VecX f;
};
void forces(const Cloth& cloth, const State& state, OnlyForces& sum) {
  sum.f.setZero(state.x.size());
  if (cloth.gravity)
    for (int i = 0; i < cloth.vertices(); ++i)
      sum.f.segment<3>(3 * i) += cloth.mass[3 * i] * *cloth.gravity;
  for_each_family(cloth, [&](const auto& family) { sum.f += family_forces(family, state.x); });
}

// One step of step 5 on its own copy of the cloth, which remembers its folds. Solved to rounding.
class Step05 {
 public:
  Step05(const Cloth& cloth, Jacobian jacobian) : cloth_(cloth), system_(cloth_, tight(jacobian)) {}
  Stepper stepper() {
    return [this](double h, State& state) { step05::time_step(cloth_, h, state, system_); };
  }
  const Cloth& cloth() const { return cloth_; }

 private:
  static Method tight(Jacobian jacobian) {
    Method method;
    method.jacobian = jacobian;
    method.tolerance = 1e-10;
    return method;
  }
  Cloth cloth_;
  step05::System system_;
};

// Order ------------------------------------------------------------------------------------------

class Convergence05 : public testing::TestWithParam<BendModel> {};
INSTANTIATE_TEST_SUITE_P(Models, Convergence05,
                         testing::Values(BendModel::dihedral, BendModel::bridson,
                                         BendModel::quadratic),
                         [](const auto& test) {
                           return std::string(test.param == BendModel::dihedral  ? "Dihedral"
                                              : test.param == BendModel::bridson ? "Bridson"
                                                                                 : "Quadratic");
                         });

TEST_P(Convergence05, OfAFlapIsOfOrderOne) {
  const TestScene scene = flap(GetParam());
  OnlyForces system;
  const Stepper fine = rk4(scene.cloth, forces, system);
  const VecX exact = simulate(fine, scene.start, scene.end, 2400).x;
  const VecX coarser = simulate(fine, scene.start, scene.end, 1200).x;
  for (const Jacobian jacobian : {Jacobian::definite, Jacobian::bw98}) {
    Step05 step(scene.cloth, jacobian);
    const Convergence c =
        converge(scene.cloth, step.stepper(), scene.start, scene.end, 100, 3, exact);
    std::printf("%s: %.2e %.2e %.2e %.2e m, last order %.3f\n",
                jacobian == Jacobian::bw98 ? "bw98" : "definite", c.errors[0], c.errors[1],
                c.errors[2], c.errors[3], c.last_order());
    EXPECT_NEAR(c.last_order(), 1, 0.1);
    EXPECT_LT(rms_distance(scene.cloth, coarser, exact), 1e-3 * c.errors.back());
    if (GetParam() == BendModel::bridson && jacobian == Jacobian::bw98) {
      EXPECT_NEAR(c.errors.back() / 1.33e-4, 1, 0.02) << "as an independent program found it";
    }
  }
}

// Momentum ---------------------------------------------------------------------------------------

// A sheet that is folded at random by up to about a radian on every edge. Bending is its only force.
TEST(BendMomenta, ForcesNeitherPushNorTurnTheCloth) {
  for (const BendModel bend_model :
       {BendModel::dihedral, BendModel::bridson, BendModel::quadratic, BendModel::springs}) {
    Model m = model(0, 0, Gravity::off);
    add_bend(m, bend_model, 1);
    TestScene scene = at_rest(make_grid({1, 1}, {6, 6}, Diagonals::alternating), m);
    Random random(61);
    scene.start.x += random.vector(int(scene.start.x.size()), 0.05);
    step05::System system(scene.cloth);
    step05::forces(scene.cloth, scene.start, system);
    Vec3 push = Vec3::Zero(), turn = Vec3::Zero();
    for (int i = 0; i < scene.cloth.vertices(); ++i) {
      const Vec3 f = system.f.segment<3>(3 * i);
      push += f;
      turn += Vec3(scene.start.x.segment<3>(3 * i)).cross(f);
    }
    EXPECT_GT(system.f.norm(), 0.1);
    EXPECT_LT(push.norm(), 1e-13 * system.f.norm()) << "model " << int(bend_model);
    EXPECT_LT(turn.norm(), 1e-13 * system.f.norm()) << "model " << int(bend_model);
  }
}

// A sheet that is thrown, spins and flutters.
TestScene thrown(double k_bend) {
  TestScene scene = thrown_sheet();
  Model m = model(100, 50, Gravity::off);
  m.add(DihedralBend(k_bend));
  scene.cloth = make_cloth(scene.mesh, m);
  scene.start.v += field(scene.mesh, [](double u, double v) {
    return Vec3(0, std::cos(2 * pi * u) * std::cos(pi * v), 0);
  });
  return scene;
}

double total_energy(const Cloth& cloth, const State& state) {
  return 0.5 * state.v.cwiseAbs2().dot(cloth.mass) + potential_energy(cloth, state.x);
}

double bend_energy(const Cloth& cloth, const VecX& x) {
  double sum = 0;
  add_elastic_energy(cloth.hinges, cloth.hinges.elements, x, sum);
  return sum;
}

// Symplectic Euler with the forces of bending keeps both momenta to rounding. The energy has no jump: its
// error becomes half as large if h is halved.
TEST(BendMomenta, OfASpinningSheetStay) {
  const TestScene scene = thrown(0.05);
  OnlyForces system;
  const Stepper step = [&](double h, State& state) {
    forces(scene.cloth, state, system);
    state.v += h * scene.cloth.inverse_mass.cwiseProduct(system.f);
    state.x += h * state.v;
  };
  const double E0 = total_energy(scene.cloth, scene.start);
  const Momenta before = momenta(scene.cloth, scene.start);
  double last = 0, most_bent = 0;
  for (const int N : {300, 600, 1200}) {
    State state = scene.start;
    double off = 0;
    for (int n = 0; n < N; ++n) {
      step(scene.end / N, state);
      off = std::max(off, std::abs(total_energy(scene.cloth, state) / E0 - 1));
      most_bent = std::max(most_bent, bend_energy(scene.cloth, state.x));
    }
    const Momenta after = momenta(scene.cloth, state);
    EXPECT_LT((after.linear - before.linear).norm(), 1e-12 * before.linear_scale);
    EXPECT_LT((after.angular - before.angular).norm(), 1e-12 * before.angular_scale);
    std::printf("h = %.5f: energy off by %.1e at most\n", scene.end / N, off);
    if (last > 0) {
      EXPECT_NEAR(std::log2(last / off), 1, 0.2);
    }
    last = off;
  }
  EXPECT_GT(most_bent, 0.005 * E0) << "nothing was bent";
}

// Backward Euler keeps the linear momentum. It loses angular momentum in proportion to h, with bending or
// without.
TEST(BendMomenta, OfStep05AreThoseOfBackwardEuler) {
  const TestScene scene = thrown(1e-3);
  const Momenta before = momenta(scene.cloth, scene.start);
  double last = 0, order = 0;
  for (const int N : {150, 300, 600}) {
    Step05 step(scene.cloth, Jacobian::definite);
    const State end = simulate(step.stepper(), scene.start, scene.end, N);
    const Momenta after = momenta(scene.cloth, end);
    EXPECT_LT((after.linear - before.linear).norm(), 1e-9 * before.linear_scale);
    const double lost = 1 - after.angular.dot(before.angular) / before.angular.squaredNorm();
    std::printf("h = %.5f: lost %.2f %% of angular momentum\n", scene.end / N, 100 * lost);
    EXPECT_GT(lost, 0);
    order = std::log2(last / lost);
    last = lost;
  }
  EXPECT_NEAR(order, 1, 0.1);
}

// Beyond a full fold -----------------------------------------------------------------------------

// Only P3 of this hinge moves, on a circle. The energy is k θ²/2 at any θ, so the hinge swings like a
// harmonic oscillator, ω = √(k/m r²), by 4.5 rad to both sides. (Backward Euler needs many steps for that,
// because it loses angular momentum.) Without a memory of its folds the force would change its sign at π.
TEST(BendMotion, AHingeSwingsThroughItsFullFold) {
  Mesh mesh;
  mesh.faces = {{0, 1, 2}, {3, 2, 1}};
  mesh.rest = {{Vec2(-1, 0), Vec2(0, -1), Vec2(0, 1)}, {Vec2(1, 0), Vec2(0, 1), Vec2(0, -1)}};
  mesh.x.resize(12);
  mesh.x << -1, 0, 0, 0, 0, 1, 0, 0, -1, 1, 0, 0;
  const double k = 0.02, most = 4.5;
  Model m = model(1e4, 1e4, Gravity::off);
  m.add(DihedralBend(k));
  m.pins = {0, 1, 2};
  TestScene scene = at_rest(mesh, m);
  const double omega = std::sqrt(k / scene.cloth.mass[9]), period = 2 * pi / omega;  // r = 1 m
  scene.start.v[10] = most * omega;
  double last = 0;
  for (const int N : {10000, 20000}) {
    Step05 step(scene.cloth, Jacobian::bw98);
    State state = scene.start;
    const Stepper go = step.stepper();
    double error = 0, largest = 0, turned = 0, before = 0;
    for (int n = 1; n <= N; ++n) {
      go(period / N, state);
      const double angle = std::atan2(state.x[10], state.x[9]);
      turned += std::remainder(angle - before, 2 * pi);
      before = angle;
      error = std::max(error, std::abs(turned - most * std::sin(2 * pi * n / N)));
      largest = std::max(largest, std::abs(turned));
    }
    std::printf("%d steps a period: up to %.3f rad, off by %.3f rad at most\n", N, largest, error);
    EXPECT_GT(largest, 4.2);
    if (last > 0) {
      EXPECT_NEAR(std::log2(last / error), 1, 0.2);
      EXPECT_LT(error, 0.15);
    }
    last = error;
  }
}

}  // namespace bend_motion_test
