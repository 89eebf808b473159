// The colour scale of strain maps: every 15th colour of Matplotlib's "viridis" (256 colours, by
// S. van der Walt and N. Smith, CC0), values of sRGB; linear in between.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "picture/image.h"

inline constexpr std::array<std::array<float, 3>, 18> viridis_table = {{
    {0.2670f, 0.0049f, 0.3294f},
    {0.2819f, 0.0897f, 0.4124f},
    {0.2803f, 0.1657f, 0.4765f},
    {0.2637f, 0.2376f, 0.5188f},
    {0.2374f, 0.3052f, 0.5419f},
    {0.2086f, 0.3678f, 0.5527f},
    {0.1823f, 0.4262f, 0.5571f},
    {0.1592f, 0.4822f, 0.5581f},
    {0.1378f, 0.5375f, 0.5549f},
    {0.1211f, 0.5927f, 0.5446f},
    {0.1281f, 0.6477f, 0.5235f},
    {0.1807f, 0.7014f, 0.4882f},
    {0.2741f, 0.7520f, 0.4366f},
    {0.3952f, 0.7975f, 0.3678f},
    {0.5356f, 0.8358f, 0.2819f},
    {0.6889f, 0.8654f, 0.1827f},
    {0.8456f, 0.8873f, 0.0997f},
    {0.9932f, 0.9062f, 0.1439f},
}};

// t from 0 (dark violet) to 1 (yellow).
inline Colour viridis(double t) {
  const double at = std::clamp(t, 0.0, 1.0) * static_cast<double>(viridis_table.size() - 1);
  const std::size_t i = std::min(static_cast<std::size_t>(at), viridis_table.size() - 2);
  const double part = at - static_cast<double>(i);
  Colour colour;
  for (std::size_t c = 0; c < 3; ++c) {
    const double value =
        (1 - part) * double{viridis_table[i][c]} + part * double{viridis_table[i + 1][c]};
    colour[c] = static_cast<unsigned char>(std::lround(255 * value));
  }
  return colour;
}
