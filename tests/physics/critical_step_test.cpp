// Symplectic Euler is stable for h < 2/ω_max. critical_step finds this limit by power iteration. Here it is
// compared with known values, with all frequencies of the cloth, and with runs.
#include "math/stable_step.h"

#include <gtest/gtest.h>

#include "step01_explicit/time_step.h"
#include "support/modes.h"
#include "support/reference.h"
#include "support/scenes.h"

namespace critical_step_test {

double critical_step_of(const TestScene& scene) {
  step01::System system(scene.cloth);
  return critical_step(scene.cloth, scene.start, step01::forces, system);
}

// A square metre that hangs by two corners, flat and at rest. ω_max comes from an independent program with a
// dense eigenvalue solver. For equal stretch and shear it is 3.534 √(k/ρ)/h, where h is the size of a
// cell. Without shear the light corner sets it: 3/√2 √(k/ρ)/h.
struct Known {
  int cells;
  double k, k_shear, omega_max;
};
constexpr std::array<Known, 5> known = {{{6, 1e3, 1e3, 1499.23},
                                         {12, 1e3, 1e3, 2998.40},
                                         {24, 1e3, 1e3, 5996.80},
                                         {12, 1e5, 1e5, 29984.0},
                                         {12, 1e3, 0, 1800.00}}};

TEST(CriticalStep, OfASheetIsTheKnownOne) {
  for (const Known& c : known) {
    const TestScene scene = sheet(c.cells, Held::by_two_corners, c.k, c.k_shear, Gravity::off);
    EXPECT_NEAR(critical_step_of(scene) * c.omega_max, 2, 2e-3)
        << c.cells << " cells, k = " << c.k << ", k_shear = " << c.k_shear;
  }
}

// The same for a cloth that is stretched, one that hangs by its own weight, and one without pins.
TEST(CriticalStep, IsTwoOverTheHighestOfAllFrequencies) {
  const std::array<TestScene, 4> scenes = {sheet(6, Held::by_two_corners, 1e3, 1e3, Gravity::off),
                                           sheet(6, Held::free, 1e3, 500, Gravity::on),
                                           trampoline(), curtain()};
  for (size_t i = 0; i < scenes.size(); ++i) {
    const TestScene& scene = scenes[i];
    step01::System system(scene.cloth);
    const MatX K = stiffness_matrix(scene.cloth, scene.start, step01::forces, system, 1e-6);
    const double omega_max = modes(scene.cloth, K).omega.maxCoeff();
    EXPECT_NEAR(critical_step_of(scene) * omega_max, 2, 4e-4) << "scene " << i;
  }
}

// A perturbation of a nanometre, so small that the cloth is linear. With h a thousandth below the limit it
// stays as small. With h a thousandth above, every step flips the highest mode and makes it larger.
TEST(CriticalStep, SeparatesWhatStaysFromWhatGrows) {
  const TestScene scene = sheet(6, Held::by_two_corners, 1e3, 1e3, Gravity::off);
  const double h = critical_step_of(scene);
  step01::System system(scene.cloth);
  const auto farthest = [&](double factor) {
    State state = scene.start;
    for (int i = 0; i < state.x.size(); i += 3)
      state.v[i] = scene.cloth.inverse_mass[i] > 0 ? 1e-6 * std::sin(i * (1 + i % 5)) : 0;
    double distance = 0;
    for (int n = 0; n < 2000 && distance < 1; ++n) {
      step01::time_step(scene.cloth, factor * h, state, system);
      distance = std::max(distance, (state.x - scene.start.x).cwiseAbs().maxCoeff());
    }
    return distance;
  };
  EXPECT_LT(farthest(0.999), 1e-6);
  EXPECT_GT(farthest(1.001), 1e-3);
}

}  // namespace critical_step_test
