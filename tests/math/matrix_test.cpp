// Step 3's matrices K = ∂f/∂x and D = ∂f/∂v, against differences of the forces, and against the same
// sums written out in full.
#include <gtest/gtest.h>

#include "step03_implicit/time_step.h"
#include "support/dense.h"
#include "support/differences.h"

namespace matrix_test {

Cloth without_damping(Cloth cloth) {
  for_each_term(cloth, [](auto& term) {
    if (term) term->kd = 0;
  });
  return cloth;
}

struct Matrix : testing::Test {
  Random random{81};
  Mesh mesh = small_grid();
  Cloth cloth = rich_cloth(mesh), elastic = without_damping(cloth);
  State state = disturbed(mesh, 0.15, random);
  VecX at_rest = VecX::Zero(state.x.size());

  // Σ over all conditions, each as a matrix or a vector.
  template <class Sum, class Part>
  Sum total(const VecX& x, Sum sum, const Part& part) const {
    for (const DenseCondition& c : dense_conditions(cloth, x)) sum += part(c);
    return sum;
  }
  MatX zero = MatX::Zero(state.x.size(), state.x.size());
};

TEST_F(Matrix, KOfBaraffAndWitkinIsTheSlopeOfTheElasticForce) {
  EXPECT_TRUE(is_slope(
      [&](const VecX& x) {
        return evaluate(elastic, {x, state.v}, Jacobian::bw98).f;
      },
      [&](const VecX& x) {
        return evaluate(elastic, {x, state.v}, Jacobian::bw98).K;
      },
      state.x, 0.3));
}

TEST_F(Matrix, KAtRestIsTheSameWithDamping) {
  const State still{state.x, at_rest};
  EXPECT_EQ(evaluate(cloth, still, Jacobian::bw98).K, evaluate(elastic, still, Jacobian::bw98).K);
}

// Damping is linear in v: one width of differences is enough.
TEST_F(Matrix, DIsTheSlopeOfTheDampingForce) {
  const MatX D = evaluate(cloth, state, Jacobian::definite).D;
  for (int j = 0; j < state.v.size(); ++j) {
    State faster = state;
    faster.v[j] += 1;
    const VecX column = evaluate(cloth, faster, Jacobian::definite).f -
                        evaluate(cloth, state, Jacobian::definite).f;
    EXPECT_LT((column - D.col(j)).norm(), 1e-13 * D.norm()) << "column " << j;
  }
}

// A flat sheet that is stretched and sheared: against every move across its plane the definite K is the
// slope of the force, and so all of K.
TEST_F(Matrix, DefiniteKIsTheSlopeAcrossASheetUnderTension) {
  VecX x = 1.6 * mesh.x + random.vector(int(mesh.x.size()), 0.05);
  for (int i = 0; i < mesh.vertices(); ++i) {
    x[3 * i] += 0.2 * x[3 * i + 2];  // a shear
    x[3 * i + 1] = 0;
  }
  const Evaluated definite = evaluate(elastic, {x, at_rest}, Jacobian::definite),
                  all = evaluate(elastic, {x, at_rest}, Jacobian::bw98);
  EXPECT_GT(relative(definite.K, all.K), 1e-3) << "in its plane a part is left out";
  for (int i = 0; i < mesh.vertices(); ++i) {
    const VecX Kp = definite.K.col(3 * i + 1), exact = all.K.col(3 * i + 1);
    EXPECT_LT(relative(Kp, exact), 1e-13) << "vertex " << i;
  }
}

// In general the definite K is not the slope of the forces. The forces themselves are the same.
TEST_F(Matrix, ForcesDoNotDependOnTheJacobian) {
  const Evaluated definite = evaluate(cloth, state, Jacobian::definite);
  const Evaluated bw98 = evaluate(cloth, state, Jacobian::bw98);
  EXPECT_EQ(definite.f, bw98.f);
  EXPECT_EQ(definite.D, bw98.D);
  EXPECT_GT(relative(definite.K, bw98.K), 0.01);
}

// d = −kd g (g·v) has two slopes: g turns (kept), and g·v changes (left out, for it is not symmetric).
TEST_F(Matrix, TheKeptPartIsTheSlopeOfTheDampingForceWithItsRatesHeld) {
  const auto held = [&](const VecX& x) {  // Σ −kd Ċ(x0) g(x)
    const auto start = dense_conditions(cloth, state.x), now = dense_conditions(cloth, x);
    VecX d = at_rest;
    for (size_t i = 0; i < now.size(); ++i)
      d -= now[i].term.kd * start[i].g.dot(state.v) * now[i].g;
    return d;
  };
  const MatX kept = evaluate(cloth, state, Jacobian::bw98).K -
                    evaluate(cloth, {state.x, at_rest}, Jacobian::bw98).K;
  EXPECT_GT(kept.norm(), 1);
  EXPECT_TRUE(is_slope(
      held, [&](const VecX&) { return kept; }, state.x, 0.3));
  EXPECT_LT((kept - kept.transpose()).norm(), 1e-13 * kept.norm());
}

TEST_F(Matrix, TheOmittedPartIsTheSlopeOfTheRatesAndNotSymmetric) {
  const auto held = [&](const VecX& x) {  // Σ −kd (g(x)·v) g(x0)
    const auto start = dense_conditions(cloth, state.x), now = dense_conditions(cloth, x);
    VecX d = at_rest;
    for (size_t i = 0; i < now.size(); ++i)
      d -= now[i].term.kd * now[i].g.dot(state.v) * start[i].g;
    return d;
  };
  const auto part = [&](const DenseCondition& c) -> MatX {
    return -c.term.kd * c.g * (c.H * state.v).transpose();
  };
  const MatX omitted = total(state.x, zero, part);
  EXPECT_TRUE(is_slope(
      held, [&](const VecX&) { return omitted; }, state.x, 0.3));
  EXPECT_GT((omitted - omitted.transpose()).norm(), 0.1 * omitted.norm());

  // Kept and omitted together are the whole slope of f.
  const auto f = [&](const VecX& x) { return evaluate(cloth, {x, state.v}, Jacobian::bw98).f; };
  const auto slope = [&](const VecX& x) -> MatX {
    return evaluate(cloth, {x, state.v}, Jacobian::bw98).K + total(x, zero, part);
  };
  EXPECT_TRUE(is_slope(f, slope, state.x, 0.3));
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + long(values.size() / 2), values.end());
  return values[values.size() / 2];
}

