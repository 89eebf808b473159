#include "picture/film.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "picture/reduce.h"

namespace {

constexpr int sheet_width = 1290, gap = 4, margin = gap / 2;  // pixels

void require_one_size(const std::vector<Image>& frames) {
  for (std::size_t k = 0; k < frames.size(); ++k)
    if (frames[k].width != frames[0].width || frames[k].height != frames[0].height)
      throw std::invalid_argument(
          "film: frame " + std::to_string(k) + " is " + std::to_string(frames[k].width) + "x" +
          std::to_string(frames[k].height) + ", frame 0 is " + std::to_string(frames[0].width) +
          "x" + std::to_string(frames[0].height));
}

}  // namespace

Image film_strip(const std::vector<Image>& frames, int columns) {
  if (frames.empty()) throw std::invalid_argument("film: there are no frames");
  if (columns < 1) throw std::invalid_argument("film: columns must be at least 1");
  require_one_size(frames);

  const int count = static_cast<int>(frames.size());
  columns = std::min(columns, count);
  const int rows = (count + columns - 1) / columns;
  const int width = std::clamp(sheet_width / columns - gap, 1, frames[0].width);
  const int height = std::max(
      1, static_cast<int>((static_cast<long>(width) * frames[0].height + frames[0].width / 2) /
                          frames[0].width));

  Image sheet = filled_image(columns * (width + gap), rows * (height + gap), {255, 255, 255});
  for (int k = 0; k < count; ++k)
    paste(box_reduce(frames[static_cast<std::size_t>(k)], width, height),
          margin + k % columns * (width + gap), margin + k / columns * (height + gap), sheet);
  return sheet;
}
