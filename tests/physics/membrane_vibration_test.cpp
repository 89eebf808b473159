// The frequencies of cloths of every model, at rest and stretched.
#include <gtest/gtest.h>

#include "math/stable_step.h"
#include "physics/sheet_modes.h"
#include "ways/simulator.h"

namespace membrane_vibration_test {

using namespace sheet_modes;

// At rest c² = C11/ρ, the same for every model with the same moduli: C11 = λ + 2μ where the width does not
// change.
TEST(LengthwiseVibration, OfEveryModelAtRestHasTheSameFrequencies) {
  constexpr double E = 100;
  for (const Sheet& sheet : all_sheets(E)) {
    const double c = std::sqrt(sheet.tangent(1, 1) / density);
    std::printf("%-28s", sheet.name.c_str());
    for (const int rows : {8, 16, 32}) {
      const VecX omega = frequencies(stretched_strip(sheet, rows, 1), rows, 2);
      std::printf("  %9.6f", omega[0] / (2 * pi));
      for (const int n : {1, 2, 3, rows})
        EXPECT_NEAR(omega[n - 1] / chain(c, rows, 2 * n - 1), 1, 1e-8)
            << sheet.name << ", mode " << n << " of " << rows;
    }
    std::printf("  ->  %9.6f Hz\n", c / (4 * L));
  }
}

// Held at the stretch s at both ends, with P the law of the model:
//
//   along    c² = ∂P/∂s / ρ       across   c² = P/(s ρ), the tension by the mass
TEST(Vibration, OfAStretchedStripHasTheFrequenciesOfItsTangentAndOfItsTension) {
  constexpr double E = 100, s = 1.05;
  constexpr int rows = 16;
  for (const Sheet& sheet : all_sheets(E)) {
    const bool linear = sheet.name.starts_with("linear");  // it has no force across its plane
    const double along = std::sqrt(sheet.tangent(s, 1) / density);
    const double across = linear ? 0 : std::sqrt(sheet.P(s, 1) / (s * density));
    const TestScene scene = stretched_strip(sheet, rows, s);
    const VecX a = frequencies(scene, rows - 1, 2), b = frequencies(scene, rows - 1, 1);
    std::printf("%-28s along %9.6f -> %9.6f Hz   across %8.6f -> %8.6f Hz\n", sheet.name.c_str(),
                a[0] / (2 * pi), along / (2 * L), b[0] / (2 * pi), across / (2 * L));
    for (const int n : {1, 2, rows - 1}) {
      EXPECT_NEAR(a[n - 1], chain(along, rows, 2 * n), 1e-8 * a[n - 1]) << sheet.name;
      EXPECT_NEAR(b[n - 1], chain(across, rows, 2 * n), 1e-8 * a[n - 1]) << sheet.name;
    }
  }
}

TEST(Vibration, HasTheKnownFrequencies) {
  struct Case {
    const char* name;
    double across, along;  // Hz
  };
  for (const Case& c : {Case{"threads", 2.439750, 11.180340}, Case{"stvk", 2.531057, 12.009111},
                        Case{"neo-hookean-barrier", 2.410531, 10.917387}}) {
    const Sheet sheet = membrane_sheet(c.name, moduli_of(100, 0));
    EXPECT_NEAR(std::sqrt(sheet.P(1.05, 1) / (1.05 * density)) / (2 * L), c.across, 6e-7) << c.name;
    EXPECT_NEAR(std::sqrt(sheet.tangent(1.05, 1) / density) / (2 * L), c.along, 6e-7) << c.name;
  }
  for (const Sheet& sheet : membrane_sheets(100, 0))
    EXPECT_NEAR(std::sqrt(sheet.tangent(1, 1) / density) / (4 * L), 5.590170, 5e-7) << sheet.name;
}

// A square metre of 12 × 12 cells that hangs by two corners, stretched evenly by s.
TestScene hanging_sheet(const Sheet& sheet, double s) {
  TestScene scene = scene_of(make_grid({1, 1}, {12, 12}, Diagonals::same), sheet.model,
                             Gravity::off, {12 * 13, 12 * 13 + 12});
  scene.start.x *= s;
  return scene;
}

double critical_step_of(const TestScene& scene) {
  Cloth cloth = scene.cloth;
  return critical_step(*make_simulator({1}, cloth), cloth, scene.start);
}

// All models with the same moduli have the same second derivatives at rest, so the same frequencies, and the
// same longest step of symplectic Euler, 2/ω_max. Threads have μ as the stiffness of their shear.
// critical_step ends its iteration a few millionths above 2/ω_max, with every model at the same place.
TEST(AtRest, AllMembranesWithTheSameModuliAreOne) {
  struct Case {
    double nu, h;  // –, s
  };
  for (const Case& c : {Case{0, 8.1854104e-4}, Case{0.3, 7.7996785e-4}}) {
    std::vector<Sheet> sheets = membrane_sheets(1e3, c.nu);
    if (c.nu == 0) sheets.push_back(membrane_sheet("threads", moduli_of(1e3, 0)));
    const TestScene first = hanging_sheet(sheets[0], 1);
    const MatX K = stiffness(first);
    const double h = 2 / modes(first.cloth, K).omega.maxCoeff(), found = critical_step_of(first);
    std::printf("nu = %.1f: 2/omega_max = %.7e s, by critical_step %.5e s\n", c.nu, h, found);
    EXPECT_NEAR(h / c.h, 1, 1e-8);
    EXPECT_NEAR(found / h, 1, 1e-5);
    for (const Sheet& sheet : sheets) {
      const TestScene scene = hanging_sheet(sheet, 1);
      const double apart = (stiffness(scene) - K).norm() / K.norm();
      const double other = critical_step_of(scene) / found - 1;
      std::printf("  %-20s K apart by %.0e, critical_step by %.0e\n", sheet.name.c_str(), apart,
                  std::abs(other));
      EXPECT_LT(apart, 1e-13) << sheet.name;
      EXPECT_NEAR(other, 0, 1e-9) << sheet.name;
    }
  }
}

// Stretched or squeezed, every model has its own. The numbers are 2/ω_max by a dense eigenvalue solver. Stvk
// is softer where it is squeezed, the barrier stiffer.
TEST(CriticalStep, OfStretchedAndSqueezedMembranesIsTheKnownOne) {
  struct Case {
    const char* name;
    double stretched, squeezed;  // s, at 1.05 and at 0.8
  };
  for (const Case& c :
       {Case{"stvk", 7.214244e-4, 1.222367e-3}, Case{"linear", 7.799679e-4, 7.799679e-4},
        Case{"corotated", 7.799235e-4, 7.801712e-4}, Case{"neo-hookean", 7.542574e-4, 8.909646e-4},
        Case{"neo-hookean-barrier", 8.162431e-4, 6.216721e-4}}) {
    const Sheet sheet = membrane_sheet(c.name, moduli_of(1e3, 0.3));
    const double stretched = critical_step_of(hanging_sheet(sheet, 1.05));
    const double squeezed = critical_step_of(hanging_sheet(sheet, 0.8));
    std::printf("%-20s stretched %.5e, squeezed %.5e s\n", c.name, stretched, squeezed);
    EXPECT_NEAR(stretched / c.stretched, 1, 2e-5) << c.name;
    EXPECT_NEAR(squeezed / c.squeezed, 1, 2e-5) << c.name;
  }
}

}  // namespace membrane_vibration_test
