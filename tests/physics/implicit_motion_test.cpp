// The backward Euler steps of step 3: which quantities they keep, which they lose, and the order of the loss.
#include <gtest/gtest.h>

#include "program/diagnostics.h"
#include "step01_explicit/time_step.h"
#include "step02_damping/time_step.h"
#include "step03_implicit/time_step.h"
#include "support/momenta.h"
#include "support/reference.h"

namespace implicit_motion_test {

// A flat sheet has no internal force, so it falls as in step 1, y_N = −g h² N (N + 1)/2, even with an h at
// which step 1 is not stable.
TEST(ImplicitFall, OfAFlatSheetIsThatOfStep01) {
  for (const Jacobian jacobian : {Jacobian::definite, Jacobian::bw98})
    for (const int newton : {1, 5}) {
      TestScene scene = sheet(5, Held::free, 1e4, 5e3, Gravity::on);
      scene.cloth.term<StretchTerm>()->kd = 0.5;
      Method method;
      method.jacobian = jacobian;
      method.newton = newton;
      step03::System system(scene.cloth, method);
      const double h = 0.01;
      const int N = 100;
      const State end =
          simulate(stepper(scene.cloth, step03::time_step, system), scene.start, N * h, N);
      const double y = -g * h * h * N * (N + 1) / 2;
      for (int i = 0; i < scene.cloth.vertices(); ++i) {
        const Vec3 exact = scene.start.x.segment<3>(3 * i) + Vec3(0, y, 0);
        EXPECT_LT((end.x.segment<3>(3 * i) - exact).norm(), 1e-10) << "vertex " << i;
      }
    }
}

// Relative loss of angular momentum and of energy over `scene.end` in N steps.
struct Loss {
  double linear, angular, energy;
};

Loss loss(const TestScene& scene, int N, const Method& method) {
  step03::System system(scene.cloth, method);
  const State end =
      simulate(stepper(scene.cloth, step03::time_step, system), scene.start, scene.end, N);
  const Momenta before = momenta(scene.cloth, scene.start), after = momenta(scene.cloth, end);
  return {(after.linear - before.linear).norm() / before.linear_scale,
          1 - after.angular.dot(before.angular) / before.angular.squaredNorm(),
          1 - energies(scene.cloth, end).total() / energies(scene.cloth, scene.start).total()};
}

// A sheet of 5 × 5 cells that spins in its plane about its centre.
TestScene spinning() {
  TestScene scene = sheet(5, Held::free, 100, 50, Gravity::off);
  const Vec3 spin(0, 6, 0), centre(0.5, 0, -0.5);
  for (int i = 0; i < scene.cloth.vertices(); ++i)
    scene.start.v.segment<3>(3 * i) = spin.cross(Vec3(scene.start.x.segment<3>(3 * i) - centre));
  scene.end = 0.3;
  return scene;
}

// This loss is a property of backward Euler: its forces are those at the end of the step, where they have no
// torque about the place at the end, and it moves along the velocities at the end. It is of first order in h.
TEST(ImplicitSpin, KeepsMomentumAndLosesAngularMomentumInProportionToH) {
  double before = 0, order = 0;
  for (const int N : {75, 150, 300}) {
    const Loss l = loss(spinning(), N, {.newton = 50});
    EXPECT_LT(l.linear, 1e-12);
    EXPECT_GT(l.angular, 0);
    order = std::log2(before / l.angular);
    std::printf("h = %.5f: lost %.2f %% of angular momentum, %.1f %% of energy\n", 0.3 / N,
                100 * l.angular, 100 * l.energy);
    before = l.angular;
  }
  EXPECT_NEAR(order, 1, 0.1);
}

// One linear system with k ∂C ∂Cᵀ alone loses none: no ∂C/∂x has a torque about the place at the start, and
// the vertices move along straight lines from there. (The tension acts across the plane of the sheet.)
TEST(ImplicitSpin, OfOneLinearSystemKeepsAngularMomentumInItsPlane) {
  for (const int N : {75, 300}) {
    EXPECT_LT(std::abs(loss(spinning(), N, {.guard = false}).angular), 1e-12);
    EXPECT_GT(loss(spinning(), N, {.jacobian = Jacobian::bw98}).angular, 1e-3);
  }
}

// One oscillator, linear: backward Euler multiplies its amplitude by 1/√(1 + h² ω²) in every step.
TEST(ImplicitSpring, LosesTheAmplitudeThatTheoryTells) {
  Cloth cloth;
  cloth.mass = VecX::Constant(6, 0.02);
  cloth.inverse_mass = cloth.mass.cwiseInverse();
  cloth.inverse_mass.tail<3>().setZero();
  cloth.pins = {1};
  cloth.term<SpringTerm>() = SpringTerm(50);
  cloth.springs.elements = {make_spring(0, 1, 0)};  // length 0 at rest: f = −k x
  const double omega = std::sqrt(50 / 0.02);
  for (const double h_omega : {0.1, 1.0, 10.0}) {
    State state{VecX::Zero(6), VecX::Zero(6)};
    state.x[0] = 0.3;
    const auto energy = [&] {
      return 0.01 * state.v[0] * state.v[0] + 25 * state.x[0] * state.x[0];
    };
    step03::System system(cloth);
    for (int n = 0; n < 10; ++n) {
      const double before = energy();
      step03::time_step(cloth, h_omega / omega, state, system);
      EXPECT_NEAR(energy() / before * (1 + h_omega * h_omega), 1, 1e-6);
    }
  }
}

struct Case {
  const char* name;
  TestScene (*scene)();
  double kd;
  double finest_error;  // m, with 800 steps; without damping that of an independent program
};
void PrintTo(const Case& c, std::ostream* out) {
  *out << c.name;
}

class Convergence03 : public testing::TestWithParam<Case> {};
INSTANTIATE_TEST_SUITE_P(Scenes, Convergence03,
                         testing::Values(Case{"Trampoline", trampoline, 0, 6.5e-4},
                                         Case{"Curtain", curtain, 0, 1.4e-4},
                                         Case{"DampedCurtain", curtain, 0.05, 1.41e-4}),
                         [](const auto& scene) { return std::string(scene.param.name); });

TEST_P(Convergence03, IsOfOrderOne) {
  TestScene scene = GetParam().scene();
  scene.cloth.term<StretchTerm>()->kd = scene.cloth.term<ShearTerm>()->kd = GetParam().kd;
  step02::System explicit_system(scene.cloth);
  const Stepper fine = rk4(scene.cloth, step02::forces, explicit_system);
  const VecX exact = simulate(fine, scene.start, scene.end, 6400).x;
  const VecX coarser = simulate(fine, scene.start, scene.end, 3200).x;
  for (const Jacobian jacobian : {Jacobian::definite, Jacobian::bw98}) {
    Method method;
    method.jacobian = jacobian;
    step03::System system(scene.cloth, method);
    const Convergence c = converge(scene.cloth, stepper(scene.cloth, step03::time_step, system),
                                   scene.start, scene.end, 100, 3, exact);
    std::printf("%s, %s: %.2e %.2e %.2e %.2e m, last order %.3f\n", GetParam().name,
                jacobian == Jacobian::bw98 ? "bw98" : "definite", c.errors[0], c.errors[1],
                c.errors[2], c.errors[3], c.last_order());
    EXPECT_NEAR(c.last_order(), 1, 0.1);
    EXPECT_LT(rms_distance(scene.cloth, coarser, exact), 1e-3 * c.errors.back());
    if (jacobian == Jacobian::bw98) {
      EXPECT_NEAR(c.errors.back() / GetParam().finest_error, 1, 0.02);
    }
  }
}

}  // namespace implicit_motion_test
