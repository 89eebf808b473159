// The scenes of common/fabrics, and the experiments of common/README.md that find such numbers for a cloth.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <numbers>
#include <string>

#include "math/triangle.h"
#include "scene/scene.h"
#include "support/elastica.h"
#include "text/text_file.h"

namespace fabric_test {

// Five of the cloths of Wang, O'Brien and Ramamoorthi (2011), from the file materials/NAME.json of ARCSim. Of
// its "stretching" the stiffnesses c11, c22 and c33 at zero strain, of its "bending" those at the smallest
// curvature along the warp and along the weft.
struct Fabric {
  const char* scene;
  double density, c11, c22, c33, warp, weft;  // kg/m²; N/m; N·m
};
constexpr std::array fabrics = {
    Fabric{"t_shirt", 0.187, 16.593832, 34.477123, 36.860302, 23.191698e-6, 14.267624e-6},
    Fabric{"jacket", 0.113, 43.067627, 171.424835, 14.314700, 14.293814e-6, 20.345654e-6},
    Fabric{"jeans", 0.324, 205.352005, 1013.88629, 53.387184, 64.196457e-6, 96.951576e-6},
    Fabric{"blanket", 0.228, 151.503906, 244.830673, 30.250183, 117.070122e-6, 59.774277e-6},
    Fabric{"trousers", 0.22, 2016.55456, 2034.97644, 104.759674, 125.409805e-6, 125.409805e-6}};

const std::filesystem::path directory = std::filesystem::path(SOURCE_DIRECTORY) / "common";

std::filesystem::path file_of(const Fabric& fabric) {
  return directory / "fabrics" / (std::string(fabric.scene) + ".toml");
}

// ARCSim's stiffness along a thread is 2 c11 or 2 c22. Its energy per area of shear is c33/2 (w_u·w_v)². Its
// bending stiffness is the k of Bridson's model.
TEST(Fabrics, HaveTheMeasuredNumbersOfTheirCloth) {
  for (const Fabric& fabric : fabrics) {
    const Cloth cloth = read_scene(file_of(fabric), "step05_bend").cloth;
    const auto expect_measured = [&](double value, double measured) {
      EXPECT_NEAR(value / measured, 1, 0.003) << fabric.scene;
    };
    expect_measured(cloth.mass.sum() / 3 / (0.4 * 0.4), fabric.density);
    expect_measured(cloth.term<StretchTerm>()->k, (2 * fabric.c11 + 2 * fabric.c22) / 2);
    expect_measured(cloth.term<ShearTerm>()->k, fabric.c33);
    const double B = cloth.term<DihedralBend>()->k / DihedralBend::k_of_modulus(1);
    expect_measured(BridsonBend::k_of_modulus(B), (fabric.warp + fabric.weft) / 2);
  }
}

// The table of common/README.md, with the bending length (B/(ρ g))^⅓ in cm.
TEST(Fabrics, HaveTheNumbersThatTheReadmeNames) {
  const std::string readme = read_text(directory / "README.md");
  for (const Fabric& fabric : fabrics) {
    const auto value = [&](const char* table, const char* key) {
      return std::stod(value_in_scene(file_of(fabric), table, key));
    };
    const double density = value("cloth", "density"), B = value("bend", "B");
    char row[200];
    std::snprintf(row, sizeof row, "(fabrics/%s.toml) | %g | %g | %g | %g | %.1f |", fabric.scene,
                  density, value("stretch", "k"), value("shear", "k"), 1e6 * B,
                  100 * std::cbrt(B / (density * value("gravity", "g"))));
    EXPECT_NE(readme.find(row), readme.npos) << "no row of the table has\n" << row;
  }
}

// A strip of the length L = 2 c has Γ = ρ g L³/B = 8. Peirce's own formula, c³ = L³ cos(θ/2)/(8 tan θ), is an
// estimate: it gives a B that is 6 % larger.
TEST(DroopingStrip, AtFortyOneAndAHalfDegreesIsTwiceItsBendingLength) {
  const double slope = std::atan(elastica(8).droop());
  EXPECT_NEAR(slope * 180 / std::numbers::pi, 41.5, 0.02);
  EXPECT_NEAR(std::cos(slope / 2) / std::tan(slope), 1.06, 0.005);
}

// Energy per area of threads with these stiffnesses, stretched by e along their bias, and by t across it.
double energy_on_the_bias(double k, double shear, double e, double t) {
  const double along = 1 + (e + t) / 2, aside = (e - t) / 2;
  const Vecs<2> w = {Vec3(along, aside, 0), Vec3(aside, along, 0)};
  const Triangle half = make_triangle({0, 1, 2}, {0, 0}, {1, 0}, {0, 1});
  const auto energy = [](double stiffness, double C) { return stiffness / 2 * C * C; };
  return (energy(k, Stretch(half, w, 0).C) + energy(k, Stretch(half, w, 1).C) +
          energy(shear, Shear(half, w).C)) /
         half.area;
}

// The sides are free: t is where the energy, a parabola of t for small strains, is least.
TEST(StripOnTheBias, IsAsStiffAsStretchAndShearInARow) {
  constexpr double k = 2450, shear = 74, e = 1e-4;
  const auto energy = [&](double t) { return energy_on_the_bias(k, shear, e, t); };
  const double middle = energy(0), right = energy(e), left = energy(-e);
  const double slope = (right - left) / 2, bend = right - 2 * middle + left;
  const double E = 2 * (middle - slope * slope / (2 * bend)) / (e * e);
  EXPECT_NEAR(E / (1 / (1 / (2 * k) + 1 / (4 * shear))), 1, 1e-3);
  EXPECT_NEAR(1 / (4 / E - 2 / k) / shear, 1, 1e-3) << "the formula of the README";
}

}  // namespace fabric_test
