// VBD descends on Φ, vertex by vertex, down to the solution of backward Euler.
#include "ways/vbd.h"

#include <gtest/gtest.h>

#include "math/energy.h"
#include "support/extreme_scenes.h"
#include "support/momenta.h"
#include "ways/local_scenes.h"

namespace ways_test {

std::vector<std::string> models() {
  std::vector<std::string> names = membrane_names();
  names.push_back("threads");
  return names;
}

// Φ of the whole cloth, J.
double potential(const Cloth& cloth, const VecX& x, vbd::System& system) {
  double Phi = 0;
  for (int i = 0; i < cloth.vertices(); ++i)
    Phi += 0.5 * system.inertia(cloth, i) * system.away(x, i).squaredNorm();
  for_each_family(cloth, [&](const auto& family) {
    for (const auto& element : family.elements)
      system.conditions(family, element, x,
                        [&](const Term& term, const auto& c) { Phi += 0.5 * term.k * c.C * c.C; });
  });
  return Phi;
}

TEST(Vbd, DescendsWithEveryVertexEvenInATangle) {
  for (const double kd : {0.0, 0.1})
    for (const double k : {10.0, 1e4}) {
      TestScene scene = extremes::tangled(k);
      scene.cloth.term<StretchTerm>()->kd = kd;
      vbd::System system(scene.cloth, 1);
      system.begin(scene.cloth, 0.02, scene.start);
      VecX x = system.flight;
      double Phi = potential(scene.cloth, x, system);
      const double first = Phi;
      for (int sweep = 0; sweep < 3; ++sweep)
        for (int i = 0; i < scene.cloth.vertices(); ++i) {
          vbd::descend(scene.cloth, x, i, system);
          const double next = potential(scene.cloth, x, system);
          ASSERT_LE(next, Phi * (1 + 1e-13)) << "vertex " << i << " in sweep " << sweep;
          Phi = next;
        }
      EXPECT_LT(Phi, 0.2 * first) << k;
    }
}

// Of every model, with and without damping: VBD comes to the solution of Newton's method with D as at x0.
TEST(Vbd, ConvergesToTheSolutionOfNewtonsMethod) {
  for (const std::string& name : models())
    for (const double kd : {0.0, 0.05}) {
      Model m = with_membrane(name, {40, name == "arap" ? 0.0 : 20.0}, kd);
      m.add(DihedralBend(0.05, kd / 50));
      const TestScene scene = disturbed_sheet(m, Held::by_two_corners);
      const VecX exact = after(scene, newton, 0.02).x;
      const auto error = [&](int sweeps) {
        return (after(scene, vbd_of(sweeps), 0.02).x - exact).norm();
      };
      EXPECT_GT(error(1), 1e-2) << name;
      EXPECT_LT(error(10), 2e-3) << name;
      EXPECT_LT(error(100), 1e-8) << name;
    }
}

TEST(Vbd, SolvesBackwardEulerToRounding) {
  const TestScene scene = disturbed_sheet(threads(), Held::by_two_corners);
  EXPECT_LT(residual(scene, 0.02, after(scene, vbd_of(300), 0.02)), 1e-13);
}

// The error of its linear momentum is that of its solution.
TEST(Vbd, KeepsLinearMomentumAsFarAsItConverges) {
  const TestScene scene = thrown_sheet();
  const Momenta start = momenta(scene.cloth, scene.start);
  const auto lost = [&](int sweeps) {
    const Momenta end = momenta(scene.cloth, after(scene, vbd_of(sweeps), 0.01, 30));
    return (end.linear - start.linear).norm() / start.linear_scale;
  };
  EXPECT_GT(lost(1), 0.1);
  EXPECT_LT(lost(16), 1e-2);
  EXPECT_LT(lost(64), 1e-7);
}

}  // namespace ways_test
