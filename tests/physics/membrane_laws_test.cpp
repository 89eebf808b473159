// The stress and the energy of every model, on one square metre that deforms evenly.
#include <gtest/gtest.h>

#include "math/energy.h"
#include "sheets.h"

namespace membrane_laws_test {

// A square of 1 m of one cell.
struct Square1m {
  explicit Square1m(const Sheet& sheet)
      : scene(scene_of(make_grid({1, 1}, {1, 1}, Diagonals::same), sheet.model, Gravity::off)) {}

  // Its vertices, where (u, v) lies at u w_u + v w_v.
  VecX pose(const Vec3& wu, const Vec3& wv) const {
    return field(scene.mesh, [&](double u, double v) -> Vec3 { return u * wu + v * wv; });
  }
  // J, stretched by s along u and by t along v.
  double energy(double s, double t) const {
    return potential_energy(scene.cloth, pose(s * Vec3::UnitX(), -t * Vec3::UnitZ()));
  }
  // The force that holds the side u = 1 then, and the side v = 1, N/m.
  std::array<double, 2> forces(double s, double t) const {
    VecX f = VecX::Zero(12);
    const VecX x = pose(s * Vec3::UnitX(), -t * Vec3::UnitZ());
    for_each_family(scene.cloth, [&](const auto& family) { add_elastic_forces(family, x, f); });
    return {-(f[3 * 1] + f[3 * 3]), f[3 * 2 + 2] + f[3 * 3 + 2]};
  }

