// Pictures in labelled rows under common headings.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "picture/image.h"

struct SheetRow {
  std::string label;
  std::vector<std::optional<Image>> pictures;  // one per column; a place without a picture says so
};

// One heading per column. The sheet is about 1290 pixels wide; pictures are never enlarged, and may have
// different sizes.
Image contact_sheet(const std::vector<std::string>& headings, const std::vector<SheetRow>& rows);

// Where two pictures of one size differ, as wide as a picture of the sheet is: difference_picture
// (picture/compare.h) of the pixels that differ most, so that a single one is still seen.
Image small_difference(const Image& a, const Image& b, int columns);
