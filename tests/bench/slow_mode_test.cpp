// The lesson of step 4 says which error multigrid removes last, and why bending makes it faster.
#include "slow_mode.h"

#include <gtest/gtest.h>

#include "scene/make_cloth.h"
#include "step05_bend/time_step.h"

namespace slow_mode_test {

// The cloth of bench_solve on 32 × 32 cells, 0.2 s after it was released flat.
struct Swing {
  explicit Swing(double bend)
      : mesh(make_grid({1, 1}, {32, 32}, Diagonals::same)),
        cloth(make_cloth(mesh, model(bend))), state{mesh.x, VecX::Zero(mesh.x.size())} {
    step05::System system(cloth,
                          {.guard = false, .preconditioner = "multigrid", .tolerance = 1e-3});
    for (int n = 0; n < 80; ++n) step05::time_step(cloth, 0.0025, state, system);
  }

  Model model(double bend) const {
    Model m;
    m.density = 0.2;
    m.add(StretchTerm(1e4, 10));
    m.add(ShearTerm(1e3, 1));
    if (bend > 0) m.add(DihedralBend(bend, 1e-3 * bend));
    m.gravity = Vec3(0, -9.81, 0);
    m.pins = {mesh.grid->vertex(0, 32), mesh.grid->vertex(32, 32)};
    return m;
  }

  Mesh mesh;
  Cloth cloth;
  State state;
};

// A and P of a step of 0.01 s.
struct Next {
  Next(Cloth& cloth, State state)
      : system(cloth, {.guard = false, .preconditioner = "multigrid", .max_iterations = 0}) {
    step05::time_step(cloth, 0.01, state, system);
    mode = slowest_mode(cloth, system.A, *system.preconditioner, 200);
  }
  step05::System system;
  SlowMode mode;
};

struct SlowestError : testing::Test {
  Swing limp{0}, bending{1e-4};
};

TEST_F(SlowestError, IsASoftRidgeAlongTheNormalThatNoVertexCanUndoAlone) {
  const Next next(limp.cloth, limp.state);
  const BlockMatrix& A = next.system.A;
  const VecX& e = next.mode.e;
  const double normal = share_along_normals(limp.mesh, limp.state.x, e),
               soft = stiffness(limp.cloth, A, e),
               alone = stiffness_alone(limp.cloth, limp.mesh, limp.state.x, A, e),
               sweep = energy_norm(A, after_sweep(limp.cloth, A, e));
  std::printf("left %.3f, along the normal %.2f, stiffness %.1f, of one vertex %.0f, sweep %.3f\n",
              next.mode.left, normal, soft, alone, sweep);
  EXPECT_NEAR(energy_norm(A, e), 1, 1e-12);
  EXPECT_NEAR(normal, 0.90, 0.05);
  EXPECT_NEAR(soft, 3.4, 0.5);
  EXPECT_NEAR(alone, 70, 15);
  EXPECT_NEAR(sweep, 0.989, 0.004);
}

// It is the shape that helps: the matrix of a cloth without bending is as easy in the smoother shape.
TEST_F(SlowestError, FallsFasterInTheSmootherShapeThatBendingGives) {
  const double without = Next(limp.cloth, limp.state).mode.left,
               with = Next(bending.cloth, bending.state).mode.left,
               smoother = Next(limp.cloth, bending.state).mode.left,
               stiffer = Next(bending.cloth, limp.state).mode.left;
  std::printf("left by a V-cycle: %.3f, with bending %.3f; only its shape %.3f, only its K %.3f\n",
              without, with, smoother, stiffer);
  EXPECT_NEAR(without, 0.93, 0.02);
  EXPECT_NEAR(with, 0.82, 0.03);
  EXPECT_NEAR(smoother, with, 0.02);
  EXPECT_NEAR(stiffer, without, 0.03);
}

}  // namespace slow_mode_test
