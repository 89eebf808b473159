// The V-cycle against the same cycle with dense matrices, which have no pattern.
#include "math/multigrid.h"

#include <gtest/gtest.h>

#include <functional>
#include <span>

#include "support/irregular.h"
#include "support/pinned.h"

namespace multigrid_test {

// How much a coarse vertex counts at (du, dv) coarse cells from it: falls linearly to zero along the
// six edges of "same" diagonals, of "alternating" ones along both axes.
double hat(Diagonals diagonals, double du, double dv) {
  if (diagonals == Diagonals::same)
    return std::max(0.0, 1 - std::max({std::abs(du), std::abs(dv), std::abs(du + dv)}));
  return std::max(0.0, 1 - std::abs(du)) * std::max(0.0, 1 - std::abs(dv));
}

// P: fine vertices from coarse ones, the same for x, y and z.
MatX interpolation(const Grid& fine) {
  const Grid coarse = fine.half();
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

MatX interpolation(const Parents& parents) {
  MatX P = MatX::Zero(3 * Eigen::Index(parents.size()), 3 * coarse_vertices(parents));
  for (size_t i = 0; i < parents.size(); ++i)
    for (const auto& [parent, weight] : parents[i])
      P.block<3, 3>(3 * Eigen::Index(i), 3 * parent).diagonal().array() += weight;
  return P;
}

// P of every level, the finest first. No mesh here needs aggregates twice.
std::vector<MatX> interpolations(const Cloth& cloth) {
  std::vector<MatX> all;
  if (cloth.grid)
    for (Grid grid = *cloth.grid; grid.can_be_halved(); grid = grid.half())
      all.push_back(interpolation(grid));
  if (all.empty() && cloth.vertices() > 200)
    all.push_back(interpolation(aggregate_parents(make_block_matrix(cloth))));
  return all;
}

// Block Gauss-Seidel's Λ + L of a full matrix.
MatX lower(const MatX& A) {
  MatX L = A;
  for (int i = 0; i < A.rows(); i += 3) L.block(i, i + 3, 3, A.cols() - i - 3).setZero();
  return L;
}

// P⁻¹ of a V-cycle: forwards, coarse and backwards multiply the error by I − P⁻¹ A. S projects onto what
// the pins leave free on this level.
MatX cycle(const MatX& A, const MatX& S, std::span<const MatX> levels) {
  const MatX I = MatX::Identity(A.rows(), A.cols()), closed = product({S, A, S}) + I - S;
  if (levels.empty()) {
    const MatX R = range(closed);
    return product({R, inverse(product({R.transpose(), closed, R})), R.transpose()});
  }
  const MatX P = product({S, levels.front()}), coarse = product({P.transpose(), A, P});
  MatX S_c =
      MatX::Zero(coarse.rows(), coarse.cols());  // where a coarse vertex is free in some direction
  for (int i = 0; i < S_c.rows(); i += 3) {
    const MatX R = range(coarse.block<3, 3>(i, i));
    S_c.block<3, 3>(i, i) = product({R, R.transpose()});
  }
  const MatX P_c_inverse = cycle(coarse, S_c, levels.subspan(1));
  const MatX forwards = inverse(lower(closed));
  const MatX E = product({I - product({forwards.transpose(), closed}),
                          I - product({P, S_c, P_c_inverse, S_c, P.transpose(), closed}),
                          I - product({forwards, closed})});
  return product({I - E, inverse(closed)});
}

// 1 times the identity where the pattern has a block.
BlockMatrix pattern_of_ones(const BlockMatrix& pattern) {
  BlockMatrix ones = pattern;
  for (Mat3& B : ones.diagonal) B.setIdentity();
  for (Mat3& B : ones.upper) B.setIdentity();
  return ones;
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
    for (Grid grid{{16, 24}, diagonals}; grid.can_be_halved(); grid = grid.half()) {
      const auto parents = coarse_parents(grid);
      MatX P = MatX::Zero(grid.vertices(), grid.half().vertices());
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
      const Grid fine{cells, diagonals}, coarse = fine.half();
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

struct Aggregates : testing::Test {
  const Mesh mesh = random_disc(20, 165);
  const BlockMatrix pattern = [this] {
    Model model;
    model.add(StretchTerm(1000));
    return make_block_matrix(make_cloth(mesh, model));
  }();
  const Parents parents = aggregate_parents(pattern);
};

// A vertex with d neighbours has d + 1 shares to give.
TEST_F(Aggregates, GetTheSharesOfEachNeighbourhood) {
  const MatX A = dense(pattern_of_ones(pattern));
  for (int i = 0; i < mesh.vertices(); ++i) {
    double sum = 0;
    for (const auto& [parent, weight] : parents[size_t(i)]) {
      const double shares = weight * A.row(3 * i).sum();
      EXPECT_GT(shares, 0.5);
      EXPECT_NEAR(shares, std::round(shares), 1e-12);
      sum += weight;
    }
    EXPECT_NEAR(sum, 1, 1e-14);
  }
}

// The vertex that began an aggregate has no neighbour outside of it.
TEST_F(Aggregates, HaveACentreEachAndAreFewerThanAFifthOfTheVertices) {
  std::vector<int> centres(size_t(coarse_vertices(parents)), 0);
  for (const auto& of_vertex : parents)
    if (of_vertex.size() == 1) ++centres[size_t(of_vertex[0].vertex)];
  for (const int count : centres) EXPECT_GT(count, 0);
  EXPECT_LT(5 * coarse_vertices(parents), mesh.vertices());
}

// Block Gauss–Seidel solves them, and the coarsest level is empty.
TEST(Multigrid, IsExactForVerticesWithoutNeighbours) {
  BlockMatrix A = make_block_matrix(300, {});
  Random random(166);
  for (Mat3& B : A.diagonal) {
    B = Mat3::Identity();
    for (int n = 0; n < 2; ++n) B += 10 * only(random.direction());
  }
  Multigrid P(A, {0}, {});
  P.set(A);
  const VecX x = random.vector(900, 1);
  VecX r, s;
  A.multiply(x, r);
  P.apply(r, s);
  EXPECT_EQ(s.head<3>(), r.head<3>()) << "pinned";
  EXPECT_LT((s - x).tail(897).norm(), 1e-13 * x.norm());
}

struct Case {
  std::string name;
  std::function<PinnedSheet()> make_sheet;
};
void PrintTo(const Case& c, std::ostream* out) {
  *out << c.name;
}
std::string name_of(const testing::TestParamInfo<Case>& test) {
  return test.param.name;
}

// `pins` of a sheet on a mesh: where is a vertex between left and right, bottom and top, from 0 to 1?
PinnedSheet sheet_on(const Mesh& mesh, double edge, const std::string& pins) {
  PinnedSheet sheet(161, Diagonals::same, {8, 8});
  sheet.mesh = mesh;
  sheet.model.pins.clear();
  const Vec3 n = sheet.random.direction();
  const auto coordinates = mesh.x.reshaped(3, mesh.vertices());
  const Vec3 low = coordinates.rowwise().minCoeff(), high = coordinates.rowwise().maxCoeff();
  for (int i = 0; i < mesh.vertices(); ++i) {
    const Vec3 x = mesh.x.segment<3>(3 * i);
    const double right = (x.x() - low.x()) / (high.x() - low.x());
    const double up = (high.z() - x.z()) / (high.z() - low.z());
    const bool corner = std::max(std::abs(2 * right - 1), std::abs(2 * up - 1)) > 0.999 &&
                        std::min(std::abs(2 * right - 1), std::abs(2 * up - 1)) > 0.999;
    if ((pins == "Corners" && corner) || (pins == "TopRow" && up > 0.97) ||
        (pins == "HalfTheSheet" && up > 0.499))
      sheet.model.pins.push_back(i);
    if (pins == "OneDirection" && right < 0.501) sheet.model.pins.emplace_back(i, all_but(n));
  }
  sheet.cloth = make_cloth(sheet.mesh, sheet.model);
  sheet.state = disturbed(sheet.mesh, 0.3 * edge, sheet.random);
  return sheet;
}

std::string name(const std::array<int, 2>& cells, Diagonals diagonals) {
  return (diagonals == Diagonals::same ? "Same" : "Alternating") + std::to_string(cells[0]) + "x" +
         std::to_string(cells[1]);
}

// On grids that are halved, and on one of 256 vertices that cannot be.
std::vector<Case> grids() {
  std::vector<Case> all;
  for (const Diagonals diagonals : {Diagonals::same, Diagonals::alternating})
    for (const std::array<int, 2> cells : {std::array{2, 2}, {4, 4}, {8, 4}, {6, 10}, {8, 8}}) {
      const Mesh mesh = make_grid({1, 1}, cells, diagonals);
      for (const char* pins : {"Free", "Corners", "TopRow", "OneDirection", "HalfTheSheet"})
        all.push_back(
            {name(cells, diagonals) + pins, [=] { return sheet_on(mesh, 1.0 / cells[0], pins); }});
      if (cells[0] >= 6)
        all.push_back({name(cells, diagonals) + "AllWays",
                       [=] { return PinnedSheet(162, diagonals, cells); }});
    }
  all.push_back({"Alternating15x15AllWays", [] {
                   return PinnedSheet(163, Diagonals::alternating, {15, 15});
                 }});
  return all;
}

std::vector<Case> discs() {
  std::vector<Case> all;
  const Mesh mesh = random_disc(9, 164);
  for (const char* pins : {"Free", "TopRow", "OneDirection", "HalfTheSheet"})
    all.push_back({pins, [=] { return sheet_on(mesh, 1.0 / 18, pins); }});
  return all;
}

struct VCycle : testing::TestWithParam<Case> {
  PinnedSheet sheet = GetParam().make_sheet();
};
INSTANTIATE_TEST_SUITE_P(Grids, VCycle, testing::ValuesIn(grids()), name_of);
INSTANTIATE_TEST_SUITE_P(Discs, VCycle, testing::ValuesIn(discs()), name_of);

TEST_P(VCycle, IsThatOfDenseMatrices) {
  const step04::System system = sheet.step(cg("multigrid", 1e-6));
  EXPECT_EQ(system.counts.capped + system.counts.indefinite, 0);
  const MatX S = filter_matrix(sheet.cloth);
  const MatX P_inverse = matrix_of(*system.preconditioner, S.rows());
  EXPECT_LT(relative(P_inverse, cycle(dense(system.A), S, interpolations(sheet.cloth))), 1e-9);
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

// Of a step of 0.01 s from a disturbed state, held at two vertices, to a tolerance of 1e-4.
long iterations(const Mesh& mesh, double edge, const char* preconditioner) {
  Model model;
  model.density = 0.2;
  model.add(StretchTerm(1e4, 10));
  model.add(ShearTerm(1e3, 1));
  model.gravity = Vec3(0, -9.81, 0);
  model.pins = {mesh.vertices() - 1, mesh.vertices() / 2};
  const Cloth cloth = make_cloth(mesh, model);
  Random random(167);
  State state = disturbed(mesh, 0.05 * edge, random);
  step04::System system(cloth, cg(preconditioner, 1e-4));
  system.method.guard = false;
  step04::time_step(cloth, 0.01, state, system);
  EXPECT_EQ(system.counts.capped + system.counts.indefinite, 0);
  return system.counts.iterations;
}

TEST(MultigridOnADisc, HardlyNeedsMoreIterationsOnAFinerMesh) {
  std::vector<double> needed[2];
  for (const int rings : {10, 20, 40}) {
    const Mesh mesh = random_disc(rings, 168);
    for (const bool block : {false, true})
      needed[block].push_back(double(iterations(mesh, 0.5 / rings, block ? "block" : "multigrid")));
    std::printf("%5zu triangles: multigrid %.0f, block %.0f iterations\n", mesh.faces.size(),
                needed[0].back(), needed[1].back());
  }
  EXPECT_LT(needed[0].back(), 2 * needed[0].front());
  EXPECT_GT(needed[1].back(), 10 * needed[0].back());
}

// A garment of 9664 triangles. The file lies beside the project; without it this test is skipped.
TEST(MultigridOnAShirt, NeedsFewIterations) {
  const auto file = std::filesystem::path(SOURCE_DIRECTORY) / "../shared/meshes/tshirt.obj";
  if (!exists(file)) GTEST_SKIP() << file << " does not exist";
  const Mesh mesh = refined(refined(read_obj(file)));
  const long multigrid = iterations(mesh, 0.01, "multigrid"),
             block = iterations(mesh, 0.01, "block");
  std::printf("multigrid %ld, block %ld iterations\n", multigrid, block);
  EXPECT_LT(5 * multigrid, block);
}

}  // namespace multigrid_test
