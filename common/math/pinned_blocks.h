// The effect of pins on the blocks of a matrix. The blocks that it changes are found once.
#pragma once
#include "math/block_matrix.h"
#include "math/pin.h"

class PinnedBlocks {
 public:
  PinnedBlocks(const BlockMatrix& pattern, const std::vector<Pin>& pins);

  void project(BlockMatrix& A) const;       // A ← S A S, where S is the identity but at the pins
  void make_regular(BlockMatrix& A) const;  // A ← A + I − S: definite again

 private:
  struct Side {
    int slot, pin;
  };
  std::vector<Pin> pins;
  std::vector<Side> left, right;  // upper blocks whose row or column is a pin's
};
