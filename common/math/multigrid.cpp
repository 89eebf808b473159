#include "math/multigrid.h"

#include <Eigen/Eigenvalues>

namespace {

constexpr int most_dense = 200;  // vertices of the coarsest level of a mesh

// The projector onto the range of a symmetric sum of projectors.
Mat3 range(const Mat3& sum) {
  const Eigen::SelfAdjointEigenSolver<Mat3> eigen(sum);
  Mat3 onto = Mat3::Zero();
  for (int n = 0; n < 3; ++n)
    if (eigen.eigenvalues()[n] > 1e-9)
      onto += eigen.eigenvectors().col(n) * eigen.eigenvectors().col(n).transpose();
  return onto;
}

// A coarse vertex may move in every direction in which one of its fine children may.
std::vector<Pin> coarse_pins(const std::vector<Pin>& pins, const Parents& parents, int coarse) {
  std::vector<Mat3> free(parents.size(), Mat3::Identity());
  for (const Pin& pin : pins) free[pin.vertex] = pin.S;
  std::vector<Mat3> sum(size_t(coarse), Mat3::Zero());
  for (size_t i = 0; i < parents.size(); ++i)
    for (const Parent& parent : parents[i]) sum[parent.vertex] += free[i];
  std::vector<Pin> held;
  for (int I = 0; I < coarse; ++I)
    if (const Mat3 S = range(sum[I]); !S.isIdentity()) held.emplace_back(I, S);
  return held;
}

}  // namespace

Multigrid::Multigrid(const BlockMatrix& pattern, const std::vector<Pin>& pins,
                     std::optional<Grid> grid) {
  levels.emplace_back(pattern, pins);
  std::vector<Pin> held = pins;
  for (;;) {
    Level& fine = levels.back();
    if (grid && !grid->can_be_halved()) grid.reset();
    if (!grid && fine.A.rows() <= most_dense) break;
    fine.parents = grid ? coarse_parents(*grid) : aggregate_parents(fine.A);
    if (grid) grid = grid->half();
    const BlockMatrix coarse = map_to_coarse(fine);
    held = coarse_pins(held, fine.parents, coarse.rows());
    levels.emplace_back(coarse, held);
  }
  const Eigen::Index n = 3 * levels.back().A.rows();
  dense = Eigen::MatrixXd::Identity(n, n);
  coarsest.compute(dense);
}

Multigrid::Level::Level(const BlockMatrix& pattern, const std::vector<Pin>& pins)
    : A(pattern), pinned(pattern, pins), inverse(pattern.diagonal),
      r(VecX::Zero(3 * pattern.rows())), s(r), t(r) {}

// The pattern of the next level: a block for every two vertices that are parents of neighbours.
BlockMatrix Multigrid::map_to_coarse(Level& fine) {
  const BlockMatrix& A = fine.A;

  const auto for_each_pair = [&](int i, int j, const auto& act) {
    for (const Parent& I : fine.parents[i])
      for (const Parent& J : fine.parents[j]) act(I, J);
  };
  const auto for_each_block = [&](const auto& act) {
    for (int i = 0; i < A.rows(); ++i) act(i, i);
    for (int i = 0; i < A.rows(); ++i)
      for (int s = A.row_start[i]; s < A.row_start[i + 1]; ++s) act(i, A.column[s]);
  };

  std::vector<std::array<int, 2>> pairs;
  for_each_block([&](int i, int j) {
    for_each_pair(i, j, [&](const Parent& I, const Parent& J) {
      if (I.vertex != J.vertex)
        pairs.push_back({std::min(I.vertex, J.vertex), std::max(I.vertex, J.vertex)});
    });
  });
  BlockMatrix coarse = make_block_matrix(coarse_vertices(fine.parents), std::move(pairs));

  const auto place = [&](int I, int J) { return I == J ? I : coarse.rows() + coarse.slot(I, J); };
  // Only upper blocks are stored: (i, j) adds to (I, J) where I < J, else its transpose adds to (J, I).
  // A diagonal block gets both.
  for_each_block([&](int i, int j) {
    fine.contribution_start.push_back(int(fine.contributions.size()));
    for_each_pair(i, j, [&](const Parent& I, const Parent& J) {
      const double weight = I.weight * J.weight;
      if (I.vertex <= J.vertex)
        fine.contributions.push_back({place(I.vertex, J.vertex), false, weight});
      if (i != j && J.vertex <= I.vertex)
        fine.contributions.push_back({place(J.vertex, I.vertex), true, weight});
    });
  });
  fine.contribution_start.push_back(int(fine.contributions.size()));
  return coarse;
}

void Multigrid::coarsen(const Level& fine, BlockMatrix& coarse) {
  coarse.set_zero();
  const size_t rows = size_t(coarse.rows());
  const auto add_to_coarse = [&](size_t block, const Mat3& B) {
    for (int n = fine.contribution_start[block]; n < fine.contribution_start[block + 1]; ++n) {
      const Contribution& contribution = fine.contributions[n];
      const size_t to = size_t(contribution.block);
      Mat3& C = to < rows ? coarse.diagonal[to] : coarse.upper[to - rows];
      if (contribution.transposed)
        C += contribution.weight * B.transpose();
      else
        C += contribution.weight * B;
    }
  };
  const size_t diagonals = fine.A.diagonal.size();
  for (size_t i = 0; i < diagonals; ++i) add_to_coarse(i, fine.A.diagonal[i]);
  for (size_t s = 0; s < fine.A.upper.size(); ++s) add_to_coarse(diagonals + s, fine.A.upper[s]);
}

