#include "math/multigrid.h"

#include <Eigen/Eigenvalues>
#include <stdexcept>

namespace {

constexpr int most_dense = 200;  // vertices of the coarsest grid

bool even(const Grid& grid) {
  return grid.cells[0] % 2 == 0 && grid.cells[1] % 2 == 0;
}

Grid half(const Grid& grid) {
  return {{grid.cells[0] / 2, grid.cells[1] / 2}, grid.diagonals};
}

void check(const Grid& grid) {
  Grid coarsest = grid;
  while (even(coarsest)) coarsest = half(coarsest);
  const auto text = [](const Grid& g) {
    return std::to_string(g.cells[0]) + " x " + std::to_string(g.cells[1]);
  };
  const std::string name = "--preconditioner multigrid: ";
  if (!even(grid))
    throw std::invalid_argument(name + "a grid of " + text(grid) +
                                " cells cannot be halved; take even numbers of cells, or use "
                                "--preconditioner ic");
  if (coarsest.vertices() > most_dense)
    throw std::invalid_argument(name + "halving " + text(grid) + " cells ends at " +
                                text(coarsest) +
                                ", too many to be solved densely; take numbers of cells that are "
                                "multiples of a power of two, or use --preconditioner ic");
}

// The projector onto the range of a symmetric sum of projectors.
Mat3 range(const Mat3& sum) {
  const Eigen::SelfAdjointEigenSolver<Mat3> eigen(sum);
  Mat3 onto = Mat3::Zero();
  for (int n = 0; n < 3; ++n)
    if (eigen.eigenvalues()[n] > 1e-9)
      onto += eigen.eigenvectors().col(n) * eigen.eigenvectors().col(n).transpose();
  return onto;
}

// A coarse vertex is left free what any of the fine vertices around it is.
std::vector<Pin> coarse_pins(const std::vector<Pin>& pins,
                             const std::vector<std::vector<Parent>>& parents, int coarse) {
  std::vector<Mat3> free(parents.size(), Mat3::Identity());
  for (const Pin& pin : pins) free[size_t(pin.vertex)] = pin.S;
  std::vector<Mat3> sum(size_t(coarse), Mat3::Zero());
  for (size_t i = 0; i < parents.size(); ++i)
    for (const Parent& parent : parents[i]) sum[size_t(parent.vertex)] += free[i];
  std::vector<Pin> held;
  for (int I = 0; I < coarse; ++I)
    if (const Mat3 S = range(sum[size_t(I)]); !S.isIdentity()) held.emplace_back(I, S);
  return held;
}

}  // namespace

std::vector<std::vector<Parent>> coarse_parents(const Grid& fine) {
  const Grid coarse = half(fine);
  std::vector<std::vector<Parent>> parents;
  for (int j = 0; j <= fine.cells[1]; ++j)
    for (int i = 0; i <= fine.cells[0]; ++i) {
      const int I = i / 2, J = j / 2, right = i % 2, up = j % 2;
      const auto parent = [&](int di, int dj, double weight) {
        return Parent{coarse.vertex(I + di, J + dj), weight};
      };
      if (!right && !up)
        parents.push_back({parent(0, 0, 1)});
      else if (!(right && up))
        parents.push_back({parent(0, 0, 0.5), parent(right, up, 0.5)});
      else if (fine.diagonals == Diagonals::same)
        parents.push_back({parent(1, 0, 0.5), parent(0, 1, 0.5)});
      else
        parents.push_back(
            {parent(0, 0, 0.25), parent(1, 0, 0.25), parent(0, 1, 0.25), parent(1, 1, 0.25)});
    }
  return parents;
}

Multigrid::Multigrid(const BlockMatrix& pattern, const std::vector<Pin>& pins, const Grid& grid) {
  check(grid);
  levels.emplace_back(pattern, pins);
  std::vector<Pin> held = pins;
  for (Grid fine = grid; even(fine); fine = half(fine)) {
    const BlockMatrix coarse = map_to_coarse(fine);
    held = coarse_pins(held, levels.back().parents, coarse.rows());
    levels.emplace_back(coarse, held);
  }
  const Eigen::Index n = 3 * levels.back().A.rows();
  dense = Eigen::MatrixXd::Identity(n, n);
  coarsest.compute(dense);
}

Multigrid::Level::Level(const BlockMatrix& pattern, const std::vector<Pin>& pins)
    : A(pattern), pinned(pattern, pins), inverse(pattern.diagonal),
      r(VecX::Zero(3 * pattern.rows())), s(r), t(r) {}

// From the last level to the next: that has a block for every two vertices that are parents of
// neighbours.
BlockMatrix Multigrid::map_to_coarse(const Grid& grid) {
  Level& fine = levels.back();
  const BlockMatrix& A = fine.A;
  fine.parents = coarse_parents(grid);

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
  BlockMatrix coarse = make_block_matrix(half(grid).vertices(), std::move(pairs));

  const auto place = [&](int I, int J) { return I == J ? I : coarse.rows() + coarse.slot(I, J); };
  // Of the blocks (I, J) and (J, I) that come of (i, j) and its mirror image (j, i), the upper one; on
  // the diagonal both.
  for_each_block([&](int i, int j) {
    fine.share_start.push_back(int(fine.shares.size()));
    for_each_pair(i, j, [&](const Parent& I, const Parent& J) {
      const double weight = I.weight * J.weight;
      if (I.vertex <= J.vertex) fine.shares.push_back({place(I.vertex, J.vertex), false, weight});
      if (i != j && J.vertex <= I.vertex)
        fine.shares.push_back({place(J.vertex, I.vertex), true, weight});
    });
  });
  fine.share_start.push_back(int(fine.shares.size()));
  return coarse;
}

