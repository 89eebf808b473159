// Modified conjugate gradients: A Δv = b where pins hold a vertex in three, two or one direction.
#include <gtest/gtest.h>

#include "support/pinned.h"
#include "support/scenes.h"
#include "ways/simulator.h"

namespace cg_test {

struct ModifiedCG : testing::TestWithParam<const char*> {
  const char* name = GetParam();
};
INSTANTIATE_TEST_SUITE_P(Preconditioners, ModifiedCG, testing::ValuesIn(all_preconditioners),
                         [](const auto& test) { return std::string(test.param); });

TEST_P(ModifiedCG, FindsTheMinimumThatThePinsAllow) {
  for (const Diagonals diagonals : {Diagonals::same, Diagonals::alternating})
    for (const unsigned seed : {131, 132, 133}) {
      const PinnedSheet sheet(seed, diagonals);
      const step04::System system = sheet.step(cg(name, 1e-12));
      const VecX z = prescribed(sheet.cloth, sheet.state.v);
      const VecX exact = reduced_solution(sheet.cloth, dense(system.A), system.b, z);
      EXPECT_LT(relative(system.dv, exact), 1e-9);
      EXPECT_GT((exact - z).norm(), 1) << "nothing to solve";
      EXPECT_EQ(system.counts.capped + system.counts.indefinite, 0);
    }
}

// b = h (f + h K v) and A = M − h D − h² K, for every preconditioner.
TEST_P(ModifiedCG, SystemIsThatOfStep03) {
  const PinnedSheet sheet(134);
  const step04::System system = sheet.step(cg(name, 1e-3));
  const Evaluated e = evaluate(sheet.cloth, sheet.state, Jacobian::definite);
  MatX A = -(sheet.h * e.D + sheet.h * sheet.h * e.K);
  A.diagonal() += sheet.cloth.mass;
  EXPECT_LT(relative(dense(system.A), A), 1e-14);
  EXPECT_LT(relative(system.b, sheet.h * (e.f + sheet.h * (e.K * sheet.state.v))), 1e-13);
}

// With every tolerance, in the first step and after many.
TEST_P(ModifiedCG, MeetsWhatThePinsPrescribeToTheLastDigits) {
  const PinnedSheet sheet(135);
  const MatX S = filter_matrix(sheet.cloth);
  const auto held = [&](const VecX& v) { return VecX(v - S * v); };
  for (const double tolerance : {0.5, 1e-8}) {
    step04::System system(sheet.cloth, cg(name, tolerance));
    State state = sheet.state;
    for (int n = 0; n < 20; ++n) {
      const VecX z = prescribed(sheet.cloth, state.v);
      step04::time_step(sheet.cloth, sheet.h, state, system);
      EXPECT_LT((held(system.dv) - z).cwiseAbs().maxCoeff(), 1e-14) << "step " << n;
      EXPECT_LT(prescribed(sheet.cloth, state.v).cwiseAbs().maxCoeff(), 1e-14) << "step " << n;
    }
    EXPECT_GT((state.x - sheet.state.x).norm(), 0.1);
  }
}

// Not "nearly": a vertex that is pinned where it rests has the same bits after the run.
TEST_P(ModifiedCG, PinsAtRestDoNotMove) {
  PinnedSheet sheet(136);
  for (Pin& pin : sheet.model.pins) pin = Pin(pin.vertex);
  sheet.cloth = make_cloth(sheet.mesh, sheet.model);
  for (const Pin& pin : sheet.model.pins) sheet.state.v.segment<3>(3 * pin.vertex).setZero();
  step04::System system(sheet.cloth, cg(name, 1e-4));
  State state = sheet.state;
  for (int n = 0; n < 10; ++n) step04::time_step(sheet.cloth, sheet.h, state, system);
  for (const Pin& pin : sheet.model.pins)
    EXPECT_EQ(state.x.segment<3>(3 * pin.vertex), sheet.state.x.segment<3>(3 * pin.vertex));
}

// The remainder A Δv − b is h times the force of the pins: it lies in the directions they hold.
TEST_P(ModifiedCG, RemainderLiesInTheHeldDirections) {
  const PinnedSheet sheet(137);
  const step04::System system = sheet.step(cg(name, 1e-12));
  const VecX remainder = dense(system.A) * system.dv - system.b;
  EXPECT_LT((filter_matrix(sheet.cloth) * remainder).norm(), 1e-10 * remainder.norm());
  EXPECT_GT(remainder.norm(), 0.1);
}

// A cloth at rest hangs by its top row, whose inner vertices may slide along the row. Together the pins
// bear the weight of all vertices, their own included, and exert no horizontal force.
TEST_P(ModifiedCG, PinsOfAClothAtRestBearItsWeight) {
  PinnedSheet sheet(138);
  sheet.model.pins = {28, 34};
  for (int i = 29; i < 34; ++i) sheet.model.pins.emplace_back(i, only(Vec3::UnitX()));
  sheet.cloth = make_cloth(sheet.mesh, sheet.model);
  sheet.state = {sheet.mesh.x, VecX::Zero(sheet.mesh.x.size())};
  step04::System system(sheet.cloth, cg(name, 1e-10));
  for (int n = 0; n < 60; ++n) step04::time_step(sheet.cloth, 0.5, sheet.state, system);
  EXPECT_LT(sheet.state.v.cwiseAbs().maxCoeff(), 1e-8) << "not at rest";

  sheet.state.v.setZero();
  const step04::System last = sheet.step(cg(name, 1e-10));
  const VecX force = (dense(last.A) * last.dv - last.b) / sheet.h;
  Vec3 sum = Vec3::Zero();
  for (const Pin& pin : sheet.cloth.pins) sum += force.segment<3>(3 * pin.vertex);
  const double weight = 9.81 * sheet.cloth.mass.sum() / 3;
  EXPECT_NEAR(weight, 9.81 * 0.2, 1e-12);
  EXPECT_LT((sum - Vec3(0, weight, 0)).norm(), 1e-7 * weight);
}

TEST_P(ModifiedCG, AllVerticesPinnedNeedNoIteration) {
  PinnedSheet sheet(139);
  sheet.model.pins.clear();
  for (int i = 0; i < sheet.mesh.vertices(); ++i)
    sheet.model.pins.emplace_back(i, Mat3::Zero(), sheet.random.vector(3, 1));
  sheet.cloth = make_cloth(sheet.mesh, sheet.model);
  const step04::System system = sheet.step(cg(name, 1e-4));
  EXPECT_EQ(system.dv, prescribed(sheet.cloth, sheet.state.v));
  EXPECT_EQ(system.counts.iterations + system.counts.capped + system.counts.indefinite, 0);
}

TEST_P(ModifiedCG, WithoutForcesNothingIsToBeSolved) {
  PinnedSheet sheet(140);
  const Vec3 velocity(1, 2, 3);
  for (Pin& pin : sheet.model.pins) pin.velocity = velocity;
  sheet.model.gravity.reset();
  sheet.cloth = make_cloth(sheet.mesh, sheet.model);
  step04::System system = sheet.step(cg(name, 1e-4));
  system.counts.iterations = 0;
  system.b.setZero();
  State still{sheet.mesh.x, velocity.replicate(sheet.mesh.vertices(), 1)};
  step04::solve(sheet.cloth, sheet.h, still.v, system);
  EXPECT_EQ(system.dv, VecX::Zero(still.v.size()).eval());
  EXPECT_EQ(system.counts.iterations + system.counts.capped + system.counts.indefinite, 0);
}

// The printed matrix of a sheet compressed in its plane is not definite: the step counts it and goes on.
TEST_P(ModifiedCG, AnIndefiniteMatrixIsCounted) {
  PinnedSheet sheet(141);
  sheet.state = {0.7 * sheet.mesh.x, VecX::Zero(sheet.mesh.x.size())};
  Method method = cg(name, 1e-8);
  EXPECT_EQ(sheet.step(method).counts.indefinite, 0);
  method.jacobian = Jacobian::bw98;
  step04::System system(sheet.cloth, method);
  step04::time_step(sheet.cloth, sheet.h, sheet.state, system);
  EXPECT_EQ(system.counts.indefinite, 1);
  for (int n = 0; n < 4; ++n) step04::time_step(sheet.cloth, sheet.h, sheet.state, system);
  EXPECT_TRUE(sheet.state.x.allFinite());
  EXPECT_EQ(system.counts.capped, 0);
}

TEST_P(ModifiedCG, WhatIsNotANumberEndsTheIteration) {
  PinnedSheet sheet(142);
  sheet.state.x[0] = std::nan("");
  Method method = cg(name, 1e-8);
  method.guard = false;  // or the step is taken again
  const step04::System system = sheet.step(method);
  EXPECT_EQ(system.counts.indefinite, 1);
  EXPECT_EQ(system.counts.iterations, 0);

  step04::System finite = PinnedSheet(142).step(cg(name, 1e-8));  // A is, b is not
  finite.b[20] = std::nan("");
  step04::solve(sheet.cloth, sheet.h, PinnedSheet(142).state.v, finite);
  EXPECT_EQ(finite.counts.indefinite, 1);
}

TEST_P(ModifiedCG, ASystemThatNeedsMoreIterationsThanAllowedIsCounted) {
  const PinnedSheet sheet(143);
  Method method = cg(name, 1e-10);
  const long needed = sheet.step(method).counts.iterations;
  method.max_iterations = int(needed) + 1;
  EXPECT_EQ(sheet.step(method).counts.capped, 0);
  method.max_iterations = int(needed) - 1;
  const step04::System stopped = sheet.step(method);
  EXPECT_EQ(stopped.counts.capped, 1);
  EXPECT_EQ(stopped.counts.iterations, needed - 1);
  EXPECT_TRUE(stopped.dv.allFinite());
}

// The result is the first Δv whose rᵀ P⁻¹ r is at most tolerance² Δvᵀ M Δv.
TEST_P(ModifiedCG, StopsAsSoonAsTheToleranceSays) {
  const PinnedSheet sheet(144);
  const MatX S = filter_matrix(sheet.cloth);
  const auto left = [&](const step04::System& system) {
    const VecX r = S * (system.b - dense(system.A) * system.dv);
    VecX s;
    system.preconditioner->apply(r, s);
    return std::sqrt(r.dot(S * s) / system.dv.cwiseAbs2().dot(sheet.cloth.mass));
  };
  for (const double tolerance : {1e-1, 1e-4, 1e-8}) {
    Method method = cg(name, tolerance);
    const step04::System system = sheet.step(method);
    EXPECT_LT(left(system), 1.0001 * tolerance);
    method.max_iterations = int(system.counts.iterations) - 1;
    EXPECT_GT(left(sheet.step(method)), 0.9999 * tolerance);
  }
}

TEST_P(ModifiedCG, GivesTheSameBitsAgain) {
  const PinnedSheet sheet(145);
  step04::System first(sheet.cloth, cg(name, 1e-4)), second(sheet.cloth, cg(name, 1e-4));
  State a = sheet.state, b = sheet.state;
  for (int n = 0; n < 10; ++n) {
    step04::time_step(sheet.cloth, sheet.h, a, first);
    step04::time_step(sheet.cloth, sheet.h, b, second);
  }
  EXPECT_EQ(a.x, b.x);
  EXPECT_EQ(a.v, b.v);
  EXPECT_EQ(first.counts.iterations, second.counts.iterations);
}

// Newton's method has the same result with conjugate gradients and with a factorisation.
TEST_P(ModifiedCG, NewtonFindsTheMinimumOfStep03) {
  PinnedSheet sheet(146);
  sheet.model.pins = {28, 34, 12};
  sheet.cloth = make_cloth(sheet.mesh, sheet.model);
  Method method = cg(name, 1e-8);
  method.newton = 30;
  const auto direct = make_simulator({3, method}, sheet.cloth);
  step04::System iterative(sheet.cloth, method);
  State a = sheet.state, b = sheet.state;
  for (const Pin& pin : sheet.model.pins) {
    a.v.segment<3>(3 * pin.vertex).setZero();
    b.v.segment<3>(3 * pin.vertex).setZero();
  }
  for (int n = 0; n < 3; ++n) {
    direct->step(sheet.h, a);
    step04::time_step(sheet.cloth, sheet.h, b, iterative);
  }
  EXPECT_LT(relative(b.v, a.v), 1e-6);
  EXPECT_EQ(direct->counts().unconverged + iterative.counts.unconverged, 0);
  EXPECT_EQ(iterative.counts.indefinite, 0);
}

// With pins that move: M (v − v0) − h f(x0 + h v) = 0 in all directions that they leave free.
TEST_P(ModifiedCG, NewtonCarriesMovingPins) {
  const PinnedSheet sheet(147);
  Method method = cg(name, 1e-8);
  method.newton = 100;
  step04::System system(sheet.cloth, method);
  State state = sheet.state;
  step04::time_step(sheet.cloth, sheet.h, state, system);
  EXPECT_EQ(system.counts.unconverged, 0);
  EXPECT_LT(prescribed(sheet.cloth, state.v).cwiseAbs().maxCoeff(), 1e-14);

  const MatX D = evaluate(sheet.cloth, sheet.state, Jacobian::definite).D;
  const auto residual = [&](const VecX& v) {
    const State at_rest{sheet.state.x + sheet.h * v, VecX::Zero(v.size())};
    const VecX f = evaluate(sheet.cloth, at_rest, Jacobian::definite).f + D * v;
    const VecX r = sheet.cloth.mass.cwiseProduct(v - sheet.state.v) - sheet.h * f;
    return (filter_matrix(sheet.cloth) * r).norm();
  };
  EXPECT_LT(residual(state.v), 1e-3 * residual(sheet.state.v));
}

// P⁻¹ = diag(A), as the paper's P reads literally, in place of its inverse.
class Multiplies : public Preconditioner {
 public:
  void set(const BlockMatrix& A) override {
    diagonal.resize(3 * A.rows());
    for (int i = 0; i < A.rows(); ++i) diagonal.segment<3>(3 * i) = A.diagonal[i].diagonal();
  }
  void apply(const VecX& r, VecX& s) override { s = diagonal.cwiseProduct(r); }

