// The V-cycle against the same cycle with dense matrices, which have no pattern.
#include "math/multigrid.h"

#include <gtest/gtest.h>

#include "support/pinned.h"

namespace multigrid_test {

Grid half(const Grid& grid) {
  return {{grid.cells[0] / 2, grid.cells[1] / 2}, grid.diagonals};
}

bool can_be_halved(const Grid& grid) {
  return grid.cells[0] % 2 == 0 && grid.cells[1] % 2 == 0;
}

// How much a coarse vertex counts at (du, dv) coarse cells from it: falls linearly to zero along the
// six edges of "same" diagonals, of "alternating" ones along both axes.
double hat(Diagonals diagonals, double du, double dv) {
  if (diagonals == Diagonals::same)
    return std::max(0.0, 1 - std::max({std::abs(du), std::abs(dv), std::abs(du + dv)}));
  return std::max(0.0, 1 - std::abs(du)) * std::max(0.0, 1 - std::abs(dv));
}

// P: fine vertices from coarse ones, the same for x, y and z.
MatX interpolation(const Grid& fine) {
  const Grid coarse = half(fine);
  MatX P = MatX::Zero(3 * fine.vertices(), 3 * coarse.vertices());
  for (int j = 0; j <= fine.cells[1]; ++j)
    for (int i = 0; i <= fine.cells[0]; ++i)
      for (int J = 0; J <= coarse.cells[1]; ++J)
        for (int I = 0; I <= coarse.cells[0]; ++I)
          P.block<3, 3>(3 * fine.vertex(i, j), 3 * coarse.vertex(I, J))
              .diagonal()
              .setConstant(hat(fine.diagonals, 0.5 * i - I, 0.5 * j - J));
  return P;
}

// Block Gauss-Seidel's Δ + L of a full matrix.
MatX lower(const MatX& A) {
  MatX L = A;
  for (int i = 0; i < A.rows(); i += 3) L.block(i, i + 3, 3, A.cols() - i - 3).setZero();
  return L;
}

// P⁻¹ of a V-cycle: forwards, coarse and backwards multiply the error by I − P⁻¹ A. S projects onto what
// the pins leave free on this level.
MatX cycle(const MatX& A, const MatX& S, const Grid& grid) {
  const MatX I = MatX::Identity(A.rows(), A.cols()), closed = product({S, A, S}) + I - S;
  if (!can_be_halved(grid)) {
    const MatX R = range(closed);
    return product({R, inverse(product({R.transpose(), closed, R})), R.transpose()});
  }
  const MatX P = product({S, interpolation(grid)}), coarse = product({P.transpose(), A, P});
  MatX S_c =
      MatX::Zero(coarse.rows(), coarse.cols());  // where a coarse vertex is free in some direction
  for (int i = 0; i < S_c.rows(); i += 3) {
    const MatX R = range(coarse.block<3, 3>(i, i));
    S_c.block<3, 3>(i, i) = product({R, R.transpose()});
  }
  const MatX P_c_inverse = cycle(coarse, S_c, half(grid));
  const MatX forwards = inverse(lower(closed));
  const MatX E = product({I - product({forwards.transpose(), closed}),
                          I - product({P, S_c, P_c_inverse, S_c, P.transpose(), closed}),
                          I - product({forwards, closed})});
  return product({I - E, inverse(closed)});
}

MatX matrix_of(Preconditioner& P, Eigen::Index n) {
  MatX all(n, n);
  VecX s(n);
  for (Eigen::Index j = 0; j < n; ++j) {
    P.apply(VecX::Unit(n, j), s);
    all.col(j) = s;
  }
  return all;
}

TEST(CoarseParents, AreThoseOfTheHatFunctions) {
  for (const Diagonals diagonals : {Diagonals::same, Diagonals::alternating})
    for (Grid grid{{16, 24}, diagonals}; can_be_halved(grid); grid = half(grid)) {
      const auto parents = coarse_parents(grid);
      MatX P = MatX::Zero(grid.vertices(), half(grid).vertices());
      for (int i = 0; i < grid.vertices(); ++i)
        for (const auto& [parent, weight] : parents[size_t(i)]) {
          EXPECT_GT(weight, 0);
          P(i, parent) += weight;
        }
      const MatX expected = interpolation(grid);
      for (int i = 0; i < grid.vertices(); ++i)
        for (int I = 0; I < P.cols(); ++I) EXPECT_EQ(P(i, I), expected(3 * i, 3 * I));
    }
}

TEST(CoarseParents, GiveLinearFieldsExactly) {
  for (const Diagonals diagonals : {Diagonals::same, Diagonals::alternating})
    for (const std::array<int, 2> cells : {std::array{2, 2}, {8, 4}, {12, 20}}) {
      const Grid fine{cells, diagonals}, coarse = half(fine);
      const auto field = [](double u, double v) { return 3 + 2 * u - 5 * v; };
      const auto parents = coarse_parents(fine);
      for (int j = 0; j <= fine.cells[1]; ++j)
        for (int i = 0; i <= fine.cells[0]; ++i) {
          double sum = 0, weights = 0;
          for (const auto& [parent, weight] : parents[size_t(fine.vertex(i, j))]) {
            const int width = coarse.cells[0] + 1;
            sum += weight * field(2 * (parent % width), 2 * (parent / width));
            weights += weight;
          }
          EXPECT_EQ(weights, 1);
          EXPECT_EQ(sum, field(i, j)) << "vertex " << i << ", " << j;
        }
    }
}

struct Case {
  std::array<int, 2> cells;
  Diagonals diagonals;
  const char* pins;
};
std::string name(const Case& c) {
  return std::string(c.diagonals == Diagonals::same ? "Same" : "Alternating") +
         std::to_string(c.cells[0]) + "x" + std::to_string(c.cells[1]) + c.pins;
}
void PrintTo(const Case& c, std::ostream* out) {
  *out << name(c);
}

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const Diagonals diagonals : {Diagonals::same, Diagonals::alternating})
    for (const std::array<int, 2> cells : {std::array{2, 2}, {4, 4}, {8, 4}, {6, 10}, {8, 8}})
      for (const char* pins :
           {"Free", "Corners", "TopRow", "OneDirection", "HalfTheSheet", "AllWays"})
        all.push_back({cells, diagonals, pins});
  return all;
}