void Multigrid::set(const BlockMatrix& A) {
  levels[0].A.diagonal = A.diagonal;
  levels[0].A.upper = A.upper;
  for (size_t number = 0; number < levels.size(); ++number) {
    Level& level = levels[number];
    level.pinned.project(level.A);
    if (number + 1 < levels.size()) coarsen(level, levels[number + 1].A);
    level.pinned.make_regular(level.A);
    for (size_t i = 0; i < level.inverse.size(); ++i)
      level.inverse[i] = inverse_of(level.A.diagonal[i]);
  }

  const BlockMatrix& last = levels.back().A;
  for (int i = 0; i < last.rows(); ++i) {
    dense.block<3, 3>(3 * i, 3 * i) = last.diagonal[i];
    for (int s = last.row_start[i]; s < last.row_start[i + 1]; ++s)
      dense.block<3, 3>(3 * last.column[s], 3 * i) = last.upper[s].transpose();
  }
  // Q can map a coarse zigzag onto pinned vertices only; its pivot would be zero. This small number
  // prevents that.
  dense.diagonal().array() += 1e-12 * dense.lpNorm<Eigen::Infinity>();
  coarsest.compute(dense);
}

void Multigrid::apply(const VecX& r, VecX& s) {
  levels[0].r = r;
  cycle(0);
  s = levels[0].s;
}

void Multigrid::cycle(size_t number) {
  Level& level = levels[number];
  if (number + 1 == levels.size()) return solve_densely(level);
  Level& coarse = levels[number + 1];
  smooth_forwards(level);
  restrict_residual(level, coarse);
  cycle(number + 1);
  interpolate(coarse, level);
  smooth_backwards(level);
}

void Multigrid::solve_densely(Level& level) const {
  level.s = level.r;
  coarsest.solveInPlace(level.s);
}

// t_i = r_i − Σ A_ij s_j over the rows j < i that are done.
void Multigrid::smooth_forwards(Level& level) {
  const BlockMatrix& A = level.A;
  VecX &s = level.s, &t = level.t;
  t = level.r;
  for (int i = 0; i < A.rows(); ++i) {
    const Vec3 s_i = level.inverse[i] * t.segment<3>(3 * i);
    s.segment<3>(3 * i) = s_i;
    for (int k = A.row_start[i]; k < A.row_start[i + 1]; ++k)
      t.segment<3>(3 * A.column[k]) -= A.upper[k].transpose() * s_i;
  }
}

// After smoothing forwards from zero r − A s = −Lᵀ s.
void Multigrid::restrict_residual(const Level& fine, Level& coarse) {
  const BlockMatrix& A = fine.A;
  coarse.r.setZero();
  for (int i = 0; i < A.rows(); ++i) {
    Vec3 residual = Vec3::Zero();
    for (int k = A.row_start[i]; k < A.row_start[i + 1]; ++k)
      residual -= A.upper[k] * fine.s.segment<3>(3 * A.column[k]);
    for (const auto& [parent, weight] : fine.parents[i])
      coarse.r.segment<3>(3 * parent) += weight * residual;
  }
}

void Multigrid::interpolate(const Level& coarse, Level& fine) {
  for (int i = 0; i < fine.A.rows(); ++i)
    for (const auto& [parent, weight] : fine.parents[i])
      fine.s.segment<3>(3 * i) += weight * coarse.s.segment<3>(3 * parent);
}

// s ← s + (Λ + Lᵀ)⁻¹ (r − A s), that is (Λ + Lᵀ) s_new = r − L s.
void Multigrid::smooth_backwards(Level& level) {
  const BlockMatrix& A = level.A;
  VecX &s = level.s, &t = level.t;
  t = level.r;
  for (int i = 0; i < A.rows(); ++i) {
    const Vec3 s_i = s.segment<3>(3 * i);
    for (int k = A.row_start[i]; k < A.row_start[i + 1]; ++k)
      t.segment<3>(3 * A.column[k]) -= A.upper[k].transpose() * s_i;
  }
  for (int i = A.rows() - 1; i >= 0; --i) {
    Vec3 residual = t.segment<3>(3 * i);
    for (int k = A.row_start[i]; k < A.row_start[i + 1]; ++k)
      residual -= A.upper[k] * s.segment<3>(3 * A.column[k]);
    s.segment<3>(3 * i) = level.inverse[i] * residual;
  }
}

size_t Multigrid::bytes() const {
  size_t sum = 0;
  for (const Level& level : levels) {
    sum += sizeof(Mat3) * (2 * level.A.diagonal.size() + level.A.upper.size());
    sum += sizeof(int) * (level.A.row_start.size() + level.A.column.size());
    sum += sizeof(Contribution) * level.contributions.size() +
           sizeof(int) * level.contribution_start.size();
    for (const auto& parents : level.parents)
      sum += sizeof(std::vector<Parent>) + sizeof(Parent) * parents.size();
    sum += 3 * sizeof(double) * size_t(level.r.size());
  }
  return sum + sizeof(double) * size_t(dense.size() * 2);
}
