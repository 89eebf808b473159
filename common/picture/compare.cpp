#include "picture/compare.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include "text/text.h"

namespace {

void require_same_size(const Image& a, const Image& b) {
  if (a.width != b.width || a.height != b.height)
    throw std::invalid_argument("the pictures differ in size: " + std::to_string(a.width) + "x" +
                                std::to_string(a.height) + " and " + std::to_string(b.width) + "x" +
                                std::to_string(b.height));
}

void include_in_box(int x, int y, Difference& d) {
  const bool first = d.right < d.left;
  d.left = first ? x : std::min(d.left, x);
  d.right = first ? x : std::max(d.right, x);
  d.top = first ? y : std::min(d.top, y);
  d.bottom = first ? y : std::max(d.bottom, y);
}

unsigned char mix(double a, double b, double t) {
  return static_cast<unsigned char>(std::lround(a + (b - a) * t));
}

Colour difference_colour(int difference, const unsigned char* reference) {
  const int grey = 200 + (reference[0] + reference[1] + reference[2]) * 45 / 765;
  if (difference == 0) {
    const unsigned char pale = static_cast<unsigned char>(grey);
    return {pale, pale, pale};
  }
  if (difference <= 2) return {194, 214, 236};
  const double t = std::sqrt(std::min(difference, 64) / 64.0);  // root: small ones stay visible
  return {mix(255, 120, t), mix(165, 0, t), mix(40, 0, t)};
}

constexpr int window_side = 16;

// A table of sums, sum(x, y) = how many marked pixels lie left of x and above y, gives the count of any
// rectangle by four look-ups.
int densest_window(const std::vector<bool>& marked, int width, int height) {
  std::vector<int> sums(static_cast<std::size_t>(width + 1) * static_cast<std::size_t>(height + 1));
  const auto sum = [&](int x, int y) -> int& {
    return sums[static_cast<std::size_t>(y) * static_cast<std::size_t>(width + 1) +
                static_cast<std::size_t>(x)];
  };
  int most = 0;
  std::size_t pixel = 0;
  for (int y = 1; y <= height; ++y)
    for (int x = 1; x <= width; ++x) {
      sum(x, y) = sum(x - 1, y) + sum(x, y - 1) - sum(x - 1, y - 1) + marked[pixel++];
      const int left = std::max(0, x - window_side), top = std::max(0, y - window_side);
      most = std::max(most, sum(x, y) - sum(left, y) - sum(x, top) + sum(left, top));
    }
  return most;
}

}  // namespace

int pixel_difference(const unsigned char* a, const unsigned char* b) {
  return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
}

Difference compare(const Image& a, const Image& b) {
  require_same_size(a, b);
  Difference d;
  d.pixels = static_cast<long>(pixel_count(a));
  std::vector<bool> marked;
  marked.reserve(pixel_count(a));
  double squares = 0;
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x) {
      const unsigned char* pa = &a.rgb[pixel_at(a, x, y)];
      const unsigned char* pb = &b.rgb[pixel_at(b, x, y)];
      for (int c = 0; c < 3; ++c) squares += (pa[c] - pb[c]) * (pa[c] - pb[c]);
      const int difference = pixel_difference(pa, pb);
      d.largest = std::max(d.largest, difference);
      d.above0 += difference > 0;
      d.above2 += difference > 2;
      marked.push_back(difference > 2);
      if (difference <= 8) continue;
      ++d.above8;
      d.centre_x += x;
      d.centre_y += y;
      include_in_box(x, y, d);
    }
  d.window = densest_window(marked, a.width, a.height);
  if (d.pixels > 0) d.rmse = std::sqrt(squares / (3.0 * static_cast<double>(d.pixels)));
  if (d.above8 > 0) d.centre_x /= static_cast<double>(d.above8);
  if (d.above8 > 0) d.centre_y /= static_cast<double>(d.above8);
  return d;
}

// The limits lie between what threshold_study (tests/README.md) measured of two kinds of pictures.
// Equivalent: another compiler, backend or release of Debian, which also moves vertices by the last digits.
// Different: a vertex moved by 1 mm, 1 mm beside the camera, a missing triangle. The largest difference of a
// pixel says nothing: at a silhouette one pixel jumps by 40 for 0.01 mm.
//
//                          limit   equivalent    different
//     densest window           6   at most 4     at least 10
//     above 2, of all       2e-4   at most 8e-5  1e-3, where the window is below 16
//     rmse                  0.25   at most 0.12  at least 0.29, where the window is below 16
Verdict verdict(const Difference& d) {
  if (d.largest == 0) return Verdict::IDENTICAL;
  const bool scattered = d.window <= 6;
  const bool few = static_cast<double>(d.above2) <= 2e-4 * static_cast<double>(d.pixels);
  return scattered && few && d.rmse <= 0.25 ? Verdict::EQUIVALENT : Verdict::DIFFERENT;
}

std::string describe(const Difference& d) {
  const Verdict v = verdict(d);
  const char* name = v == Verdict::IDENTICAL    ? "IDENTICAL"
                     : v == Verdict::EQUIVALENT ? "EQUIVALENT"
                                                : "DIFFERENT";
  // The peak signal-to-noise ratio, decibels.
  const std::string psnr = d.rmse > 0 ? text("%.1f", 20 * std::log10(255 / d.rmse)) : "inf";
  const std::string line =
      text("%s max=%d rmse=%.3f psnr=%s dB above0=%ld above2=%ld above8=%ld window=%d", name,
           d.largest, d.rmse, psnr.c_str(), d.above0, d.above2, d.above8, d.window);
  if (d.above8 == 0) return line;
  return line + text(" box=(%d,%d)-(%d,%d) centre=(%.1f,%.1f)", d.left, d.top, d.right, d.bottom,
                     d.centre_x, d.centre_y);
}

Image difference_picture(const Image& a, const Image& b) {
  require_same_size(a, b);
  Image picture = a;
  for (std::size_t i = 0; i < picture.rgb.size(); i += 3) {
    const int difference = pixel_difference(&a.rgb[i], &b.rgb[i]);
    const Colour colour = difference_colour(difference, &a.rgb[i]);
    std::copy(colour.begin(), colour.end(), &picture.rgb[i]);
  }
  return picture;
}
