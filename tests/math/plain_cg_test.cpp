// Textbook conjugate gradients: their theorems, and why a pinned cloth needs more.
#include "support/plain_cg.h"

#include <gtest/gtest.h>

#include "support/pinned.h"

namespace plain_cg_test {

// Rounded eigenvalues, turned into a full matrix: a block for every two vertices.
BlockMatrix with_eigenvalues(const VecX& eigenvalues, Random& random) {
  const int n = int(eigenvalues.size()), vertices = n / 3;
  MatX columns(n, n);
  for (int j = 0; j < n; ++j) columns.col(j) = random.vector(n, 1);
  const MatX Q = eigenpairs(columns + columns.transpose()).vectors;
  const MatX full = product({Q, eigenvalues.asDiagonal(), Q.transpose()});
  std::vector<std::array<int, 2>> pairs;
  for (int i = 0; i < vertices; ++i)
    for (int j = i + 1; j < vertices; ++j) pairs.push_back({i, j});
  BlockMatrix A = make_block_matrix(vertices, pairs);
  for (int i = 0; i < vertices; ++i) {
    A.diagonal[i] = full.block<3, 3>(3 * i, 3 * i);
    for (int s = A.row_start[i]; s < A.row_start[i + 1]; ++s)
      A.upper[s] = full.block<3, 3>(3 * i, 3 * A.column[s]);
  }
  return A;
}

VecX solution(const BlockMatrix& A, const VecX& b) {
  return solve(dense(A), b);
}

// n different eigenvalues, however often each: n iterations, but for rounding.
TEST(PlainConjugateGradients, NeedAsManyIterationsAsThereAreEigenvalues) {
  Random random(121);
  for (const int different : {1, 2, 5, 9}) {
    VecX eigenvalues(18);
    for (int i = 0; i < 18; ++i) eigenvalues[i] = 1 + i % different;
    const BlockMatrix A = with_eigenvalues(eigenvalues, random);
    const VecX b = random.vector(18, 1);
    VecX x = VecX::Zero(18);
    EXPECT_EQ(conjugate_gradients(A, b, 1e-10, x), different);
    EXPECT_LT(relative(x, solution(A, b)), 1e-9);
  }
}

// The iterates x_0 = 0, x_1, x_2 …: each is what the next lower tolerance ends at, if the residual
// falls in every iteration.
std::vector<VecX> iterates(const BlockMatrix& A, const VecX& b) {
  std::vector<VecX> all = {VecX::Zero(b.size())};
  double left = 1;
  while (left > 1e-10) {
    VecX x = all[0];
    const int iterations = conjugate_gradients(A, b, left * (1 - 1e-6), x);
    EXPECT_EQ(iterations, int(all.size())) << "an iterate was jumped over";
    left = (b - dense(A) * x).norm() / b.norm();
    all.push_back(x);
  }
  return all;
}

struct Iterates : testing::Test {
  Random random{122};
  VecX eigenvalues = VecX::LinSpaced(24, 1, 8), b = random.vector(24, 1);
  BlockMatrix A = with_eigenvalues(eigenvalues, random);
  MatX full = dense(A);
  std::vector<VecX> x = iterates(A, b);
};

TEST_F(Iterates, ComeNearerToTheSolutionEveryTime) {
  const VecX exact = solve(full, b);
  const auto error = [&](const VecX& x_k) {
    return std::sqrt((x_k - exact).dot(full * (x_k - exact)));
  };
  ASSERT_GT(x.size(), 10u);
  for (size_t k = 1; k < x.size(); ++k) EXPECT_LT(error(x[k]), error(x[k - 1])) << "iterate " << k;
}

TEST_F(Iterates, GoAlongConjugateDirections) {
  for (size_t k = 0; k + 1 < x.size(); ++k)
    for (size_t l = 0; l < k; ++l) {
      const VecX p = x[k + 1] - x[k], before = x[l + 1] - x[l];
      const double scale = std::sqrt(p.dot(full * p) * before.dot(full * before));
      EXPECT_LT(std::abs(p.dot(full * before)), 1e-5 * scale) << "directions " << k << ", " << l;
    }
}

// No other point of x_0 + span(b, A b, … A^{k−1} b) is nearer, in the norm of A.
TEST_F(Iterates, AreTheBestThatTheirDirectionsAllow) {
  MatX krylov(b.size(), 6);
  krylov.col(0) = b;
  for (int k = 1; k < 6; ++k) krylov.col(k) = full * krylov.col(k - 1);
  for (int k = 1; k <= 6; ++k) {
    const MatX K = krylov.leftCols(k);
    const VecX best = K * solve(product({K.transpose(), full, K}), K.transpose() * b);
    EXPECT_LT(relative(x[size_t(k)], best), 1e-6) << "iterate " << k;
  }
}

// Here a pinned vertex moves with the forces. Modified conjugate gradients give it what its pin
// prescribes.
TEST(PlainConjugateGradients, LeaveThePinnedVertexMoving) {
  const PinnedSheet sheet(123);
  const step04::System modified = sheet.step(cg("none", 1e-10));
  const VecX z = prescribed(sheet.cloth, sheet.state.v);
  VecX plain = z;
  conjugate_gradients(modified.A, modified.b, 1e-10, plain);
  EXPECT_LT(relative(plain, solution(modified.A, modified.b)), 1e-8);
  for (const Pin& pin : sheet.cloth.pins) {
    const auto missed = [&](const VecX& dv) {
      const Vec3 d = dv.segment<3>(3 * pin.vertex) - z.segment<3>(3 * pin.vertex);
      return (d - pin.S * d).norm();
    };
    EXPECT_GT(missed(plain), 0.1) << "vertex " << pin.vertex;
    EXPECT_LT(missed(modified.dv), 1e-14) << "vertex " << pin.vertex;
  }
}

}  // namespace plain_cg_test
