#include "math/pinned_blocks.h"

PinnedBlocks::PinnedBlocks(const BlockMatrix& pattern, const std::vector<Pin>& pins_)
    : pins(pins_) {
  std::vector<int> pin_of(size_t(pattern.rows()), -1);
  for (size_t p = 0; p < pins.size(); ++p) pin_of[pins[p].vertex] = int(p);
  for (int i = 0; i < pattern.rows(); ++i)
    for (int s = pattern.row_start[i]; s < pattern.row_start[i + 1]; ++s) {
      if (pin_of[i] >= 0) left.push_back({s, pin_of[i]});
      if (pin_of[pattern.column[s]] >= 0) right.push_back({s, pin_of[pattern.column[s]]});
    }
}

void PinnedBlocks::project(BlockMatrix& A) const {
  for (const Pin& pin : pins) A.diagonal[pin.vertex] = pin.S * A.diagonal[pin.vertex] * pin.S;
  for (const auto& [slot, pin] : left) A.upper[slot] = pins[pin].S * A.upper[slot];
  for (const auto& [slot, pin] : right) A.upper[slot] = A.upper[slot] * pins[pin].S;
}

void PinnedBlocks::make_regular(BlockMatrix& A) const {
  for (const Pin& pin : pins) A.diagonal[pin.vertex] += Mat3::Identity() - pin.S;
}
