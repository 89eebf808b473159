// Our forces against automatic differentiation, which shares no formula with them.
#include <gtest/gtest.h>

#include "support/autodiff_energy.h"
#include "support/energy.h"
#include "support/poses.h"

namespace autodiff_test {

class AutoDiff : public testing::TestWithParam<Pose> {};
// Not the collapsed pose, where ε of Length is a part of the energy: every_model_test.cpp has that pose.
INSTANTIATE_TEST_SUITE_P(Triangle, AutoDiff,
                         testing::Values(Pose::random, Pose::compressed, Pose::sheared,
                                         Pose::inverted),
                         [](const auto& pose) { return std::string(name(pose.param)); });

TEST_P(AutoDiff, AutomaticDifferentiationOfTheEnergyGivesOurForces) {
  Random random(31);
  for (int i = 0; i < 100; ++i) {
    const Rest rest = random_rest(random);
    const VecX x = positions(rest, pose_w(GetParam(), random), random.vector(3, 0.1));
    const std::array<double, 2> b = {random.between(0.7, 1.3), random.between(0.7, 1.3)};
    Cloth cloth = one_triangle(make_triangle(rest), 7, 3);
    cloth.term<StretchTerm>()->b = b;
    const Nine E = energy_from_scratch(rest, {x.head<3>(), x.segment<3>(3), x.tail<3>()}, b, 7, 3);
    const VecX f = forces(cloth, x);
    EXPECT_NEAR(potential_energy(cloth, x), E.value(), 1e-12 * E.value()) << "triangle " << i;
    EXPECT_LT((f + E.derivatives()).norm(), 1e-12 * f.norm()) << "triangle " << i;
  }
}

}  // namespace autodiff_test
