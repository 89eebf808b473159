// From the k of a hinge to the bending modulus B of a plate: vertices on a cylinder of curvature κ, and
// B κ²/2 per area.
#include <gtest/gtest.h>

#include "scene/hinges.h"
#include "support/bend_models.h"
#include "support/energy.h"

namespace bend_modulus_test {

constexpr double pi = std::numbers::pi;
constexpr double cell = 1, small = 0.05;  // m, 1/m: a fold of 0.05 rad on each mesh line
constexpr int cells = 8;                  // even, so that an alternating grid repeats

// The grid rolled up on a cylinder, in the direction that makes the angle φ with u.
VecX rolled(const Mesh& mesh, double phi, double kappa) {
  VecX x = mesh.x;
  for (int i = 0; i < x.size(); i += 3) {
    const double u = mesh.x[i], v = -mesh.x[i + 2];
    const double along = u * std::cos(phi) + v * std::sin(phi);
    const double aside = v * std::cos(phi) - u * std::sin(phi);
    x.segment<3>(i) << std::sin(kappa * along) / kappa, aside, std::cos(kappa * along) / kappa;
  }
  return x;
}

// The middle of the edge of a hinge on the flat grid, in cells.
Vec2 middle(const Mesh& mesh, const std::array<int, 4>& vertices) {
  const Vec3 sum = mesh.x.segment<3>(3 * vertices[1]) + mesh.x.segment<3>(3 * vertices[2]);
  return Vec2(sum.x(), -sum.z()) / (2 * cell);
}

// The elements of a window of whole cells away from the boundary: each edge on its rim counted once.
template <class Element>
std::vector<Element> in_window(const Mesh& mesh, const std::vector<Element>& elements) {
  std::vector<Element> inside;
  for (const Element& e : elements) {
    const Vec2 m = middle(mesh, e.vertices);
    if (m.minCoeff() >= 2 && m.maxCoeff() < cells - 2) inside.push_back(e);
  }
  return inside;
}
constexpr double window = (cells - 4) * (cells - 4) * cell * cell;  // m²

Mesh grid(Diagonals diagonals) {
  return make_grid({cells * cell, cells * cell}, {cells, cells}, diagonals);
}

// B/k of a model.
double modulus(BendModel model, Diagonals diagonals, double phi) {
  const Mesh mesh = grid(diagonals);
  const VecX x = rolled(mesh, phi, small);
  double E;
  if (model == BendModel::quadratic) {
    QuadraticHinges hinges;
    hinges.elements = in_window(mesh, make_quadratic_hinges(mesh));
    hinges.term<QuadraticBend>() = QuadraticBend(1);
    E = energy(hinges, x);
  } else {
    Families families;
    families.hinges.elements = in_window(mesh, make_hinges(mesh));
    add_bend(families, model, 1);
    E = energy(families.hinges, x);
  }
  return E / window / (small * small / 2);
}

constexpr std::array models = {BendModel::dihedral, BendModel::bridson, BendModel::quadratic};

TEST(BendModulus, StiffnessOfAModulusGivesItAlongTheGrid) {
  for (const BendModel model : models)
    for (const Diagonals diagonals : {Diagonals::same, Diagonals::alternating})
      for (const double phi : {0.0, pi / 2})
        EXPECT_NEAR(*stiffness_of_modulus(model, 7) * modulus(model, diagonals, phi), 7, 0.01 * 7)
            << "model " << int(model) << ", φ = " << phi;
}

// Aslant. The diagonals of a grid with equal ones run at 135°: rolled up at 45° it folds on them, and
// is soft; rolled up at 135° no mesh line follows the fold. An alternating grid with the hinges of
// Baraff and Witkin is the same in all directions. In units of B along the grid.
TEST(BendModulus, DependsOnTheDirection) {
  struct Case {
    BendModel model;
    Diagonals diagonals;
    double at_45, at_135;
  };
  for (const Case& c : {Case{BendModel::dihedral, Diagonals::same, 0.5, 2.5},
                        Case{BendModel::bridson, Diagonals::same, 1, 3},
                        Case{BendModel::quadratic, Diagonals::same, 1, 3},
                        Case{BendModel::dihedral, Diagonals::alternating, 1, 1},
                        Case{BendModel::bridson, Diagonals::alternating, 1.5, 1.5},
                        Case{BendModel::quadratic, Diagonals::alternating, 1.5, 1.5}}) {
    const double k = *stiffness_of_modulus(c.model, 1);
    const double at_45 = k * modulus(c.model, c.diagonals, pi / 4);
    const double at_135 = k * modulus(c.model, c.diagonals, 3 * pi / 4);
    std::printf("model %d, %s diagonals: %.4f at 45 degrees, %.4f at 135\n", int(c.model),
                c.diagonals == Diagonals::same ? "same" : "alternating", at_45, at_135);
    EXPECT_NEAR(at_45, c.at_45, 0.01 * c.at_45) << "model " << int(c.model);
    EXPECT_NEAR(at_135, c.at_135, 0.01 * c.at_135) << "model " << int(c.model);
  }
}

// Springs between opposite vertices: twice the curvature is sixteen times the energy.
TEST(BendModulus, SpringsHaveNone) {
  EXPECT_FALSE(stiffness_of_modulus(BendModel::springs, 1));
  const Mesh mesh = grid(Diagonals::same);
  BendSprings springs;
  springs.elements = make_bend_springs(mesh);
  springs.term<SpringBend>() = SpringBend(1);
  const double E = energy(springs, rolled(mesh, 0, small));
  EXPECT_GT(E, 0);
  EXPECT_NEAR(energy(springs, rolled(mesh, 0, 2 * small)) / E, 16, 0.1);
}

}  // namespace bend_modulus_test
