// A symmetric matrix of 3 × 3 blocks, one block row per vertex. Vertices i and j share a block when
// they share an element; the pattern and the place of every element in it are found once, before the
// first step.
//
// Only one half is stored: the diagonal blocks, and the blocks (i, j) with i < j, row by row. A block
// below the diagonal is the transpose of its mirror image.
#pragma once
#include <algorithm>
#include <vector>

#include "math/condition.h"

class BlockMatrix {
 public:
  std::vector<Mat3> diagonal;  // block (i, i)
  std::vector<Mat3> upper;     // block (i, column[s]) for row_start[i] ≤ s < row_start[i + 1]
  std::vector<int> row_start, column;

  int rows() const { return int(diagonal.size()); }
  bool empty() const { return diagonal.empty(); }

  void set_zero() {
    for (Mat3& B : diagonal) B.setZero();
    for (Mat3& B : upper) B.setZero();
  }
  void set_diagonal(const VecX& d) {
    set_zero();
    for (int i = 0; i < rows(); ++i) diagonal[i].diagonal() = d.segment<3>(3 * i);
  }
  // A += factor B, where B has the same pattern or is empty.
  void add(double factor, const BlockMatrix& B) {
    for (size_t i = 0; i < B.diagonal.size(); ++i) diagonal[i] += factor * B.diagonal[i];
    for (size_t s = 0; s < B.upper.size(); ++s) upper[s] += factor * B.upper[s];
  }

  // Ap = A p; the block (i, j) serves row i, and transposed row j. Zero if A is empty.
  void multiply(const VecX& p, VecX& Ap) const {
    Ap.setZero(p.size());
    for (int i = 0; i < rows(); ++i) Ap.segment<3>(3 * i) = diagonal[i] * p.segment<3>(3 * i);
    for (int i = 0; i < rows(); ++i) {
      const Vec3 p_i = p.segment<3>(3 * i);
      Vec3 sum = Ap.segment<3>(3 * i);
      for (int s = row_start[i]; s < row_start[i + 1]; ++s) {
        const int j = 3 * column[s];
        sum += upper[s] * p.segment<3>(j);
        Ap.segment<3>(j) += upper[s].transpose() * p_i;
      }
      Ap.segment<3>(3 * i) = sum;
    }
  }

  // y += factor A p. Nothing if A is empty.
  void add_product(double factor, const VecX& p, VecX& y) const {
    for (int i = 0; i < rows(); ++i) {
      const Vec3 p_i = factor * p.segment<3>(3 * i);
      y.segment<3>(3 * i) += diagonal[i] * p_i;
      for (int s = row_start[i]; s < row_start[i + 1]; ++s) {
        const int j = 3 * column[s];
        y.segment<3>(3 * i) += factor * (upper[s] * p.segment<3>(j));
        y.segment<3>(j) += upper[s].transpose() * p_i;
      }
    }
  }
  // pᵀ A p. Zero if A is empty.
  double form(const VecX& p) const {
    double sum = 0;
    for (int i = 0; i < rows(); ++i) {
      Vec3 Ap = diagonal[i] * p.segment<3>(3 * i);
      for (int s = row_start[i]; s < row_start[i + 1]; ++s)
        Ap += 2 * (upper[s] * p.segment<3>(3 * column[s]));
      sum += Ap.dot(p.segment<3>(3 * i));
    }
    return sum;
  }

  // The place of block (i, j) in `upper`, i < j: a search, for use before the first step.
  int slot(int i, int j) const {
    const auto first = column.begin() + row_start[i], last = column.begin() + row_start[i + 1];
    return int(std::lower_bound(first, last, j) - column.begin());
  }
};

// The pairs (i, j), i < j, of vertices that share an element: what a family adds to the pattern.
template <class Family>
void add_pairs(const Family& family, std::vector<std::array<int, 2>>& pairs) {
  for (const auto& element : family.elements)
    for (int i : element.vertices)
      for (int j : element.vertices)
        if (i < j) pairs.push_back({i, j});
}

