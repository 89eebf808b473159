// A picture in memory, and a colour.
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

using Colour = std::array<unsigned char, 3>;  // red, green, blue as the screen wants them (sRGB)

struct Image {
  int width = 0, height = 0;
  std::vector<unsigned char> rgb;  // 3 bytes per pixel, top row first
};

inline std::size_t pixel_count(const Image& image) {
  return static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
}

// Where the three bytes of pixel (x, y) begin; y counts down from the top row.
inline std::size_t pixel_at(const Image& image, int x, int y) {
  return 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
              static_cast<std::size_t>(x));
}

inline Image filled_image(int width, int height, Colour colour) {
  Image image{width, height, {}};
  image.rgb.resize(3 * pixel_count(image));
  for (std::size_t i = 0; i < image.rgb.size(); ++i) image.rgb[i] = colour[i % 3];
  return image;
}

// The whole picture `part` must have room in `image`; its upper left corner comes to (left, top).
inline void paste(const Image& part, int left, int top, Image& image) {
  for (int y = 0; y < part.height; ++y)
    std::copy_n(&part.rgb[pixel_at(part, 0, y)], 3 * part.width,
                &image.rgb[pixel_at(image, left, top + y)]);
}
