#include "contact_sheet.h"

#include <algorithm>

#include "picture/compare.h"
#include "picture/overlay.h"
#include "picture/reduce.h"

namespace {

// Pixels.
constexpr int sheet_width = 1290, gap = 6, heading_height = 26, label_height = 28;
constexpr double letters = 11;
constexpr Colour paper = {255, 255, 255}, ink = {26, 30, 40}, pale_ink = {104, 112, 126},
                 empty = {236, 238, 241};

struct Size {
  int width, height;
};

Size fitted(const Image& image, int width) {
  if (image.width <= width) return {image.width, image.height};
  return {width, std::max(1, int(long(image.height) * width / image.width))};
}

int width_of_a_picture(int columns) {
  return std::max(1, sheet_width / columns - gap);
}

// A line that is too long is written smaller.
void draw_line(Image& image, int left, int top, int room, const std::string& line, Colour colour) {
  const double width = text_width(letters, line);
  const double height = width > room ? letters * room / width : letters;
  draw_text(image, left, top, height, line, colour);
}

// All pictures of the sheet, at the size in which they are shown.
std::vector<SheetRow> reduced(std::vector<SheetRow> rows, int width) {
  for (SheetRow& row : rows)
    for (std::optional<Image>& picture : row.pictures)
      if (picture) {
        const Size size = fitted(*picture, width);
        picture = box_reduce(*picture, size.width, size.height);
      }
  return rows;
}

Size largest(const std::vector<SheetRow>& rows) {
  Size most = {160, 90};  // room for the words of an empty place
  for (const SheetRow& row : rows)
    for (const std::optional<Image>& picture : row.pictures)
      if (picture)
        most = {std::max(most.width, picture->width), std::max(most.height, picture->height)};
  return most;
}

}  // namespace

Image contact_sheet(const std::vector<std::string>& headings, const std::vector<SheetRow>& rows) {
  const int columns = std::max(1, int(headings.size()));
  const std::vector<SheetRow> small = reduced(rows, width_of_a_picture(columns));
  const Size place = largest(small);
  const int column = place.width + gap, row = label_height + place.height + gap;
  Image sheet =
      filled_image(gap + columns * column, heading_height + int(rows.size()) * row, paper);
  for (size_t c = 0; c < headings.size(); ++c)
    draw_line(sheet, gap + int(c) * column, 10, place.width, headings[c], pale_ink);
  for (size_t r = 0; r < small.size(); ++r) {
    const int top = heading_height + int(r) * row;
    draw_line(sheet, gap, top + 9, sheet.width - 2 * gap, small[r].label, ink);
    for (size_t c = 0; c < small[r].pictures.size(); ++c) {
      const int left = gap + int(c) * column;
      const std::optional<Image>& picture = small[r].pictures[c];
      paste(picture ? *picture : filled_image(place.width, place.height, empty), left,
            top + label_height, sheet);
      if (!picture)
        draw_line(sheet, left + 12, top + label_height + 12, place.width - 24, "no picture",
                  pale_ink);
    }
  }
  return sheet;
}

Image small_difference(const Image& a, const Image& b, int columns) {
  const Size size = fitted(a, width_of_a_picture(columns));
  Image small_a = filled_image(size.width, size.height, paper), small_b = small_a;
  std::vector<int> most(pixel_count(small_a), -1);
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x) {
      const size_t from = pixel_at(a, x, y);
      const size_t to = pixel_at(small_a, int(long(x) * size.width / a.width),
                                 int(long(y) * size.height / a.height));
      const int difference = pixel_difference(&a.rgb[from], &b.rgb[from]);
      if (difference <= most[to / 3]) continue;
      most[to / 3] = difference;
      std::copy_n(&a.rgb[from], 3, &small_a.rgb[to]);
      std::copy_n(&b.rgb[from], 3, &small_b.rgb[to]);
    }
  return difference_picture(small_a, small_b);
}