 private:
  VecX diagonal;
};

TEST(Jacobi, DividesByTheDiagonal) {
  const PinnedSheet sheet(148, Diagonals::same, {12, 12});
  const auto iterations = [&](const char* name, bool literal) {
    step04::System system(sheet.cloth, cg(name, 1e-8));
    if (literal) system.preconditioner = std::make_unique<Multiplies>();
    State state = sheet.state;
    step04::time_step(sheet.cloth, sheet.h, state, system);
    EXPECT_EQ(system.counts.capped + system.counts.indefinite, 0);
    return system.counts.iterations;
  };
  const long none = iterations("none", false), divided = iterations("jacobi", false),
             multiplied = iterations("jacobi", true);
  std::printf("iterations: none %ld, Jacobi %ld, multiplied %ld\n", none, divided, multiplied);
  EXPECT_LT(divided, none);
  EXPECT_NEAR(double(divided), 198, 10);
  EXPECT_NEAR(double(multiplied), 824, 80);
}

// The system keeps momentum: its rows add up to Σ m Δv = h Σ m g. Conjugate gradients that stop early do not.
// A direct solver does.
double momentum_lost(const Configuration& configuration) {
  TestScene scene = sheet(12, Held::free, 1000, 500, Gravity::on);
  const auto simulator = make_simulator(configuration, scene.cloth);
  Random random(150);
  State state = scene.start;
  state.x += random.vector(int(state.x.size()), 0.01);
  const int steps = 50;
  for (int n = 0; n < steps; ++n) simulator->step(0.01, state);
  double momentum = 0;
  for (int i = 1; i < state.v.size(); i += 3) momentum += scene.cloth.mass[i] * state.v[i];
  return std::abs(momentum / (-g * 0.01 * steps * scene.cloth.mass.sum() / 3) - 1);
}

TEST(FreeFall, LosesLessOfTheMomentumThanTheTolerance) {
  for (const double tolerance : {1e-2, 1e-4, 1e-8}) {
    const double lost = momentum_lost({4, cg("block", tolerance)});
    std::printf("tolerance %.0e: %.1e of the momentum lost\n", tolerance, lost);
    EXPECT_LT(lost, tolerance);
    if (tolerance == 1e-4) {
      EXPECT_NEAR(lost, 5e-6, 1e-6);
    }
  }
  const double lost = momentum_lost({3});
  std::printf("directly: %.1e of the momentum lost\n", lost);
  EXPECT_LT(lost, 1e-11);
}

// P⁻¹ = −1: rᵀ P⁻¹ r is less than every tolerance, and nothing is solved.
class Negative : public Preconditioner {
 public:
  void set(const BlockMatrix&) override {}
  void apply(const VecX& r, VecX& s) override { s = -r; }
};

TEST(Preconditioner, OneThatIsNotDefiniteIsCountedAndDoesNotPassForSolved) {
  const PinnedSheet sheet(149, Diagonals::same, {4, 4});
  step04::System system(sheet.cloth, cg("none", 1e-4));
  system.method.guard = false;
  system.preconditioner = std::make_unique<Negative>();
  State state = sheet.state;
  step04::time_step(sheet.cloth, sheet.h, state, system);
  EXPECT_EQ(system.counts.indefinite, 1);
}

// 1 m², k = 1e4 N/m, h = 0.01 s, hung by two corners, 20 steps after the flat start.
struct Hanging {
  explicit Hanging(int n) : cells(n) {
    const Mesh mesh = make_grid({1, 1}, {n, n}, Diagonals::same);
    Model model;
    model.add(StretchTerm(1e4, 10));
    model.add(ShearTerm(1e3, 1));
    model.gravity = Vec3(0, -9.81, 0);
    model.pins = {mesh.grid->vertex(0, n), mesh.grid->vertex(n, n)};
    cloth = make_cloth(mesh, model);
    state = {mesh.x, VecX::Zero(mesh.x.size())};
    const auto direct = make_simulator({3}, cloth);
    for (int i = 0; i < 20; ++i) direct->step(h, state);
  }
  double iterations(const char* name) const {
    step04::System system(cloth, cg(name, 1e-3));
    State end = state;
    step04::time_step(cloth, h, end, system);
    EXPECT_EQ(system.counts.capped + system.counts.indefinite, 0);
    std::printf("%d x %d cells, %s: %ld iterations\n", cells, cells, name,
                system.counts.iterations);
    return double(system.counts.iterations);
  }

