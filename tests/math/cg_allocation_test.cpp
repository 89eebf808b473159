// A step of conjugate gradients allocates nothing after the first, whatever the preconditioner.
#include "support/count_allocations.h"  // before Eigen

// Compiled here, not linked, because Eigen's check is compiled into the code that it watches.
#include "math/incomplete_cholesky.cpp"
#include "math/multigrid.cpp"
#include "math/parents.cpp"
#include "math/pin.cpp"
#include "math/pinned_blocks.cpp"
#include "math/preconditioner.cpp"
#include "scene/make_cloth.h"
#include "step04_cg/time_step.h"

namespace cg_allocation_test {

struct CgAllocation : testing::TestWithParam<const char*> {
  // Of 20 steps after the first, on a sheet of `cells` × `cells`.
  int allocations_in_steps(int cells) {
    const Mesh mesh = make_grid({1, 1}, {cells, cells}, Diagonals::alternating);
    Model model;
    model.add(StretchTerm(1000, 1));
    model.add(ShearTerm(500, 1));
    model.gravity = Vec3(0, -9.81, 0);
    model.pins = {0, Pin(4, Vec3::UnitX() * Vec3::UnitX().transpose())};
    const Cloth cloth = make_cloth(mesh, model);
    Method method;
    method.preconditioner = GetParam();
    step04::System system(cloth, method);
    State state{mesh.x, VecX::Zero(mesh.x.size())};
    const auto step = [&] { step04::time_step(cloth, 0.01, state, system); };
    step();
    const long before = system.counts.iterations;
    const int allocated = allocations_in([&] {
      for (int i = 0; i < 20; ++i) step();
    });
    EXPECT_GT(system.counts.iterations, before);
    EXPECT_EQ(system.counts.indefinite + system.counts.capped, 0);
    return allocated;
  }
};
INSTANTIATE_TEST_SUITE_P(Preconditioners, CgAllocation,
                         testing::Values("none", "jacobi", "block", "ic", "multigrid"),
                         [](const auto& test) { return std::string(test.param); });

TEST_P(CgAllocation, AStepAllocatesNothing) {
  EXPECT_EQ(allocations_in_steps(6), 0);
}

// The first step is a plain one. Nor does Newton's method then allocate, wherever the guard calls it.
TEST_P(CgAllocation, NorDoesANewtonStep) {
  const Mesh mesh = make_grid({1, 1}, {6, 6}, Diagonals::alternating);
  Model model;
  model.add(StretchTerm(1000, 1));
  model.gravity = Vec3(0, -9.81, 0);
  model.pins = {0, 6};
  for (const double kd : {0.0, 1.0}) {
    model.term<StretchTerm>()->kd = kd;
    const Cloth cloth = make_cloth(mesh, model);
    Method method;
    method.preconditioner = GetParam();
    step04::System system(cloth, method);
    State state{mesh.x, VecX::Zero(mesh.x.size())};
    step04::time_step(cloth, 0.1, state, system);
    EXPECT_EQ(allocations_in([&] {
                for (int i = 0; i < 5; ++i) step04::time_step(cloth, 0.1, state, system);
                system.method.newton = 5;
                for (int i = 0; i < 5; ++i) step04::time_step(cloth, 0.1, state, system);
              }),
              0)
        << "kd = " << kd;
    EXPECT_GT(system.counts.redone, 0);
  }
}

// Halved once to 13 × 13 cells, 588 coordinates.
TEST_P(CgAllocation, NorDoesOneWithALargeCoarsestGrid) {
  EXPECT_EQ(allocations_in_steps(26), 0);
}

// 256 vertices that cannot be halved.
TEST_P(CgAllocation, NorDoesOneWithAggregates) {
  EXPECT_EQ(allocations_in_steps(15), 0);
}

}  // namespace cg_allocation_test