inline BlockMatrix make_block_matrix(int vertices, std::vector<std::array<int, 2>> pairs) {
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  BlockMatrix A;
  A.diagonal.assign(vertices, Mat3::Zero());
  A.upper.assign(pairs.size(), Mat3::Zero());
  A.row_start.assign(vertices + 1, 0);
  for (const auto& [i, j] : pairs) {
    ++A.row_start[i + 1];
    A.column.push_back(j);
  }
  for (int i = 0; i < vertices; ++i) A.row_start[i + 1] += A.row_start[i];
  return A;
}

// Where the blocks of an element lie: of each pair i < j of its N vertices, in this order.
template <int N>
using Slots = std::array<int, N*(N - 1) / 2>;

template <class Family>
auto find_slots(const Family& family, const BlockMatrix& A) {
  constexpr int N = Family::N;
  std::vector<Slots<N>> slots;
  for (const auto& element : family.elements) {
    Slots<N>& slot = slots.emplace_back();
    for (int i = 0, pair = 0; i < N; ++i)
      for (int j = i + 1; j < N; ++j, ++pair) {
        const auto [low, high] = std::minmax(element.vertices[i], element.vertices[j]);
        slot[pair] = A.slot(low, high);
      }
  }
  return slots;
}

// Adds the blocks i ≤ j of an element to the half that is stored.
template <size_t N>
void add_blocks(const std::array<int, N>& vertices, const std::array<std::array<Mat3, N>, N>& A_e,
                const std::array<int, N*(N - 1) / 2>& slots, BlockMatrix& A) {
  for (size_t i = 0, pair = 0; i < N; ++i) {
    A.diagonal[vertices[i]] += A_e[i][i];
    for (size_t j = i + 1; j < N; ++j, ++pair)
      if (vertices[i] < vertices[j])
        A.upper[slots[pair]] += A_e[i][j];
      else
        A.upper[slots[pair]] += A_e[i][j].transpose();
  }
}

// The chain rule once more:  A_ij += Σ_mn weight(m, i) A_mn weight(n, j)  for a symmetric A on y.
// Only the blocks of vertices 1, 2, … are multiplied out; because the weights of each y add up to
// zero, every row of blocks does too, and that gives the blocks of vertex 0.
template <int N, int Y>
void scatter(const Element<N, Y>& e, const std::type_identity_t<Mats<Y>>& A_y,
             const Slots<N>& slots, BlockMatrix& A) {
  std::array<std::array<Mat3, N>, N> A_e;
  for (int j = 1; j < N; ++j) {
    std::array<Mat3, Y> A_j;  // Σ_n A_mn weight(n, j)
    for (int m = 0; m < Y; ++m) {
      A_j[m] = e.weight(0, j) * A_y[m][0];
      for (int n = 1; n < Y; ++n) A_j[m] += e.weight(n, j) * A_y[m][n];
    }
    for (int i = 1; i <= j; ++i) {
      A_e[i][j] = e.weight(0, i) * A_j[0];
      for (int m = 1; m < Y; ++m) A_e[i][j] += e.weight(m, i) * A_j[m];
    }
  }
  A_e[0][0].setZero();
  for (int j = 1; j < N; ++j) {
    A_e[0][j].setZero();
    for (int i = 1; i <= j; ++i) A_e[0][j] -= A_e[i][j];
    for (int i = j + 1; i < N; ++i) A_e[0][j] -= A_e[j][i].transpose();
    A_e[0][0] -= A_e[0][j];
  }
  add_blocks(e.vertices, A_e, slots, A);
}

template <int N>
void scatter(const VertexElement<N>& e, const std::type_identity_t<Mats<N>>& A_y,
             const Slots<N>& slots, BlockMatrix& A) {
  add_blocks(e.vertices, A_y, slots, A);
}
