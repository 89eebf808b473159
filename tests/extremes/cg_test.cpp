// Conjugate gradients on the hardest matrices: starts that must break no step, long steps, stiff
// threads. A tolerance of a tenth is enough wherever a direct solver survives, because the stop
// test measures the residual by the kinetic energy of Δv.
#include <gtest/gtest.h>

#include "step04_cg/time_step.h"
#include "support/outcome.h"

namespace extremes::cg_test {

Method with(const char* preconditioner, double tolerance) {
  Method method;
  method.preconditioner = preconditioner;
  method.tolerance = tolerance;
  return method;
}

const std::vector<std::pair<const char*, MakeScene>> starts = {
    {"dropped", dropped},       {"squeezed", squeezed},   {"tangled", tangled},
    {"coincident", coincident}, {"collapsed", collapsed}, {"shot", shot}};

void expect_survived(const char* preconditioner) {
  std::printf("%-11s %8s %6s  %11s %11s %9s\n", "start", "h/s", "k", "iterations", "gain/J",
              "last");
  for (const auto& [name, make] : starts)
    for (const double h : {1.0 / 60, 0.1})
      for (const double k : {1e2, 1e5, 1e8}) {
        const TestScene scene = make(k);
        step04::System system(scene.cloth, with(preconditioner, 0.1));
        const Outcome o = watch(scene, h, 60, system, step04::time_step);
        std::printf("%-11s %8.4f %6.0e  %11ld %11.2e %9.4f\n", name, h, k, system.counts.iterations,
                    o.gain, o.last);
        const std::string where = std::string(name) + ", h = " + std::to_string(h);
        EXPECT_TRUE(o.finite) << where << ", k = " << k;
        EXPECT_LT(o.last, 3) << where << ", k = " << k;
        EXPECT_EQ(o.indefinite, 0) << where << ", k = " << k;
        EXPECT_LT(system.counts.capped, 10) << where << ", k = " << k;  // 6 measured
      }
}

TEST(LooseConjugateGradients, SurviveTheWorstStartsWithBlocks) {
  expect_survived("block");
}

TEST(LooseConjugateGradients, SurviveTheWorstStartsWithIncompleteCholesky) {
  expect_survived("ic");
}

TEST(LooseConjugateGradients, SurviveTheWorstStartsWithMultigrid) {
  expect_survived("multigrid");
}

// The textbook loop: block Jacobi, until |r| ≤ tolerance |b|.
void solve_to_relative_residual(const Cloth& cloth, step04::System& system) {
  VecX &dv = system.dv, &r = system.r, &c = system.c, &q = system.q, &s = system.s;
  dv.setZero(), c.setZero();
  r = system.b;
  step04::filter(cloth, r);
  const double enough = system.method.tolerance * r.norm();
  double delta_before = 1;
  for (int i = 0; i < 10000 && r.norm() > enough; ++i) {
    system.preconditioner->apply(r, s);
    const double delta = r.dot(s);
    c = s + delta / delta_before * c;
    system.A.multiply(c, q);
    step04::filter(cloth, q);
    const double alpha = delta / c.dot(q);
    dv += alpha * c;
    r -= alpha * q;
    delta_before = delta;
  }
}

void textbook_step(const Cloth& cloth, double h, State& state, step04::System& system) {
  step04::forces(cloth, state, system);
  system.K.multiply(state.v, system.b);
  system.b = h * (system.f + h * system.b);
  system.A.set_diagonal(cloth.mass);
  system.A.add(-h * h, system.K);
  system.preconditioner->set(system.A);
  solve_to_relative_residual(cloth, system);
  state.v += system.dv;
  state.x += h * state.v;
}

// A residual of 1e-4 |b| is no small error if stiff directions dominate b: the error that is left
// in the velocity of soft directions may be (h ω)² times as large.
TEST(LooseConjugateGradients, ExplodeWhereTheyStopByTheRelativeResidual) {
  const TestScene scene = shot(1e8);
  step04::System textbook(scene.cloth, with("block", 1e-4)), ours(scene.cloth, with("block", 0.1));
  const Outcome exploded = watch(scene, 0.1, 60, textbook, textbook_step);
  EXPECT_TRUE(!exploded.finite || exploded.last > 1e6);
  const Outcome direct = watch(scene, 0.1, 60);
  const double kinetic = energies(scene.cloth, direct.end).kinetic,
               shot_off = energies(scene.cloth, scene.start).kinetic;
  std::printf("direct: stretch %.4f, %.1e J of %.0f J are left in motion\n", direct.last, kinetic,
              shot_off);
  EXPECT_LT(direct.last, 1.01);
  EXPECT_LT(kinetic, 1e-3);
  EXPECT_LT(watch(scene, 0.1, 60, ours, step04::time_step).last, 3);
}

}  // namespace extremes::cg_test
