#include "picture/reduce.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

constexpr double full_light = 65535;

// The sRGB curve of IEC 61966-2-1, both ways, on [0, 1].
double light_of_value(double value) {
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}
double value_of_light(double light) {
  return light <= 0.0031308 ? light * 12.92 : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
}

// Means of light are physical (two half-lit areas look like one of half the light); means of the
// stored values are too dark at every edge.
struct LightTables {
  std::vector<std::uint16_t> light = std::vector<std::uint16_t>(256);
  std::vector<unsigned char> value = std::vector<unsigned char>(65536);

  LightTables() {
    for (std::size_t i = 0; i < light.size(); ++i)
      light[i] = static_cast<std::uint16_t>(
          std::lround(full_light * light_of_value(static_cast<double>(i) / 255)));
    for (std::size_t i = 0; i < value.size(); ++i)
      value[i] = static_cast<unsigned char>(
          std::lround(255 * value_of_light(static_cast<double>(i) / full_light)));
  }
};

// How much of each old pixel lies in a new one, along one axis. In units of 1/size of an old
// pixel both kinds of pixel have whole lengths: an old one `size`, a new one `old_size`.
struct Cover {
  std::vector<int> first;                           // per new pixel; one more at the end
  std::vector<std::vector<std::uint64_t>> weights;  // of first, first + 1, …; they sum to old_size

  Cover(int old_size, int size) {
    for (std::int64_t i = 0; i < size; ++i) {
      const std::int64_t begin = i * old_size, end = begin + old_size;
      first.push_back(static_cast<int>(begin / size));
      weights.emplace_back();
      for (std::int64_t j = first.back(); j * size < end; ++j)
        weights.back().push_back(
            static_cast<std::uint64_t>(std::min(end, (j + 1) * size) - std::max(begin, j * size)));
    }
  }
};

}  // namespace

Image box_reduce(const Image& image, int width, int height) {
  if (width < 1 || height < 1 || width > image.width || height > image.height)
    throw std::invalid_argument("box_reduce: cannot make " + std::to_string(width) + "x" +
                                std::to_string(height) + " of " + std::to_string(image.width) +
                                "x" + std::to_string(image.height));
  static const LightTables tables;
  const Cover across(image.width, width), down(image.height, height);
  const std::uint64_t area = pixel_count(image);  // of a new pixel, in the units of Cover

  Image reduced = filled_image(width, height, {0, 0, 0});
  unsigned char* out = reduced.rgb.data();
  for (std::size_t y = 0; y < down.first.size(); ++y)
    for (std::size_t x = 0; x < across.first.size(); ++x) {
      std::array<std::uint64_t, 3> sum = {area / 2, area / 2, area / 2};  // rounds the division
      for (std::size_t j = 0; j < down.weights[y].size(); ++j) {
        const unsigned char* in =
            &image.rgb[pixel_at(image, across.first[x], down.first[y] + static_cast<int>(j))];
        for (const std::uint64_t weight : across.weights[x])
          for (std::uint64_t& channel : sum)
            channel += down.weights[y][j] * weight * tables.light[*in++];
      }
      for (const std::uint64_t channel : sum) *out++ = tables.value[channel / area];
    }
  return reduced;
}
