#include "picture/blur.h"

#include <cstddef>

namespace {

// The running sum gains the pixel that enters the window and loses the one that leaves.
void mean_along(const std::vector<unsigned char>& in, std::vector<unsigned char>& out, int side,
                int radius, int stride, int next_line) {
  const int width = 2 * radius + 1;
  for (int line = 0; line < side; ++line) {
    const auto at = [=](int i) -> std::size_t { return line * next_line + i * stride; };
    int sum = 0;
    for (int i = -radius; i < side; ++i) {
      if (i + radius < side) sum += in[at(i + radius)];
      if (i - radius - 1 >= 0) sum -= in[at(i - radius - 1)];
      if (i >= 0) out[at(i)] = static_cast<unsigned char>((sum + width / 2) / width);
    }
  }
}

}  // namespace

void blur(std::vector<unsigned char>& mask, int side, int radius) {
  std::vector<unsigned char> other(mask.size());
  for (int pass = 0; pass < 3; ++pass) {
    mean_along(mask, other, side, radius, 1, side);
    mean_along(other, mask, side, radius, side, 1);
  }
}