void Multigrid::coarsen(const Level& fine, BlockMatrix& coarse) {
  coarse.set_zero();
  const size_t rows = size_t(coarse.rows());
  const auto hand_on = [&](size_t block, const Mat3& B) {
    for (int n = fine.share_start[block]; n < fine.share_start[block + 1]; ++n) {
      const Share& share = fine.shares[n];
      const size_t to = size_t(share.block);
      Mat3& C = to < rows ? coarse.diagonal[to] : coarse.upper[to - rows];
      if (share.transposed)
        C += share.weight * B.transpose();
      else
        C += share.weight * B;
    }
  };
  const size_t diagonals = fine.A.diagonal.size();
  for (size_t i = 0; i < diagonals; ++i) hand_on(i, fine.A.diagonal[i]);
  for (size_t s = 0; s < fine.A.upper.size(); ++s) hand_on(diagonals + s, fine.A.upper[s]);
}

void Multigrid::set(const BlockMatrix& A) {
  levels[0].A.diagonal = A.diagonal;
  levels[0].A.upper = A.upper;
  for (size_t number = 0; number < levels.size(); ++number) {
    Level& level = levels[number];
    level.pinned.cut(level.A);
    if (number + 1 < levels.size()) coarsen(level, levels[number + 1].A);
    level.pinned.close(level.A);
    for (size_t i = 0; i < level.inverse.size(); ++i)
      level.inverse[i] = level.A.diagonal[i].inverse();
  }

  const BlockMatrix& last = levels.back().A;
  for (int i = 0; i < last.rows(); ++i) {
    dense.block<3, 3>(3 * i, 3 * i) = last.diagonal[i];
    for (int s = last.row_start[i]; s < last.row_start[i + 1]; ++s)
      dense.block<3, 3>(3 * last.column[s], 3 * i) = last.upper[s].transpose();
  }
  // Pins can hold all that P makes of a coarse zigzag: a little keeps it from a zero pivot.
  dense.diagonal().array() += 1e-12 * dense.diagonal().maxCoeff();
  coarsest.compute(dense);
}

void Multigrid::apply(const VecX& r, VecX& s) {
  levels[0].r = r;
  cycle(0);
  s = levels[0].s;
}

void Multigrid::cycle(size_t number) {
  Level& level = levels[number];
  const BlockMatrix& A = level.A;
  VecX &r = level.r, &s = level.s, &t = level.t;
  if (number + 1 == levels.size()) {
    s = r;
    coarsest.solveInPlace(s);
    return;
  }

  // Forwards: (Δ + L) s = r. Row i gives its s to the later rows, whose t is what they have left.
  t = r;
  for (int i = 0; i < A.rows(); ++i) {
    const Vec3 s_i = level.inverse[i] * t.segment<3>(3 * i);
    s.segment<3>(3 * i) = s_i;
    for (int k = A.row_start[i]; k < A.row_start[i + 1]; ++k)
      t.segment<3>(3 * A.column[k]) -= A.upper[k].transpose() * s_i;
  }

  // What is left then is r − A s = −Lᵀ s. Its share of the coarse grid, and the correction from there.
  Level& coarse = levels[number + 1];
  coarse.r.setZero();
  for (int i = 0; i < A.rows(); ++i) {
    Vec3 left = Vec3::Zero();
    for (int k = A.row_start[i]; k < A.row_start[i + 1]; ++k)
      left -= A.upper[k] * s.segment<3>(3 * A.column[k]);
    for (const auto& [parent, weight] : level.parents[i])
      coarse.r.segment<3>(3 * parent) += weight * left;
  }
  cycle(number + 1);
  for (int i = 0; i < A.rows(); ++i)
    for (const auto& [parent, weight] : level.parents[i])
      s.segment<3>(3 * i) += weight * coarse.s.segment<3>(3 * parent);

  // Backwards: (Δ + Lᵀ) s_new = r − L s.
  t = r;
  for (int i = 0; i < A.rows(); ++i) {
    const Vec3 s_i = s.segment<3>(3 * i);
    for (int k = A.row_start[i]; k < A.row_start[i + 1]; ++k)
      t.segment<3>(3 * A.column[k]) -= A.upper[k].transpose() * s_i;
  }
  for (int i = A.rows() - 1; i >= 0; --i) {
    Vec3 left = t.segment<3>(3 * i);
    for (int k = A.row_start[i]; k < A.row_start[i + 1]; ++k)
      left -= A.upper[k] * s.segment<3>(3 * A.column[k]);
    s.segment<3>(3 * i) = level.inverse[i] * left;
  }
}

size_t Multigrid::bytes() const {
  size_t sum = 0;
  for (const Level& level : levels) {
    sum += sizeof(Mat3) * (2 * level.A.diagonal.size() + level.A.upper.size());
    sum += sizeof(int) * (level.A.row_start.size() + level.A.column.size());
    sum += sizeof(Share) * level.shares.size() + sizeof(int) * level.share_start.size();
    for (const auto& parents : level.parents)
      sum += sizeof(parents) + sizeof(Parent) * parents.size();
    sum += 3 * sizeof(double) * size_t(level.r.size());
  }
  return sum + sizeof(double) * size_t(dense.size() * 2);
}
