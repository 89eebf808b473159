// PNG files, written whole or not at all.
#pragma once
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "picture/image.h"

// What a picture says about itself (tEXt chunks): key, text. Never a date: on one machine, the same
// run must write the same bytes on every day.
using PngText = std::vector<std::pair<std::string, std::string>>;

// Throws CannotWrite (text/whole_file.h); then nothing is left behind.
void write_png(const std::filesystem::path& path, const Image& image, const PngText& text = {});

Image read_png(const std::filesystem::path& path);
PngText read_png_text(const std::filesystem::path& path);