  int cells;
  double h = 0.01;
  Cloth cloth;
  State state;
};

TEST(Iterations, OfMultigridHardlyGrowWithTheGrid) {
  std::array<double, 3> block{}, ic{}, multigrid{};
  for (const size_t i : {0, 1, 2}) {
    const Hanging cloth(16 << i);
    block[i] = cloth.iterations("block");
    ic[i] = cloth.iterations("ic");
    multigrid[i] = cloth.iterations("multigrid");
    EXPECT_LT(block[i], 0.85 * cloth.iterations("jacobi"));
    EXPECT_LT(ic[i], block[i] / 3);
    EXPECT_LT(multigrid[i], ic[i] / 2);
  }
  EXPECT_LT(multigrid[2], 2 * multigrid[0]);
  for (const size_t i : {1, 2}) {  // as the number of vertices in a row
    EXPECT_NEAR(block[i] / block[i - 1], 2, 0.4);
    EXPECT_NEAR(ic[i] / ic[i - 1], 2, 0.4);
  }
  EXPECT_LT(block[2], 1.2 * 484);
  EXPECT_LT(ic[2], 1.2 * 85);
  EXPECT_LT(multigrid[2], 1.2 * 9);
}

// 4 of 7 blocks in a row, for each vertex, and where they stand.
TEST(Memory, OfAMatrixIs300BytesPerVertex) {
  const Mesh mesh = make_grid({1, 1}, {64, 64}, Diagonals::same);
  Model model;
  model.add(StretchTerm(1e4));
  const BlockMatrix A = make_block_matrix(make_cloth(mesh, model));
  const size_t bytes = sizeof(Mat3) * (A.diagonal.size() + A.upper.size()) +
                       sizeof(int) * (A.row_start.size() + A.column.size());
  std::printf("%.0f bytes per vertex\n", double(bytes) / A.rows());
  EXPECT_NEAR(double(bytes) / A.rows(), 300, 1.5);
}

}  // namespace cg_test
