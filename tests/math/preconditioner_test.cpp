// s = P⁻¹ r: the properties of every preconditioner, and the formula of each.
#include "math/preconditioner.h"

#include <gtest/gtest.h>

#include "math/direct_solver.h"
#include "math/incomplete_cholesky.h"
#include "support/pinned.h"
#include "support/scenes.h"

namespace preconditioner_test {

// P⁻¹ column by column.
MatX matrix_of(Preconditioner& P, Eigen::Index n) {
  MatX all(n, n);
  VecX s(n);
  for (Eigen::Index j = 0; j < n; ++j) {
    P.apply(VecX::Unit(n, j), s);
    all.col(j) = s;
  }
  return all;
}

// S A S + I − S: pinned directions stand for themselves.
MatX closed(const Cloth& cloth, const MatX& A) {
  const MatX S = filter_matrix(cloth);
  return product({S, A, S}) + MatX::Identity(A.rows(), A.cols()) - S;
}

bool positive_definite(const MatX& A) {
  return eigenvalues(A).minCoeff() > 0;
}

struct Preconditioners : testing::TestWithParam<const char*> {
  MatX inverse_of(const PinnedSheet& sheet, const step04::System& system) const {
    const auto P = make_preconditioner(GetParam(), system.A, sheet.cloth.pins, sheet.cloth.grid);
    P->set(system.A);
    return matrix_of(*P, sheet.state.x.size());
  }
};
INSTANTIATE_TEST_SUITE_P(All, Preconditioners, testing::ValuesIn(all_preconditioners),
                         [](const auto& test) { return std::string(test.param); });

TEST_P(Preconditioners, AreSymmetricAndPositiveDefinite) {
  for (const Diagonals diagonals : {Diagonals::same, Diagonals::alternating}) {
    const PinnedSheet sheet(151, diagonals);
    const MatX P_inverse = inverse_of(sheet, sheet.step({}));
    EXPECT_LT((P_inverse - P_inverse.transpose()).norm(), 1e-13 * P_inverse.norm());
    EXPECT_TRUE(positive_definite(P_inverse));
  }
}

// P⁻¹ keeps the free directions: the filter changes nothing. (Jacobi's has no oblique directions.)
TEST_P(Preconditioners, MapWhatThePinsLeaveFreeOntoItself) {
  const PinnedSheet sheet(152);
  const MatX S = filter_matrix(sheet.cloth), P_inverse = inverse_of(sheet, sheet.step({}));
  const double leaves = product({MatX::Identity(S.rows(), S.cols()) - S, P_inverse, S}).norm();
  if (std::string(GetParam()) != "jacobi") {
    EXPECT_LT(leaves, 1e-12 * P_inverse.norm());
  }
  const MatX Z = free_directions(sheet.cloth);
  EXPECT_TRUE(positive_definite(product({Z.transpose(), P_inverse, Z})));
}

// Each P⁻¹ is nearer to A⁻¹ than the one before: the eigenvalues of P⁻¹ A lie closer together.
TEST(AllPreconditioners, LowerTheConditionNumber) {
  const PinnedSheet sheet(153, Diagonals::same, {8, 8});
  const step04::System system = sheet.step({});
  const MatX Z = free_directions(sheet.cloth), A = dense(system.A);
  const MatX R = root(product({Z.transpose(), A, Z}));
  std::vector<double> condition;
  for (const char* name : all_preconditioners) {
    const auto P = make_preconditioner(name, system.A, sheet.cloth.pins, sheet.cloth.grid);
    P->set(system.A);
    const MatX PA = product({R.transpose(), Z.transpose(), matrix_of(*P, A.rows()), Z, R});
    const VecX e = eigenvalues(PA);
    condition.push_back(e.maxCoeff() / e.minCoeff());
    std::printf("%-10s %.1f\n", name, condition.back());
  }
  for (size_t i = 1; i < condition.size(); ++i) EXPECT_LT(condition[i], 0.8 * condition[i - 1]);
}

TEST(BlockJacobi, IsTheInverseOfTheDiagonalBlocks) {
  const PinnedSheet sheet(154);
  const step04::System system = sheet.step(cg("block", 1e-4));
  const MatX A = closed(sheet.cloth, dense(system.A));
  MatX blocks = MatX::Zero(A.rows(), A.cols());
  for (int i = 0; i < A.rows(); i += 3) blocks.block<3, 3>(i, i) = A.block<3, 3>(i, i).inverse();
  EXPECT_LT(relative(matrix_of(*system.preconditioner, A.rows()), blocks), 1e-12);
}

// A block that is 1e12 times as stiff in one direction, as beside a flap that is almost a line. The inverse
// by cofactors of every second such block has a negative eigenvalue.
TEST(BlockJacobi, StaysDefiniteForBlocksOfCondition1e12) {
  Random random(12);
  int by_cofactors = 0;
  for (int i = 0; i < 500; ++i) {
    const Vec3 n = random.direction();
    const Mat3 B = Mat3::Identity() + 1e12 * n * n.transpose();
    EXPECT_TRUE(positive_definite(inverse_of(B)));
    if (!positive_definite(B.inverse())) ++by_cofactors;
  }
  EXPECT_GT(by_cofactors, 50);
}

TEST(BlockJacobi, OfDiagonalBlocksIsExact) {
  PinnedSheet sheet(155);
  const step04::System system = sheet.step(cg("block", 1e-4));
  BlockMatrix A = system.A;
  for (Mat3& block : A.upper) block.setZero();
  system.preconditioner->set(A);
  EXPECT_LT(relative(matrix_of(*system.preconditioner, 3 * A.rows()),
                     inverse(closed(sheet.cloth, dense(A)))),
            1e-12);
}

Mesh strip() {
  return make_grid({4, 0.5}, {8, 1}, Diagonals::same);
}

struct IC : testing::Test {
  // A of a disturbed sheet on `mesh`, of its own numbering.
  BlockMatrix matrix(const Mesh& mesh, const std::vector<Pin>& pins) {
    Model model;
    model.add(StretchTerm(1000));
    model.add(ShearTerm(500));
    model.pins = pins;
    cloth = make_cloth(mesh, model);
    Random random(156);
    State state = disturbed(mesh, 0.05, random);
    step04::System system(cloth);
    step04::time_step(cloth, 1.0 / 60, state, system);
    return system.A;
  }
  Cloth cloth;
};

// A strip one cell wide, its vertices numbered along it: each triangle adds one vertex to an edge, so
// that no elimination fills anything.
TEST_F(IC, IsExactWhereNothingIsDropped) {
  Mesh mesh = strip();
  const auto along = [](int i) { return i < 9 ? 2 * i : 2 * (i - 9) + 1; };
  Mesh renumbered = mesh;
  renumbered.grid.reset();
  for (Face& face : renumbered.faces)
    for (int& i : face) i = along(i);
  for (int i = 0; i < mesh.vertices(); ++i)
    renumbered.x.segment<3>(3 * along(i)) = mesh.x.segment<3>(3 * i);

  const std::vector<Pin> pins = {0, Pin(5, all_but(Vec3(1, 2, 2) / 3)),
                                 Pin(9, only(Vec3::UnitZ()))};
  for (const bool in_order : {true, false}) {
    const BlockMatrix A = matrix(in_order ? renumbered : mesh, pins);
    IncompleteCholesky P(A, pins);
    P.set(A);
    EXPECT_EQ(P.shift, 0);
    const MatX exact = inverse(closed(cloth, dense(A)));
    const double error = relative(matrix_of(P, exact.rows()), exact);
    if (in_order)
      EXPECT_LT(error, 1e-11);
    else
      EXPECT_GT(error, 1e-3) << "fill was expected here";
  }
}

// (Λ + U)ᵀ Λ⁻¹ (Λ + U) is A wherever A has a block, and wrong only where the fill was dropped.
TEST_F(IC, IsExactOnThePattern) {
  const std::vector<Pin> pins = {0, Pin(12, all_but(Vec3(1, 2, 2) / 3)),
                                 Pin(20, only(Vec3::UnitZ()))};
  const BlockMatrix A = matrix(make_grid({1, 1}, {6, 6}, Diagonals::alternating), pins);
  IncompleteCholesky P(A, pins);
  P.set(A);
  EXPECT_EQ(P.shift, 0);
  const MatX full = closed(cloth, dense(A));
  const MatX off = inverse(matrix_of(P, full.rows())) - full;
  EXPECT_GT(off.norm(), 1e-3 * full.norm()) << "nothing was dropped";
  BlockMatrix ones = A;
  for (Mat3& block : ones.diagonal) block.setOnes();
  for (Mat3& block : ones.upper) block.setOnes();
  EXPECT_LT(off.cwiseProduct(dense(ones)).norm(), 1e-11 * full.norm());
}

// Kershaw's matrix (1978): positive definite, but without its fill the last pivot is negative.
TEST_F(IC, BeginsAgainWithMoreOnTheDiagonalWhenAPivotIsLost) {
  BlockMatrix A = make_block_matrix(4, {{0, 1}, {1, 2}, {2, 3}, {0, 3}});
  for (Mat3& block : A.diagonal) block = 3 * Mat3::Identity();
  for (int i : {0, 1, 2}) A.upper[size_t(A.slot(i, i + 1))] = -2 * Mat3::Identity();
  A.upper[size_t(A.slot(0, 3))] = 2 * Mat3::Identity();
  const MatX full = dense(A);
  ASSERT_TRUE(positive_definite(full));
  IncompleteCholesky P(A, {});
  P.set(A);
  EXPECT_GT(P.shift, 0.01);
  EXPECT_LT(P.shift, 1);
  const MatX inverse_of_P = matrix_of(P, 12);
  EXPECT_LT((inverse_of_P - inverse_of_P.transpose()).norm(), 1e-13 * inverse_of_P.norm());
  EXPECT_TRUE(positive_definite(inverse_of_P));
  // On the pattern it is exact for A + shift diag(A).
  EXPECT_NEAR(inverse(inverse_of_P)(0, 3), -2, 1e-12);
  EXPECT_NEAR(inverse(inverse_of_P)(11, 11), 3 * (1 + P.shift), 1e-12);

  for (Mat3& block : A.upper) block *= 0.1;  // the next matrix begins without a shift
  P.set(A);
  EXPECT_EQ(P.shift, 0);
}

// No shift helps a matrix with a negative diagonal. Then P is I.
TEST_F(IC, IsTheIdentityForAMatrixThatNoShiftMakesDefinite) {
  BlockMatrix A = make_block_matrix(2, {{0, 1}});
  A.diagonal = {Mat3::Identity(), -Mat3::Identity()};
  A.upper[0].setOnes();
  IncompleteCholesky P(A, {});
  P.set(A);
  EXPECT_EQ(matrix_of(P, 6), MatX::Identity(6, 6));
}

TEST(MakePreconditioner, RefusesAnotherNameWithTheChoices) {
  try {
    make_preconditioner("magic", {}, {}, {});
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(),
                 "--preconditioner magic: must be none, jacobi, block, ic or multigrid");
  }
}

