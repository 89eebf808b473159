// A Δv = b: three direct solvers have the same result.
#include <gtest/gtest.h>

#include "step03_implicit/time_step.h"
#include "support/dense.h"

namespace solvers_test {

struct Solvers : testing::Test {
  Random random{101};
  Mesh mesh = make_grid({1, 1}, {6, 6}, Diagonals::alternating);
  Model model;
  State state;
  double h = 1.0 / 60;

  void SetUp() override {
    model.add(StretchTerm(1000, 0.5));
    model.add(ShearTerm(500, 0.2));
    model.gravity = Vec3(0, -9.81, 0);
    model.pins = {42, 48};
    state = disturbed(mesh, 0.05, random);
    for (const Pin& pin : model.pins) {
      state.x.segment<3>(3 * pin.vertex) = mesh.x.segment<3>(3 * pin.vertex);
      state.v.segment<3>(3 * pin.vertex).setZero();
    }
  }

  // A system whose A and Δv are those of a step from `state`.
  step03::System step(const Cloth& cloth, const Method& method, State end) const {
    step03::System system(cloth, method);
    step03::time_step(cloth, h, end, system);
    return system;
  }
  step03::System step(const Cloth& cloth, const Method& method) const {
    return step(cloth, method, state);
  }
};

bool has_cholmod(const Cloth& cloth) {
  Method method;
  method.solver = "cholmod";
  try {
    step03::System system(cloth, method);
    return true;
  } catch (const std::invalid_argument&) {
    return false;
  }
}

TEST_F(Solvers, AgreeWithEachOtherAndWithADenseSolution) {
  const Cloth cloth = make_cloth(mesh, model);
  const step03::System ldlt = step(cloth, {});
  std::vector<int> free;
  for (int i = 0; i < cloth.mass.size(); ++i)
    if (cloth.inverse_mass[i] > 0) free.push_back(i);
  VecX expected = VecX::Zero(cloth.mass.size());
  expected(free) = solve(dense(ldlt.A)(free, free), ldlt.b(free));
  EXPECT_GT(expected.norm(), 1);
  EXPECT_LT(relative(ldlt.dv, expected), 1e-10);
  for (const char* name : {"inverse", "cholmod"}) {
    if (std::string(name) == "cholmod" && !has_cholmod(cloth)) continue;
    Method method;
    method.solver = name;
    EXPECT_LT(relative(step(cloth, method).dv, ldlt.dv), 1e-10) << name;
  }
}

// b = h (f + h K v) and A = M − h D − h² K, with the same K on both sides.
TEST_F(Solvers, SystemIsThatOfTheLinearisedStep) {
  const Cloth cloth = make_cloth(mesh, model);
  for (const Jacobian jacobian : {Jacobian::definite, Jacobian::bw98}) {
    Method method;
    method.jacobian = jacobian;
    const step03::System system = step(cloth, method);
    const Evaluated e = evaluate(cloth, state, jacobian);
    MatX A = -(h * e.D + h * h * e.K);
    A.diagonal() += cloth.mass;
    EXPECT_LT(relative(dense(system.A), A), 1e-14);
    EXPECT_LT(relative(system.b, h * (e.f + h * (e.K * state.v))), 1e-13);
  }
}

TEST_F(Solvers, PinnedVerticesLeaveTheSystem) {
  const Cloth cloth = make_cloth(mesh, model);
  for (const char* name : {"ldlt", "inverse", "cholmod"}) {
    if (std::string(name) == "cholmod" && !has_cholmod(cloth)) continue;
    Method method;
    method.solver = name;
    State end = state;
    step03::System system(cloth, method);
    for (int n = 0; n < 10; ++n) {
      step03::time_step(cloth, h, end, system);
      for (const Pin& pin : model.pins)
        EXPECT_EQ(system.dv.segment<3>(3 * pin.vertex), Vec3::Zero());
    }
    for (const Pin& pin : model.pins)
      EXPECT_EQ(end.x.segment<3>(3 * pin.vertex), mesh.x.segment<3>(3 * pin.vertex)) << name;
    EXPECT_GT((end.x - state.x).norm(), 0.1);
  }
}

TEST_F(Solvers, AllVerticesPinnedIsNoSystemAtAll) {
  for (int i = 0; i < mesh.vertices(); ++i) model.pins.push_back(i);
  const Cloth cloth = make_cloth(mesh, model);
  for (const char* name : {"ldlt", "inverse", "cholmod"}) {
    Method method;
    method.solver = name;
    State end{mesh.x, VecX::Zero(mesh.x.size())};
    const step03::System system = step(cloth, method, end);
    EXPECT_EQ(system.dv, VecX::Zero(mesh.x.size()).eval()) << name;
    EXPECT_EQ(system.counts.indefinite, 0) << name;
  }
}

// 200 × 200 cells have 121 197 free coordinates: four dense matrices of them are 470 GB.
TEST_F(Solvers, InverseRefusesWithTheMemoryItWouldNeed) {
  const Cloth cloth = make_cloth(make_grid({1, 1}, {200, 200}, Diagonals::same), model);
  Method method;
  method.solver = "inverse";
  try {
    step03::System system(cloth, method);
    FAIL() << "it did not refuse";
  } catch (const std::invalid_argument& refusal) {
    const std::string text = refusal.what();
    EXPECT_NE(text.find("470 GB"), std::string::npos) << text;
    EXPECT_NE(text.find("--solver ldlt"), std::string::npos) << text;
  }
}

TEST_F(Solvers, AnUnknownNameIsRefused) {
  Method method;
  method.solver = "magic";
  EXPECT_THROW(step03::System(make_cloth(mesh, model), method), std::invalid_argument);
}

// The notes' form (I − h M⁻¹ D − h² M⁻¹ K) Δv = h M⁻¹ (f + h K v).
TEST_F(Solvers, TheNotesFormGivesTheSameStepAndIsSymmetricOnlyForEqualMasses) {
  model.pins.clear();
  for (const bool equal : {true, false}) {
    Cloth cloth = make_cloth(mesh, model);
    if (equal) {
      cloth.mass.setConstant(0.01);
      cloth.inverse_mass.setConstant(100);
    }
    const Evaluated e = evaluate(cloth, state, Jacobian::definite);
    const auto inverse_mass = cloth.inverse_mass.asDiagonal();
    const MatX I = MatX::Identity(e.K.rows(), e.K.cols());
    const MatX A = I - inverse_mass * (h * e.D + h * h * e.K);
    const VecX b = h * (inverse_mass * (e.f + h * (e.K * state.v)));
    EXPECT_LT(relative(solve(A, b), step(cloth, {}).dv), 1e-10);
    const double asymmetry = (A - A.transpose()).norm() / A.norm();
    if (equal)
      EXPECT_LT(asymmetry, 1e-14);
    else
      EXPECT_GT(asymmetry, 0.05);
  }
}

// A square sheet compressed in its plane: the printed matrix has negative pivots, and each step that
// meets one is counted.
TEST_F(Solvers, AStepWithANonPositivePivotIsCounted) {
  const Cloth cloth = make_cloth(mesh, model);
  state = {0.7 * mesh.x, VecX::Zero(mesh.x.size())};
  for (const char* name : {"ldlt", "inverse", "cholmod"}) {
    if (std::string(name) == "cholmod" && !has_cholmod(cloth)) continue;
    Method method;
    method.solver = name;
    EXPECT_EQ(step(cloth, method).counts.indefinite, 0) << name;
    method.jacobian = Jacobian::bw98;
    EXPECT_EQ(step(cloth, method).counts.indefinite, 1) << name;
  }
}

}  // namespace solvers_test