  TestScene scene;
};

TEST(StressLaw, OfEveryModelIsThatOfItsForces) {
  for (const Sheet& sheet : all_sheets(1000)) {
    const Square1m square(sheet);
    for (const double s : {0.4, 0.9, 1.0, 1.05, 1.7})
      for (const double t : {0.5, 1.0, 1.3}) {
        const auto [along_u, along_v] = square.forces(s, t);
        EXPECT_NEAR(along_u, sheet.P(s, t), 1e-9) << sheet.name << ", s = " << s << ", t = " << t;
        EXPECT_NEAR(along_v, sheet.P(t, s), 1e-9) << sheet.name << ", s = " << s << ", t = " << t;
      }
  }
}

// What textbooks write of a sheet that is pulled along one side, while no force acts across:
//
//   corotated, linear     t = 1 − ν (s − 1)            P = E (s − 1)
//   stvk                  t² = 1 − ν (s² − 1)          P = E s (s² − 1)/2
//   neo-hookean           t = (κ + μ) s/(μ + κ s²)     P = μ (s − t²/s)
//   neo-hookean-barrier   μ (t² − 1) + λ ln(s t) = 0   P = μ (s − t²/s)
struct Pulled {
  double t, P;
};

Pulled pulled(const std::string& name, double E, double nu, double s) {
  const Moduli m = moduli_of(E, nu);
  const auto neo_hookean = [&](double t) { return Pulled{t, m.mu * (s - t * t / s)}; };
  if (name == "stvk") return {std::sqrt(1 - nu * (s * s - 1)), E * s * (s * s - 1) / 2};
  if (name == "neo-hookean")
    return neo_hookean((m.kappa() + m.mu) * s / (m.mu + m.kappa() * s * s));
  if (name == "neo-hookean-barrier") {
    const auto side = [&](double t) { return m.mu * (t * t - 1) + m.lambda * std::log(s * t); };
    return neo_hookean(zero_of(side, 0.5, 1.5));
  }
  return {1 - nu * (s - 1), E * (s - 1)};
}

TEST(StressLaw, OfAPulledSheetIsTheUsualOne) {
  constexpr double E = 1000;
  for (const double nu : {0.0, 0.3, -0.2})
    for (const Sheet& sheet : membrane_sheets(E, nu)) {
      std::printf("%-20s nu = %4.1f:", sheet.name.c_str(), nu);
      for (const double s : {0.6, 0.95, 1.05, 1.5}) {
        const auto [t, P] = pulled(sheet.name, E, nu, s);
        const auto [pull, side] = Square1m(sheet).forces(s, t);
        std::printf("  P(%.2f) = %9.4f", s, pull);
        EXPECT_NEAR(pull, P, 1e-9) << sheet.name << ", nu = " << nu << ", s = " << s;
        EXPECT_NEAR(side, 0, 1e-9) << sheet.name << ", nu = " << nu << ", s = " << s;
        EXPECT_NEAR(sheet.pull(s), P, 1e-9) << sheet.name << ", nu = " << nu << ", s = " << s;
      }
      std::printf("\n");
    }
}

// P = E s (s² − 1)/2 has its least value at s = 1/√3. Pressed further, the sheet gives way: the stiffness is
// negative. Poisson's ratio does not matter.
TEST(Stvk, WeakensUnderMoreThanADefinitePressure) {
  for (const double nu : {0.0, 0.3}) {
    const Sheet sheet = membrane_sheet("stvk", moduli_of(1, nu));
    const Square1m square(sheet);
    const auto pressure = [&](double s) { return -square.forces(s, sheet.across(s))[0]; };
    const double s = 1 / std::sqrt(3), most = std::sqrt(3) / 9;
    std::printf("nu = %.1f: the pressure %.8f E at s = %.8f\n", nu, pressure(s), s);
    EXPECT_NEAR(pressure(s), most, 1e-12);
    EXPECT_NEAR(pressure(s), 0.19245009, 5e-9);
    // A parabola about its top: P'' = 3 E s
    for (const double d : {1e-3, -1e-3})
      EXPECT_NEAR((most - pressure(s + d)) / (d * d), 1.5 * s, 1e-3);
  }
}

// Pressed to a point, a cloth of most models holds a finite energy:
//
//   threads k   stvk, neo-hookean κ/2   linear, corotated 2κ    J/m²
//
// Corotated to four digits, as J is at least ε, and so its s at least √(2ε), 4.5e-5.
TEST(Energy, OfAClothThatIsPressedToAPointIsFinite) {
  for (const double nu : {0.0, 0.3}) {
    const double kappa = moduli_of(1000, nu).kappa();
    EXPECT_NEAR(kappa, nu > 0 ? 714.285714 : 500, 5e-7);
    for (const Sheet& sheet : membrane_sheets(1000, nu)) {
      if (sheet.name == "neo-hookean-barrier") continue;
      const double E = Square1m(sheet).energy(0, 0);
      std::printf("%-12s nu = %.1f: %.4f J/m²\n", sheet.name.c_str(), nu, E);
      const bool half = sheet.name == "stvk" || sheet.name == "neo-hookean";
      EXPECT_NEAR(E / (half ? kappa / 2 : 2 * kappa), 1, 5e-5) << sheet.name << ", nu = " << nu;
    }
  }
  EXPECT_NEAR(Square1m(membrane_sheet("threads", moduli_of(1000, 0))).energy(0, 0), 1000, 1e-5);
}

//   ψ(r, r) = μ (r² − 1 − 2 ln r) + 2 λ ln² r
TEST(Energy, OfTheBarrierGrowsWithoutBound) {
  for (const double nu : {0.0, 0.3}) {
    const Moduli m = moduli_of(1000, nu);
    const Square1m square(membrane_sheet("neo-hookean-barrier", m));
    double before = 0;
    for (const double r : {1e-1, 1e-2, 1e-3, 1e-4}) {
      const double E = square.energy(r, r), q = std::log(r);
      std::printf("nu = %.1f, 1 m pressed to %g m: %.4f J\n", nu, r, E);
      EXPECT_NEAR(E / (m.mu * (r * r - 1 - 2 * q) + 2 * m.lambda * q * q), 1, 3e-3);
      EXPECT_GT(E - before, 0.99 * m.mu * (2 * std::log(10) - 1));
      before = E;
    }
  }
}

// It takes a turn for a strain. Turned by θ, it holds
//
//   2κ (1 − cos θ)²          about its normal
//   (μ + λ/2) (1 − cos θ)²   about an axis in its plane
TEST(Linear, HoldsEnergyWhenItIsTurned) {
  const Moduli m = moduli_of(1000, 0.3);
  const Square1m square(membrane_sheet("linear", m));
  const auto turned = [&](double angle, const Vec3& axis) {
    const Mat3 R = Eigen::AngleAxisd(angle, axis).toRotationMatrix();
    return potential_energy(square.scene.cloth, square.pose(R.col(0), -R.col(2)));
  };
  for (const double degrees : {10, 45, 90, 180}) {
    const double angle = degrees * pi / 180, lost = 1 - std::cos(angle);
    std::printf("turned by %3.0f degrees: %.4f J/m²\n", degrees, turned(angle, Vec3::UnitY()));
    EXPECT_NEAR(turned(angle, Vec3::UnitY()), 2 * m.kappa() * lost * lost, 1e-9);
    EXPECT_NEAR(turned(angle, Vec3::UnitX()), (m.mu + m.lambda / 2) * lost * lost, 1e-9);
    EXPECT_NEAR(turned(angle, Vec3::UnitZ()), (m.mu + m.lambda / 2) * lost * lost, 1e-9);
  }
}

TEST(Rotation, CostsNoOtherModelEnergy) {
  const Mat3 R = Eigen::AngleAxisd(2, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  for (const Sheet& sheet : all_sheets(1000)) {
    if (sheet.name.starts_with("linear")) continue;
    const Square1m square(sheet);
    EXPECT_NEAR(potential_energy(square.scene.cloth, square.pose(R.col(0), -R.col(2))), 0, 1e-24)
        << sheet.name;
  }
}

}  // namespace membrane_laws_test