// omitted / kept of a single thread is exactly |ẇ⊥|/(√2 |ẇ∥|), ẇ split along w. For a ẇ that points
// anywhere it has the median √1.5 = 1.22 and lies above 1 in 1/√3 = 58 % of all states: what is left
// out is not small beside what is kept.
TEST_F(Matrix, TheOmittedPartIsNotSmallBesideTheKeptOne) {
  const Mesh one = make_grid({1, 1}, {1, 1}, Diagonals::same);
  Model model;
  model.add(StretchTerm(1, 1));
  model.add(ShearTerm(1, 1));
  const Cloth sheet = make_cloth(one, model);
  std::array<std::vector<double>, 2> ratios;  // of stretch, of shear
  for (int n = 0; n < 4000; ++n) {
    const State s = disturbed(one, 0.3, random);
    const auto conditions = dense_conditions(sheet, s.x);
    for (const size_t i : {0u, 2u}) {  // of the first triangle: u, v, shear
      const DenseCondition& c = conditions[i];
      const double Cdot = c.g.dot(s.v);
      const double ratio = c.g.norm() * (c.H * s.v).norm() / (std::abs(Cdot) * c.H.norm());
      ratios[i / 2].push_back(ratio);
      if (i > 0) continue;
      const Vec3 w = gather(sheet.triangles.elements[0], s.x)[0].normalized();
      const Vec3 wdot = gather(sheet.triangles.elements[0], s.v)[0];
      const double along = std::abs(w.dot(wdot)), across = w.cross(wdot).norm();
      ASSERT_NEAR(ratio, across / (std::sqrt(2) * along), 1e-9 * ratio);
    }
  }
  const auto above_1 = [](const std::vector<double>& r) {
    return double(std::ranges::count_if(r, [](double x) { return x > 1; })) / double(r.size());
  };
  for (const auto& [name, r] : {std::pair{"stretch", ratios[0]}, {"shear", ratios[1]}})
    std::printf("omitted / kept, %s: median %.2f, above 1 in %.0f %% of 4000 states\n", name,
                median(r), 100 * above_1(r));
  EXPECT_NEAR(median(ratios[0]), std::sqrt(1.5), 0.05);
  EXPECT_NEAR(above_1(ratios[0]), 1 / std::sqrt(3), 0.03);
  EXPECT_NEAR(median(ratios[1]), 1.25, 0.05);
  EXPECT_NEAR(above_1(ratios[1]), 0.62, 0.03);
}

// Every K and D is the sum over the conditions, each on all coordinates.
TEST_F(Matrix, IsTheSumWrittenOutInFull) {
  for (const Jacobian jacobian : {Jacobian::definite, Jacobian::bw98})
    for (int n = 0; n < 20; ++n) {
      state = disturbed(mesh, 0.3, random);
      const Evaluated ours = evaluate(cloth, state, jacobian);
      const bool all = jacobian == Jacobian::bw98;
      MatX K = total(state.x, zero, [&](const DenseCondition& c) -> MatX {
        const double load = c.term.k * c.C + c.term.kd * c.g.dot(state.v);
        return -c.term.k * c.g * c.g.transpose() - (all ? load : 0) * c.H;
      });
      if (!all) K -= dense_tension(cloth, state.x);
      const MatX D = total(state.x, zero, [](const DenseCondition& c) -> MatX {
        return -c.term.kd * c.g * c.g.transpose();
      });
      EXPECT_LT(relative(ours.K, K), 1e-13);
      EXPECT_LT(relative(ours.D, D), 1e-13);
    }
}

// Only one half is stored: the product has to use it twice.
TEST_F(Matrix, ProductFromOneHalfIsTheDenseProduct) {
  step03::System system(cloth);
  step03::forces(cloth, state, system);
  VecX Kp;
  for (int n = 0; n < 10; ++n) {
    const VecX p = random.vector(int(state.x.size()), 1);
    system.K.multiply(p, Kp);
    EXPECT_LT(relative(Kp, dense(system.K) * p), 1e-14);
  }
}

// A block for every two vertices that share an element, and no more; without damping, no D at all.
TEST_F(Matrix, HasABlockForEveryEdgeAndNoOther) {
  const step03::System system(cloth), undamped(elastic);
  EXPECT_EQ(system.K.upper.size(), 18u);  // 12 sides, 4 diagonals, 2 springs
  EXPECT_TRUE(undamped.D.empty());
  EXPECT_EQ(undamped.D.upper.capacity(), 0u);
}

}  // namespace matrix_test
