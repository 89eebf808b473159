// --newton N: one step as the minimum of Φ(v) = ½ |v − v0|²_M + E(x0 + h v) − h/2 vᵀ D v.
#include <gtest/gtest.h>

#include "step03_implicit/time_step.h"
#include "support/dense.h"
#include "support/scenes.h"

namespace newton_test {

Method newton(int iterations, Jacobian jacobian = Jacobian::definite) {
  Method method;
  method.newton = iterations;
  method.jacobian = jacobian;
  return method;
}

// A sheet in random motion, held by two corners or free, without weight.
struct Newton : testing::Test {
  Random random{111};
  Mesh mesh = make_grid({1, 1}, {5, 5}, Diagonals::same);
  Model model;
  double h = 0.02;

  void SetUp() override {
    model.add(StretchTerm(1000));
    model.add(ShearTerm(500));
  }
  void damp() { model.term<StretchTerm>()->kd = 0.5, model.term<ShearTerm>()->kd = 0.2; }
  State thrown(double size) {
    State state = disturbed(mesh, size, random);
    for (const Pin& pin : model.pins) state.v.segment<3>(3 * pin.vertex).setZero();
    return state;
  }
};

// M (v − v0) − h f(x0 + h v) without the pinned vertices; with the damping as at x0.
VecX residual(const Cloth& cloth, double h, const State& before, const State& after) {
  const MatX D = evaluate(cloth, before, Jacobian::definite).D;
  const VecX at_rest = VecX::Zero(after.v.size());
  const VecX f = evaluate(cloth, {after.x, at_rest}, Jacobian::definite).f + D * after.v;
  VecX r = cloth.mass.cwiseProduct(after.v - before.v) - h * f;
  for (const Pin& pin : cloth.pins) r.segment<3>(3 * pin.vertex).setZero();
  return r;
}

// Newton's method with as many iterations as the options allow, even one.
void newton_step(const Cloth& cloth, double h, State& state, step03::System& system) {
  system.start = state;
  stand_still(cloth, h, state.v, system.z);
  step03::newton_step(cloth, h, system.method.newton, state, system);
}

// With one iteration `time_step` takes the plain step; newton_step, called with one iteration, starts
// from standing still instead of v0 and must arrive at the same velocities.
TEST_F(Newton, OneIterationTakenWholeIsThePlainStep) {
  damp();
  model.gravity = Vec3(0, -9.81, 0);
  model.pins = {30, 35};
  for (const double k : {10.0, 1e3, 1e4})
    for (int n = 0; n < 5; ++n) {
      model.term<StretchTerm>()->k = k, model.term<ShearTerm>()->k = k / 2;
      const Cloth cloth = make_cloth(mesh, model);
      const State start = thrown(0.002);
      State plain = start, once = start;
      step03::System a(cloth, newton(1)), b(cloth, newton(1));
      step03::time_step(cloth, h, plain, a);
      newton_step(cloth, h, once, b);
      EXPECT_EQ(b.dv, once.v) << "a step that was halved";
      EXPECT_LT((once.v - plain.v).norm(), 1e-12 * (plain.v - start.v).norm()) << "k = " << k;
    }
}

// The state after n iterations is the result of a step that is allowed n.
TEST_F(Newton, PhiNeverRisesWithinAStep) {
  damp();
  model.gravity = Vec3(0, -9.81, 0);
  for (const Jacobian jacobian : {Jacobian::definite, Jacobian::bw98})
    for (const double size : {0.01, 0.1, 1.0}) {
      const Cloth cloth = make_cloth(mesh, model);
      const State start = thrown(size);
      const MatX D = evaluate(cloth, start, jacobian).D;
      const auto Phi = [&](const VecX& v) {
        return kinetic_energy(cloth, v - start.v) + potential_energy(cloth, start.x + h * v) -
               0.5 * h * v.dot(D * v);
      };
      double before = Phi(VecX::Zero(start.v.size()));
      for (int iterations = 1; iterations <= 12; ++iterations) {
        State state = start;
        step03::System system(cloth, newton(iterations, jacobian));
        newton_step(cloth, h, state, system);
        const double now = Phi(state.v);
        EXPECT_LE(now, before + 1e-12 * std::abs(before)) << iterations << " iterations";
        before = now;
      }
      EXPECT_LT(before, 0.99 * Phi(VecX::Zero(start.v.size()))) << "nothing was gained";
    }
}

// v = 0 is allowed, so Φ(v1) ≤ Φ(0):  E(x1) + ½ |v1 − v0|²_M ≤ E(x0) + ½ |v0|²_M
TEST_F(Newton, AConvergedStepNeverGainsEnergy) {
  for (const double step : {0.01, 0.1, 1.0, 10.0})
    for (const double size : {0.02, 0.5}) {
      const Cloth cloth = make_cloth(mesh, model);
      const State start = thrown(size);
      State state = start;
      step03::System system(cloth, newton(2000));
      step03::time_step(cloth, step, state, system);
      EXPECT_EQ(system.counts.unconverged, 0) << "h = " << step << ", " << size << " m";
      const double before = potential_energy(cloth, start.x) + kinetic_energy(cloth, start.v);
      EXPECT_LE(potential_energy(cloth, state.x) + kinetic_energy(cloth, state.v - start.v),
                before * (1 + 1e-13))
          << "h = " << step << ", " << size << " m";
      EXPECT_LT(residual(cloth, step, start, state).norm(),
                1e-3 * residual(cloth, step, start, {start.x, VecX::Zero(start.v.size())}).norm());
    }
}

// Springs of rest length 0 are linear, f = −k (x_0 − x_1): one linearised step solves backward Euler.
TEST_F(Newton, LinearForcesLeaveNoResidualAfterThePlainStep) {
  Cloth cloth = make_cloth(mesh, {});
  cloth.gravity = Vec3(0, -9.81, 0);
  cloth.term<SpringTerm>() = SpringTerm(50);
  for (int i = 0; i + 7 < cloth.vertices(); ++i) {
    cloth.springs.elements.push_back(make_spring(i, i + 1, 0));
    cloth.springs.elements.push_back(make_spring(i, i + 7, 0));
  }
  const State start = thrown(0.3);
  State state = start;
  step03::System system(cloth);
  step03::time_step(cloth, h, state, system);
  EXPECT_LT(residual(cloth, h, start, state).norm(),
            1e-13 * residual(cloth, h, start, {start.x, VecX::Zero(start.v.size())}).norm());
  EXPECT_LT((state.x - start.x - h * state.v).norm(), 1e-15);
}

// The errors |v_n − v*| of the iterations, from steps that are allowed 1, 2, 3 … of them.
std::vector<double> errors(const Cloth& cloth, double h, const State& start, Jacobian jacobian) {
  std::vector<int> free;
  for (int i = 0; i < cloth.mass.size(); ++i)
    if (cloth.inverse_mass[i] > 0) free.push_back(i);
  const auto after = [&](int iterations) {
    State state = start;
    step03::System system(cloth, newton(iterations, jacobian));
    newton_step(cloth, h, state, system);
    EXPECT_EQ(system.counts.indefinite, 0);
    return state.v;
  };
  State exact{start.x, after(4)};  // and on with dense matrices
  for (int n = 0; n < 20; ++n) {
    exact.x = start.x + h * exact.v;
    const VecX r = residual(cloth, h, start, exact);
    MatX A = -h * h * evaluate(cloth, exact, Jacobian::bw98).K;
    A.diagonal() += cloth.mass;
    exact.v(free) -= solve(A(free, free), r(free));
  }
  std::vector<double> all;
  for (int n = 1; n <= 20; ++n) all.push_back((after(n) - exact.v).norm() / exact.v.norm());
  return all;
}

// e_{n+1} ~ e_n^p over the last step that ends a thousand times above rounding.
double exponent(const std::vector<double>& e) {
  size_t last = 2;
  while (last + 1 < e.size() && e[last + 1] > 1e3 * 2.2e-16) ++last;
  return std::log(e[last] / e[last - 1]) / std::log(e[last - 1] / e[last - 2]);
}

// Without damping the printed matrix is the full second derivative of Φ. Where that is positive
// definite, here in a sheet that its edges hold stretched, Newton's method converges quadratically;
// With the definite matrix, which leaves out what acts in the plane, it converges linearly.
TEST_F(Newton, ConvergesQuadraticallyWithTheFullSecondDerivative) {
  for (int i = 0; i < mesh.vertices(); ++i)  // by all edges, stretched by 10 %
    if (i < 6 || i >= 30 || i % 6 == 0 || i % 6 == 5) model.pins.push_back(i);
  const Cloth cloth = make_cloth(mesh, model);
  State start = thrown(0.005);
  start.x += 0.1 * mesh.x;
  const auto full = errors(cloth, h, start, Jacobian::bw98);
  const auto part = errors(cloth, h, start, Jacobian::definite);
  std::printf("bw98:     ");
  for (size_t n = 0; n < 4; ++n) std::printf(" %.1e", full[n]);
  std::printf("\ndefinite: ");
  for (size_t n = 0; n < 4; ++n) std::printf(" %.1e", part[n]);
  std::printf("\nexponent %.2f\n", exponent(full));
  EXPECT_GE(exponent(full), 1.7);
  EXPECT_GT(part[2], 1e3 * full[2]);
}

// Where shear carries as much as stretch, the tension across the triangles counts. A matrix that keeps of
// each thread its own tension, and nothing of shear, needs 58 iterations in the mean.
TEST(NewtonOfADroppedSheet, NeedsFewIterations) {
  const TestScene scene = sheet(12, Held::by_two_corners, 1000, 1000, Gravity::on);
  const Cloth& cloth = scene.cloth;
  const double h = 1.0 / 60;
  State state = scene.start;
  step03::System system(cloth, newton(200));
  double most = 0, sum = 0;
  for (int n = 0; n < 60; ++n) {
    if (n % 12 == 0) {
      State at = state;  // as newton_step, but to the gradient 1e-8 of the first, by M⁻¹
      step03::System its(cloth);
      its.start = at;
      stand_still(cloth, h, at.v, at.v);
      double first = 0, norm = 1;
      int iterations = 0;
      for (; norm > 1e-8 && iterations < 100; ++iterations) {
        its.trial.x = its.start.x + h * at.v;
        step03::forces(cloth, its.trial, its);
        its.b = cloth.mass.cwiseProduct(its.start.v - at.v) + h * its.f;
        const double now = std::sqrt(its.b.cwiseAbs2().dot(cloth.inverse_mass));
        if (iterations == 0) first = now;
        norm = now / first;
        step03::solve(cloth, h, its);
        at.v += step03::line_search(cloth, h, at.v, its) * its.dv;
      }
      most = std::max(most, double(iterations - 1));
      sum += iterations - 1;
    }
    step03::time_step(cloth, h, state, system);
  }
  std::printf("Newton iterations: %.1f in the mean, at most %.0f\n", sum / 5, most);
  EXPECT_NEAR(sum / 5, 11.2, 1);
}

// Along a direction in which Φ does not fall no step is taken.
TEST_F(Newton, ALineSearchThatFindsNoFallTakesNoStep) {
  const Cloth cloth = make_cloth(mesh, model);
  const State state = thrown(0.1);
  step03::System system(cloth);
  system.start = state;
  step03::forces(cloth, state, system);
  system.b = h * system.f;
  system.dv = -system.b;  // uphill
  system.b = -system.b;   // and a slope that says downhill
  EXPECT_EQ(step03::line_search(cloth, h, state.v, system), 0);
  system.dv = -system.dv, system.b = -system.b;
  EXPECT_GT(step03::line_search(cloth, h, state.v, system), 0);
}

// If E is convex, exact backward Euler satisfies the guard. Springs without length at rest: E is quadratic,
// and one linear system is exact. From any start, whatever h, nothing is taken again.
TEST_F(Newton, TheGuardAcceptsBackwardEulerOfAConvexEnergy) {
  Cloth cloth = make_cloth(mesh, {});
  cloth.gravity = Vec3(0, -9.81, 0);
  cloth.term<SpringTerm>() = SpringTerm(50);
  for (int i = 0; i + 7 < cloth.vertices(); ++i)
    cloth.springs.elements.push_back(make_spring(i, i + 7, 0));
  for (const double step : {1e-3, 0.1, 10.0}) {
    State state = thrown(0.3);
    step03::System system(cloth);
    for (int n = 0; n < 20; ++n) step03::time_step(cloth, step, state, system);
    EXPECT_EQ(system.counts.redone, 0) << "h = " << step;
  }
}

TEST(StandStill, IsAFreeFallWithoutPinsAndTheMotionOfThePinsWithThem) {
  Cloth cloth;
  cloth.mass = VecX::Ones(9);
  cloth.mass.tail<3>().setConstant(2);
  cloth.gravity = Vec3(0, -10, 0);
  VecX v(9), z(9);
  v << 4, 0, 0, 0, 8, 0, 0, 0, 4;
  const auto of = [&](int i) { return Vec3(z.segment<3>(3 * i)); };
  stand_still(cloth, 0.1, v, z);
  const Vec3 falling = Vec3(1, 2, 2) + Vec3(0, -1, 0);
  for (int i = 0; i < 3; ++i) EXPECT_LT((of(i) - falling).norm(), 1e-15);

  cloth.pins = {Pin(0), Pin(1, Mat3::Zero(), Vec3(2, 0, 0))};
  stand_still(cloth, 0.1, v, z);
  EXPECT_EQ(of(0), Vec3(0, 0, 0));
  EXPECT_EQ(of(1), Vec3(2, 0, 0));
  EXPECT_LT((of(2) - Vec3(1, 0, 0)).norm(), 1e-15) << "the mean of what the pins hold";

  const Mat3 along_y = Vec3::UnitY().asDiagonal();
  cloth.pins = {Pin(0), Pin(1, along_y)};  // the first pin lets nothing slide
  stand_still(cloth, 0.1, v, z);
  EXPECT_LT(z.norm(), 1e-15);

  cloth.pins = {Pin(1, along_y, Vec3(2, 7, 0))};  // it slides along y
  stand_still(cloth, 0.1, v, z);
  for (int i = 0; i < 3; ++i) EXPECT_LT((of(i) - Vec3(2, falling.y(), 0)).norm(), 1e-15);
}

// A step counts that it had too few iterations.
TEST_F(Newton, AStepThatDoesNotConvergeIsCounted) {
  const Cloth cloth = make_cloth(mesh, model);
  State state = thrown(0.3);
  step03::System system(cloth, newton(2));
  step03::time_step(cloth, h, state, system);
  EXPECT_EQ(system.counts.unconverged, 1);
}

}  // namespace newton_test