struct VCycle : testing::TestWithParam<Case> {
  VCycle() : sheet(161, GetParam().diagonals, {8, 8}) {
    const auto [cells, diagonals, pins] = GetParam();
    sheet.mesh = make_grid({1, 1}, cells, diagonals);
    const std::string configuration = pins;
    const Vec3 n = sheet.random.direction();
    if (configuration == "AllWays" && cells[0] >= 6) {
      sheet = PinnedSheet(162, diagonals, cells);
    } else {
      sheet.model.pins.clear();
      for (int j = 0; j <= cells[1]; ++j)
        for (int i = 0; i <= cells[0]; ++i) {
          const int vertex = sheet.mesh.grid->vertex(i, j);
          const bool corner = i % cells[0] == 0 && j % cells[1] == 0;
          if (configuration == "Corners"  ? corner
              : configuration == "TopRow" ? j == cells[1]
                                          : false)
            sheet.model.pins.push_back(vertex);
          if (configuration == "HalfTheSheet" && 2 * j >= cells[1])
            sheet.model.pins.push_back(vertex);
          if (configuration == "OneDirection" && i <= cells[0] / 2)
            sheet.model.pins.emplace_back(vertex, all_but(n));
        }
    }
    sheet.cloth = make_cloth(sheet.mesh, sheet.model);
    sheet.state = disturbed(sheet.mesh, 0.3 / cells[0], sheet.random);
  }
  PinnedSheet sheet;
};
INSTANTIATE_TEST_SUITE_P(Grids, VCycle, testing::ValuesIn(cases()),
                         [](const auto& test) { return name(test.param); });

TEST_P(VCycle, IsThatOfDenseMatrices) {
  const step04::System system = sheet.step(cg("multigrid", 1e-6));
  EXPECT_EQ(system.counts.capped + system.counts.indefinite, 0);
  const MatX S = filter_matrix(sheet.cloth);
  const MatX P_inverse = matrix_of(*system.preconditioner, S.rows());
  EXPECT_LT(relative(P_inverse, cycle(dense(system.A), S, *sheet.cloth.grid)), 1e-9);
  EXPECT_LT(relative(P_inverse.transpose(), P_inverse), 1e-11);
}

// The eigenvalues of P⁻¹ A, and so those of I − P⁻¹ A, lie between 0 and 1: the cycle alone, repeated,
// converges.
TEST_P(VCycle, ContractsEveryError) {
  const step04::System system = sheet.step(cg("multigrid", 1e-6));
  const MatX Z = free_directions(sheet.cloth), A = dense(system.A);
  const MatX R = root(product({Z.transpose(), A, Z}));
  const MatX P_inverse = matrix_of(*system.preconditioner, A.rows());
  const VecX e = eigenvalues(product({R.transpose(), Z.transpose(), P_inverse, Z, R}));
  EXPECT_GT(e.minCoeff(), 0.01);
  EXPECT_LT(e.maxCoeff(), 1 + 1e-9);
}

}  // namespace multigrid_test
