// The ways to make the matrix of an element definite keep what they promise, and the steps that take them
// are the steps.
#include "extremes/definite_ways.h"

#include <gtest/gtest.h>

#include "scene/hinges.h"
#include "support/both_halves.h"
#include "support/decompositions.h"
#include "support/extreme_scenes.h"
#include "ways/simulator.h"

namespace extremes::definite_ways_test {

// −K of a triangle on its vectors w.
MatX matrix(Filter which, const Triangles& family, const Triangle& t, const Vecs<2>& w) {
  filter = which;
  FilteredTension<2> kept;
  BothHalves<2> K;
  family.conditions(t, w, [&](const Term& term, const auto& c) {
    kept.add(term.k * c.C, c);
    for (int m = 0; m < c.M; ++m)
      for (int n = m; n < c.M; ++n)
        K.add(c.first + m, c.first + n, -term.k * c.dCdy[m] * c.dCdy[n].transpose());
  });
  kept.subtract_from(K, t, w);
  return -from_blocks<2>(K.blocks);
}

// Threads with shear, or a membrane.
std::vector<Triangles> materials() {
  std::vector<Triangles> all(2);
  all[0].term<StretchTerm>() = StretchTerm(100);
  all[0].term<ShearTerm>() = ShearTerm(50);
  all[1].term<Membrane<NeoHookean>>() = Membrane<NeoHookean>(100);
  return all;
}

// Calls look(family, triangle, w) for 100 triangles of each material: compressed, stretched and sheared.
template <class Look>
void for_each_triangle(const Look& look) {
  Random random(1);
  for (const Triangles& family : materials())
    for (int i = 0; i < 100; ++i) {
      const Triangle t = make_triangle(random_rest(random));
      const double stretch = random.between(0.5, 1.5);
      const Mat3 turn = random.rotation();
      const Vecs<2> w = {turn * (stretch * Vec3::UnitX() + random.vector(3, 0.2)),
                         turn * (stretch * Vec3::UnitY() + random.vector(3, 0.2))};
      look(family, t, w);
    }
}

double lowest(const MatX& A) {
  return eigenvalues(A)[0];
}
MatX positive(const MatX& A) {
  const auto [values, vectors] = eigenpairs(A);
  return vectors * values.cwiseMax(0.0).asDiagonal() * vectors.transpose();
}

TEST(Filters, LeaveNoNegativeEigenvalueButThePrintedMatrixHasSome) {
  int indefinite = 0;
  for_each_triangle([&](const Triangles& family, const Triangle& t, const Vecs<2>& w) {
    const MatX full = matrix(Filter::full, family, t, w);
    const double rounding = 1e-12 * full.norm();
    indefinite += lowest(full) < -rounding;
    for (const Filter which :
         {Filter::tension, Filter::clamp, Filter::absolute, Filter::sum, Filter::kim})
      EXPECT_GE(lowest(matrix(which, family, t, w)), -rounding) << "filter " << int(which);
  });
  EXPECT_GT(indefinite, 50);
  EXPECT_LT(indefinite, 150);
}

TEST(Filters, OfTheWholeMatrixChangeNothingWhereItIsDefinite) {
  int definite = 0;
  for_each_triangle([&](const Triangles& family, const Triangle& t, const Vecs<2>& w) {
    const MatX full = matrix(Filter::full, family, t, w);
    if (lowest(full) < -1e-12 * full.norm()) return;
    ++definite;
    for (const Filter which : {Filter::clamp, Filter::absolute})
      EXPECT_LT((matrix(which, family, t, w) - full).norm(), 1e-10 * full.norm());
  });
  EXPECT_GT(definite, 50);
}

// The same matrices from their definitions.
TEST(Filters, OfSecondDerivativesTakeTheSumOverTheElement) {
  for_each_triangle([&](const Triangles& family, const Triangle& t, const Vecs<2>& w) {
    MatX G = MatX::Zero(6, 6), alone = G;
    family.conditions(t, w, [&](const Term& term, const auto& c) {
      MatX kggT = MatX::Zero(6, 6), kCd2C = kggT;
      const auto second = c.second();
      for (int m = 0; m < c.M; ++m)
        for (int n = 0; n < c.M; ++n) {
          const int row = 3 * (c.first + m), column = 3 * (c.first + n);
          kggT.block<3, 3>(row, column) = term.k * c.dCdy[m] * c.dCdy[n].transpose();
          kCd2C.block<3, 3>(row, column) = term.k * c.C * second[m][n];
        }
      G += kggT;
      alone += positive(kggT + kCd2C);
    });
    const MatX S = matrix(Filter::full, family, t, w) - G;
    const double rounding = 1e-10 * G.norm();
    EXPECT_LT((matrix(Filter::sum, family, t, w) - G - positive(S)).norm(), rounding);
    EXPECT_LT((matrix(Filter::clamp, family, t, w) - positive(G + S)).norm(), rounding);
    EXPECT_LT((matrix(Filter::kim, family, t, w) - alone).norm(), rounding);
  });
}

struct Motion {
  VecX x;
  WayCounts counts;
};

Motion run(Way way, int step, TestScene scene, double h, int steps, int newton = 1) {
  const auto simulator = make_way(way, step, scene.cloth, newton);
  for (int i = 0; i < steps; ++i) simulator->step(h, scene.start);
  return {scene.start.x, simulator->counts()};
}

VecX run_step(int step, TestScene scene, const Method& method, double h, int steps) {
  const auto simulator = make_simulator({step, method}, scene.cloth);
  for (int i = 0; i < steps; ++i) simulator->step(h, scene.start);
  return scene.start.x;
}

TestScene with_hinges(TestScene scene) {
  scene.cloth.hinges.elements = make_hinges(scene.mesh);
  scene.cloth.term<DihedralBend>() = DihedralBend(0.01);
  return scene;
}

// Not to the last bit: step 5 is compiled without flatten here.
TEST(Ways, TensionAndFullAreTheSteps) {
  for (const int step : {3, 5}) {
    const TestScene scene = step == 5 ? with_hinges(dropped(1e3)) : dropped(1e3);
    EXPECT_LT(
        (run(Way::tension, step, scene, 0.01, 20).x - run_step(step, scene, {}, 0.01, 20)).norm(),
        1e-9);
    EXPECT_LT((run(Way::full, step, scene, 0.01, 20).x -
               run_step(step, scene, {Jacobian::bw98}, 0.01, 20))
                  .norm(),
              1e-9);
  }
}

// A curtain is taut: every printed matrix is definite, and each way that changes nothing then agrees.
TEST(Ways, OnDemandIsThePrintedMatrixWhereItIsDefinite) {
  for (const int newton : {1, 50}) {
    const Motion on_demand = run(Way::on_demand, 3, curtain(), 0.01, 20, newton),
                 full = run(Way::full, 3, curtain(), 0.01, 20, newton);
    EXPECT_LT((on_demand.x - full.x).norm(), 1e-9);
    EXPECT_EQ(on_demand.counts.systems, full.counts.systems);
    EXPECT_EQ(on_demand.counts.indefinite, 0);
  }
}

// In ten long steps no printed matrix of a tangle is definite, and every system is solved twice.
TEST(Ways, OnDemandIsTensionWhereThePrintedMatrixIsIndefinite) {
  for (const int step : {3, 5}) {
    const Motion on_demand = run(Way::on_demand, step, tangled(1e3), 0.1, 10),
                 tension = run(Way::tension, step, tangled(1e3), 0.1, 10);
    EXPECT_EQ(on_demand.x, tension.x) << "step " << step;
    EXPECT_EQ(on_demand.counts.systems, 2 * tension.counts.systems) << "step " << step;
    EXPECT_EQ(on_demand.counts.indefinite, tension.counts.systems) << "step " << step;
  }
  const Motion newton = run(Way::on_demand, 3, tangled(1e3), 0.1, 1, 50);
  EXPECT_GT(newton.counts.indefinite, 0);
  EXPECT_EQ(newton.counts.systems, newton.counts.iterations + newton.counts.indefinite);
}

// Halving is what remains of the line search after its first attempt.
TEST(Ways, CountTheHalvingsOfTheLineSearch) {
  const Motion easy = run(Way::tension, 3, curtain(), 0.01, 5, 50),
               hard = run(Way::tension, 3, tangled(1e3), 0.1, 1, 50);
  EXPECT_EQ(easy.counts.halvings, 0);
  EXPECT_GT(hard.counts.halvings, 0);
}

}  // namespace extremes::definite_ways_test
