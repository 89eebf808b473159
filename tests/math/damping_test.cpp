// Step 2's damping, d = −kd Ċ ∂C/∂x: it resists changes of the conditions, and no other motion.
#include <gtest/gtest.h>

#include "step01_explicit/time_step.h"
#include "step02_damping/time_step.h"
#include "support/dense.h"
#include "support/differences.h"

namespace damping_test {

VecX forces02(const Cloth& cloth, const State& state) {
  step02::System system(cloth);
  step02::forces(cloth, state, system);
  return system.f;
}

VecX damping(const Cloth& cloth, const State& state) {
  return forces02(cloth, state) - forces02(cloth, {state.x, VecX::Zero(state.x.size())});
}

// A cloth with all kinds of elements in a random state.
struct Damping : testing::Test {
  Random random{71};
  Mesh mesh = small_grid();
  Cloth cloth = rich_cloth(mesh);
  State state = disturbed(mesh, 0.3, random);

  VecX rigid(const Vec3& drift, const Vec3& spin) const {
    VecX v(state.x.size());
    for (int i = 0; i < cloth.vertices(); ++i)
      v.segment<3>(3 * i) = drift + spin.cross(Vec3(state.x.segment<3>(3 * i)));
    return v;
  }
};

// A rigid motion, added to any other motion, changes nothing.
TEST_F(Damping, DoesNotSeeTheRigidPartOfAMotion) {
  const VecX before = damping(cloth, state);
  state.v += rigid(random.vector(3, 2), random.vector(3, 2));
  EXPECT_LT(relative(damping(cloth, state), before), 1e-13);
}

// Stretch has two conditions, and each is damped by its own rate.
TEST_F(Damping, IsTheSumOverTheConditionsOneByOne) {
  VecX expected = VecX::Zero(state.x.size());
  for (const DenseCondition& c : dense_conditions(cloth, state.x))
    expected -= c.term.kd * c.g.dot(state.v) * c.g;
  EXPECT_LT(relative(damping(cloth, state), expected), 1e-13);
}

// Without kd the forces of step 2 are those of step 1 to the last bit, at every velocity.
TEST_F(Damping, IsAbsentWithoutItsTable) {
  for_each_term(cloth, [](auto& term) {
    if (term) term->kd = 0;
  });
  EXPECT_FALSE(damped(cloth));
  step01::System undamped(cloth);
  step01::forces(cloth, state, undamped);
  EXPECT_EQ(forces02(cloth, state), undamped.f);
}

// The coefficient of a table acts on the term of that table only.
TEST_F(Damping, OfEachTermIsItsOwn) {
  VecX sum = VecX::Zero(state.x.size());
  for (int keep = 0; keep < 3; ++keep) {
    Cloth one = cloth;
    int i = 0;
    for_each_term(one, [&](auto& term) {
      if (term && i++ != keep) term->kd = 0;
    });
    EXPECT_GT(damping(one, state).norm(), 0);
    sum += damping(one, state);
  }
  EXPECT_LT(relative(sum, damping(cloth, state)), 1e-12);
}

}  // namespace damping_test
