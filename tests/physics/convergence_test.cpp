// Half the step, half the error: symplectic Euler is of order 1. The error is the distance to a Runge-Kutta
// run on the same mesh. That run is tested, too: it must show its own order, and a run with twice its step
// must differ from it by much less than the errors that are measured.
#include <gtest/gtest.h>

#include "step01_explicit/time_step.h"
#include "support/reference.h"
#include "support/scenes.h"

namespace convergence_test {

// The error of symplectic Euler with 400 steps, from an independent program with a Runge-Kutta method of
// order 8 as the reference.
struct Case {
  const char* name;
  TestScene (*scene)();
  double error_of_400_steps;  // m
};
void PrintTo(const Case& c, std::ostream* out) {
  *out << c.name;
}

constexpr long reference_steps = 6400;

class Convergence01 : public testing::TestWithParam<Case> {
 protected:
  const TestScene scene = GetParam().scene();
  step01::System system{scene.cloth};
  const Stepper fine = rk4(scene.cloth, step01::forces, system);
  const VecX exact = simulate(fine, scene.start, scene.end, reference_steps).x;
};
INSTANTIATE_TEST_SUITE_P(Scenes, Convergence01,
                         testing::Values(Case{"SwingingTriangle", swinging_triangle, 2.65e-3},
                                         Case{"RingingStrip", ringing_strip, 2.22e-4},
                                         Case{"Trampoline", trampoline, 5.3e-5},
                                         Case{"Curtain", curtain, 3.48e-4}),
                         [](const auto& scene) { return std::string(scene.param.name); });

TEST_P(Convergence01, IsOfOrderOne) {
  const Stepper step = stepper(scene.cloth, step01::time_step, system);
  const Convergence c = converge(scene.cloth, step, scene.start, scene.end, 400, 2, exact);
  EXPECT_NEAR(c.last_order(), 1, 0.1);
  EXPECT_NEAR(c.errors[0] / GetParam().error_of_400_steps, 1, 0.01);

  const VecX coarser = simulate(fine, scene.start, scene.end, reference_steps / 2).x;
  EXPECT_LT(rms_distance(scene.cloth, coarser, exact), 1e-3 * c.errors.back())
      << "the reference is not good enough to judge";
}

TEST_P(Convergence01, OfTheReferenceIsOfOrderFour) {
  const Convergence c = converge(scene.cloth, fine, scene.start, scene.end, 200, 2, exact);
  EXPECT_NEAR(c.last_order(), 4, 0.2);
}

}  // namespace convergence_test
