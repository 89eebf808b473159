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

// The bytes of a PNG file. Level of compression: 9 gives the fewest bytes; 3 takes half the time of 6 and a fifth
// more bytes. Throws std::invalid_argument for an image without pixels.
std::string encode_png(const Image& image, const PngText& text = {}, int level = 3);

// Throws CannotWrite (text/whole_file.h); then nothing is left behind.
void write_png(const std::filesystem::path& path, const std::string& bytes);
void write_png(const std::filesystem::path& path, const Image& image, const PngText& text = {});

Image read_png(const std::filesystem::path& path);
PngText read_png_text(const std::filesystem::path& path);
