#include "picture/overlay.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "math/types.h"
#include "picture/stroke_font.h"
#include "picture/viridis.h"
#include "text/text.h"

namespace {

constexpr Colour ink = {26, 30, 40}, pale_ink = {104, 112, 126};
constexpr double capital = 6;       // grid units from baseline to capital height
constexpr double letter_gap = 1.9;  // grid units between letters
constexpr double word_gap = 2.6;    // grid units, width of a space

std::string_view glyph(char c) {
  const bool printable = c >= first_glyph && c <= last_glyph;
  return stroke_font[static_cast<std::size_t>((printable ? c : '?') - first_glyph)];
}

double glyph_width(char c) {
  if (c == ' ') return word_gap - letter_gap / 2;
  const std::string_view strokes = glyph(c);
  double width = 0;
  for (std::size_t i = 0; i < strokes.size(); i += strokes[i] == ' ' ? 1 : 2)
    if (strokes[i] != ' ') width = std::max(width, static_cast<double>(strokes[i] - '0'));
  return width;
}

void blend(Image& image, int x, int y, Colour colour, double opacity) {
  if (x < 0 || y < 0 || x >= image.width || y >= image.height || opacity <= 0) return;
  for (std::size_t c = 0; c < 3; ++c) {
    unsigned char& value = image.rgb[pixel_at(image, x, y) + c];
    value = static_cast<unsigned char>(std::lround(value + opacity * (colour[c] - value)));
  }
}

double distance_to_segment(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 ab = b - a;
  const double length2 = ab.squaredNorm();
  const double t = length2 > 0 ? std::clamp((p - a).dot(ab) / length2, 0.0, 1.0) : 0.0;
  return (p - a - t * ab).norm();
}

// The strokes of a glyph as segments, in pixels.
std::vector<std::array<Vec2, 2>> segments(char c, const Vec2& top_left, double unit) {
  const std::string_view strokes = glyph(c);
  std::vector<std::array<Vec2, 2>> result;
  bool starts = true;
  Vec2 last = Vec2::Zero();
  for (std::size_t i = 0; i < strokes.size();) {
    if (strokes[i] == ' ') {
      starts = true;
      ++i;
      continue;
    }
    const Vec2 point = top_left + unit * Vec2(strokes[i] - '0', 8 - (strokes[i + 1] - '0'));
    const bool dot = starts && (i + 2 == strokes.size() || strokes[i + 2] == ' ');
    if (!starts || dot) result.push_back({starts ? point : last, point});
    last = point;
    starts = false;
    i += 2;
  }
  return result;
}

// A pixel takes as much ink as the stroke covers of it. The nearest stroke counts, not the sum, so
// that crossings are not darker.
void draw_glyph(Image& image, char c, const Vec2& top_left, double height, Colour colour) {
  const double unit = height / capital, half_stroke = std::max(0.5, 0.055 * height);
  const std::vector<std::array<Vec2, 2>> strokes = segments(c, top_left, unit);
  if (strokes.empty()) return;
  const int x0 = static_cast<int>(std::floor(top_left.x() - half_stroke - 1));
  const int x1 = static_cast<int>(std::ceil(top_left.x() + 6 * unit + half_stroke + 1));
  const int y0 = static_cast<int>(std::floor(top_left.y() - unit - half_stroke - 1));
  const int y1 = static_cast<int>(std::ceil(top_left.y() + 8 * unit + half_stroke + 1));
  for (int y = y0; y <= y1; ++y)
    for (int x = x0; x <= x1; ++x) {
      double distance = 1e9;
      for (const auto& [a, b] : strokes) {
        const double dot = a == b ? 0.5 * half_stroke : 0;  // a dot is thicker than a line
        distance = std::min(distance, distance_to_segment(Vec2(x + 0.5, y + 0.5), a, b) - dot);
      }
      blend(image, x, y, colour, std::clamp(half_stroke + 0.5 - distance, 0.0, 1.0));
    }
}

// Lettering follows the height of the picture, but stays readable in small ones.
double text_scale(const Image& image) {
  return std::max(image.height / 720.0, 0.62);
}

// A line that would leave the picture is written smaller.
void draw_line(Image& image, double x, double y, double height, std::string_view text,
               Colour colour) {
  const double width = text_width(height, text), room = image.width - 2 * x;
  if (width > room) height *= std::max(room, 1.0) / width;
  draw_text(image, x, y, height, text, colour);
}

void fill(Image& image, double left, double top, double right, double bottom, Colour colour,
          double opacity) {
  for (int y = static_cast<int>(std::lround(top)); y < std::lround(bottom); ++y)
    for (int x = static_cast<int>(std::lround(left)); x < std::lround(right); ++x)
      blend(image, x, y, colour, opacity);
}

// Enough decimals that quarters of the scale differ.
std::string percent(double strain, double scale) {
  const int decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(scale))), 1, 9);
  return text("%.*f%%", decimals, 100 * strain);
}

}  // namespace

void draw_text(Image& image, double x, double y, double height, std::string_view text,
               Colour colour) {
  const double unit = height / capital;
  for (const char c : text) {
    draw_glyph(image, c, Vec2(x, y), height, colour);
    x += unit * (glyph_width(c) + letter_gap);
  }
}

double text_width(double height, std::string_view text) {
  double units = text.empty() ? 0 : -letter_gap;
  for (const char c : text) units += glyph_width(c) + letter_gap;
  return units * height / capital;
}

void draw_caption(Image& image, std::string_view title, std::string_view line) {
  const double s = text_scale(image);
  draw_line(image, 27 * s, 27 * s, 19 * s, title, ink);
  draw_line(image, 27 * s, 61 * s, 12.5 * s, line, pale_ink);
}

void draw_legend(Image& image, double strain_scale) {
  constexpr int ticks = 5;
  const double s = text_scale(image), text = 10.5 * s;
  const double label = text_width(text, percent(strain_scale, strain_scale));
  const double right = image.width - 18 * s, left = right - 50 * s - label;
  const double bar_left = left + 16 * s, bar_right = bar_left + 16 * s;
  const double bar_height = std::min(260 * s, 0.6 * image.height);
  const double top = 0.5 * (image.height - bar_height) - 30 * s, bar_top = std::round(top + 46 * s);

  fill(image, left, top, right, bar_top + bar_height + 22 * s, {255, 255, 255}, 0.45);
  draw_text(image, left + 14 * s, top + 15 * s, 12 * s, "strain", ink);
  const int rows = static_cast<int>(std::lround(bar_height));
  for (int row = 0; row < rows; ++row)
    fill(image, bar_left, bar_top + row, bar_right, bar_top + row + 1,
         viridis(1 - (row + 0.5) / rows), 1);
  for (int i = 0; i < ticks; ++i) {
    const double part = static_cast<double>(i) / (ticks - 1);
    const double y = bar_top + (1 - part) * rows;
    fill(image, bar_right, std::round(y), bar_right + 5 * s, std::round(y) + 1, ink, 1);
    draw_text(image, bar_right + 9 * s, y - text / 2, text,
              percent(part * strain_scale, strain_scale), ink);
  }
}
