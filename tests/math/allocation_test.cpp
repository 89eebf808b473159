// A time step allocates nothing.
#include "support/count_allocations.h"  // before Eigen

#include "step01_explicit/time_step.h"

namespace allocation_test {

// A square of two triangles and a spring, one vertex pinned.
Cloth small_cloth() {
  Cloth cloth;
  cloth.mass = VecX::Ones(12);
  cloth.inverse_mass = VecX::Ones(12);
  cloth.inverse_mass.head<3>().setZero();
  cloth.pins = {0};
  cloth.gravity = Vec3(0, -9.81, 0);
  cloth.triangles.elements = {make_triangle({0, 1, 2}, Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)),
                              make_triangle({3, 2, 1}, Vec2(1, 1), Vec2(0, 1), Vec2(1, 0))};
  cloth.term<StretchTerm>() = StretchTerm(10);
  cloth.term<ShearTerm>() = ShearTerm(5);
  cloth.springs.elements = {make_spring(0, 3, 1.5)};
  cloth.term<SpringTerm>() = SpringTerm(10);
  return cloth;
}

TEST(Allocation, TimeStepOfStep01AllocatesNothing) {
  const Cloth cloth = small_cloth();
  State state{VecX::Zero(12), VecX::Zero(12)};
  state.x << 0, 0, 0, 1, 0, 0, 0, 0, -1, 1.1, 0, -1.2;
  step01::System system(cloth);
  const double height = state.x[10];
  EXPECT_EQ(allocations_in([&] {
              for (int i = 0; i < 100; ++i) step01::time_step(cloth, 1e-3, state, system);
            }),
            0);
  EXPECT_LT(state.x[10], height) << "nothing was computed";
}

// The counter works: it sees both kinds of allocation.
TEST(Allocation, CounterSeesVectorsOfBothKinds) {
  const Cloth cloth = small_cloth();
  EXPECT_GE(allocations_in([&] { step01::System system(cloth); }), 1);
  std::vector<double> numbers;  // lives longer, or a compiler may remove the allocation
  EXPECT_GE(allocations_in([&] { numbers.resize(100); }), 1);
  EXPECT_EQ(numbers.size(), 100u);
}

}  // namespace allocation_test
