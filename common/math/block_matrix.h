// A symmetric matrix of 3 × 3 blocks, one block row per vertex. Vertices i and j share a block when
// they share an element; the pattern and the place of every element in it are found once, before the
// first step.
//
// Only one half is stored: the diagonal blocks, and the blocks (i, j) with i < j, row by row. A block
// below the diagonal is the transpose of its mirror image.
#pragma once
#include <algorithm>
#include <utility>
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

// Adds B, the block (i, j) of an element, i ≤ j, to the half that is stored: as it is, or transposed.
template <int N, class Block>
void add_block(const std::array<int, N>& vertices, int i, int j, int pair, const Slots<N>& slots,
               const Block& B, BlockMatrix& A) {
  if (i == j)
    A.diagonal[vertices[i]] += B;
  else if (vertices[i] < vertices[j])
    A.upper[slots[pair]] += B;
  else
    A.upper[slots[pair]] += B.transpose();
}

template <int N>
void add_blocks(const std::array<int, N>& vertices, const Mats<N>& A_e, const Slots<N>& slots,
                BlockMatrix& A) {
  for (int i = 0, pair = 0; i < N; ++i) {
    add_block<N>(vertices, i, i, 0, slots, A_e[i][i], A);
    for (int j = i + 1; j < N; ++j, ++pair) add_block<N>(vertices, i, j, pair, slots, A_e[i][j], A);
  }
}

// The symmetric matrix of one element: a sum over its conditions, each on the vectors y that it reads. Only the
// blocks m ≤ n are formed.
template <int N, int Y>
class MatrixOnY {
 public:
  MatrixOnY(const Element<N, Y>& element_, const Slots<N>& slots_, BlockMatrix& A_)
      : element(element_), slots(slots_), A(A_) {}

  template <class Block>
  void add(int m, int n, const Block& B) {
    A_y[m][n] += B;
  }
  const Mats<Y>& on_y() const { return A_y; }
  void scatter() const;  // nothing where A is empty

 private:
  const Element<N, Y>& element;
  const Slots<N>& slots;
  BlockMatrix& A;
  Mats<Y> A_y = zero_matrices<Y>();
};

// The chain rule once more:  A_ij += Σ_mn weight(m, i) A_mn weight(n, j)  for a symmetric A on y.
// Only the blocks of vertices 1, 2, … are multiplied out; because the weights of each y add up to
// zero, every row of blocks does too, and that gives the blocks of vertex 0.
template <int N, int Y>
void MatrixOnY<N, Y>::scatter() const {
  if (A.empty()) return;
  Mats<N> A_e;
  for (int j = 1; j < N; ++j) {
    std::array<Mat3, Y> A_j;  // Σ_n A_mn weight(n, j)
    for (int m = 0; m < Y; ++m) {
      A_j[m] = element.weight(m, j) * A_y[m][m];
      for (int n = 0; n < m; ++n) A_j[m] += element.weight(n, j) * A_y[n][m].transpose();
      for (int n = m + 1; n < Y; ++n) A_j[m] += element.weight(n, j) * A_y[m][n];
    }
    for (int i = 1; i <= j; ++i) {
      A_e[i][j] = element.weight(0, i) * A_j[0];
      for (int m = 1; m < Y; ++m) A_e[i][j] += element.weight(m, i) * A_j[m];
    }
  }
  A_e[0][0].setZero();
  for (int j = 1; j < N; ++j) {
    A_e[0][j].setZero();
    for (int i = 1; i <= j; ++i) A_e[0][j] -= A_e[i][j];
    for (int i = j + 1; i < N; ++i) A_e[0][j] -= A_e[j][i].transpose();
    A_e[0][0] -= A_e[0][j];
  }
  add_blocks<N>(element.vertices, A_e, slots, A);
}

// The same where the vectors y are the vertices: a block goes straight to its place in A.
template <int N>
class MatrixOnVertices {
 public:
  MatrixOnVertices(const VertexElement<N>& element_, const Slots<N>& slots_, BlockMatrix& A_)
      : element(element_), slots(slots_), A(A_) {}

  template <class Block>
  void add(int i, int j, const Block& B) {
    add_block<N>(element.vertices, i, j, i * (2 * N - 1 - i) / 2 + j - i - 1, slots, B, A);
  }
  void scatter() const {}

 private:
  const VertexElement<N>& element;
  const Slots<N>& slots;
  BlockMatrix& A;
};

template <int N, int Y>
MatrixOnY<N, Y> matrix_of(const Element<N, Y>&);
template <int N>
MatrixOnVertices<N> matrix_of(const VertexElement<N>&);
template <class Element>
using ElementMatrix = decltype(matrix_of(std::declval<const Element&>()));

// Adds factor ∂²C/∂y² of a condition to the matrix of its element.
template <class Condition, class Matrix>
void add_second(double factor, const Condition& c, Matrix& A) {
  const auto d2Cdy2 = c.second();
  for (int m = 0; m < c.M; ++m)
    for (int n = m; n < c.M; ++n) A.add(c.first + m, c.first + n, factor * d2Cdy2[m][n]);
}