// The error of Δv divided by the tolerance: the worst of 12 steps of a stiff cloth that falls from two
// corners.
double worst_error(const char* preconditioner, double tolerance) {
  TestScene scene = sheet(24, Held::by_two_corners, 1e5, 1e4, Gravity::on);
  step04::System system(scene.cloth,
                        {.guard = false, .preconditioner = preconditioner, .tolerance = tolerance});
  const auto direct = make_direct_solver("ldlt", system.A, scene.cloth.inverse_mass);
  VecX exact = system.dv;
  double worst = 0;
  for (int n = 0; n < 12; ++n) {
    State start = scene.start;
    step04::time_step(scene.cloth, 0.01, start, system);
    direct->solve(system.A, system.b, exact);
    worst = std::max(worst, (system.dv - exact).norm() / exact.norm() / tolerance);
    scene.start.v += exact;
    scene.start.x += 0.01 * scene.start.v;
  }
  return worst;
}

// The lesson of step 4: P⁻¹ of blocks underrates soft motions that reach far, that of multigrid does not.
TEST(AllPreconditioners, LeaveAnErrorOfTheToleranceOnlyIfTheyAreNearA) {
  const double block = worst_error("block", 1e-2), multigrid = worst_error("multigrid", 1e-2);
  std::printf("error of dv / tolerance: block %.1f, multigrid %.1f\n", block, multigrid);
  EXPECT_NEAR(block, 17, 5);
  EXPECT_NEAR(multigrid, 1, 0.5);
}

}  // namespace preconditioner_test
