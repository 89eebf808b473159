// The assembly of K, D and A allocates nothing: pattern and slots were found before the first step.
// (The factorisation that follows is the library's own.)
#include "support/count_allocations.h"  // before Eigen

#include "scene/make_cloth.h"
#include "step03_implicit/time_step.h"

namespace matrix_allocation_test {

// A sheet with springs and damping, pulled out of shape.
struct MatrixAllocation : testing::Test {
  Mesh mesh = make_grid({1, 1}, {4, 4}, Diagonals::alternating);
  Cloth cloth;
  State state{mesh.x, VecX::Ones(mesh.x.size())};
  Method method;

  void SetUp() override {
    Model model;
    model.add(StretchTerm(100, 1));
    model.add(ShearTerm(50, 1));
    model.gravity = Vec3(0, -9.81, 0);
    model.pins = {20, 24};
    cloth = make_cloth(mesh, model);
    cloth.term<SpringTerm>() = SpringTerm(10, 1);
    cloth.springs.elements = {make_spring(0, 24, 1.5)};
    for (int i = 0; i < state.x.size(); ++i) state.x[i] *= 1 + 0.1 * (i % 3);
  }
};

TEST_F(MatrixAllocation, ForcesAndAssemblyOfStep03AllocateNothing) {
  for (const Jacobian jacobian : {Jacobian::definite, Jacobian::bw98}) {
    method.jacobian = jacobian;
    step03::System system(cloth, method);
    EXPECT_EQ(allocations_in([&] {
                for (int i = 0; i < 10; ++i) {
                  step03::forces(cloth, state, system);
                  system.K.multiply(state.v, system.b);
                  system.A.set_diagonal(cloth.mass);
                  system.A.add(-0.01, system.D);
                  system.A.add(-0.0001, system.K);
                }
              }),
              0);
    EXPECT_GT(system.A.diagonal[0](0, 0), cloth.mass[0]) << "nothing was assembled";
  }
}

TEST_F(MatrixAllocation, CounterSeesAMatrix) {
  const step03::System system(cloth);
  EXPECT_GE(allocations_in([&] { BlockMatrix copy = system.K; }), 2);
}

}  // namespace matrix_allocation_test
