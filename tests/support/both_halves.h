// The symmetric matrix of one element on its vectors y, with both halves.
#pragma once
#include "math/types.h"

template <int Y>
struct BothHalves {
  // Adds B, the block (m, n), m ≤ n, and its mirror image.
  void add(int m, int n, const Mat3& B) {
    blocks[size_t(m)][size_t(n)] += B;
    if (m != n) blocks[size_t(n)][size_t(m)] += B.transpose();
  }
  const Mats<Y>& on_y() const { return blocks; }

  Mats<Y> blocks = zero_matrices<Y>();
};
