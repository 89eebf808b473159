#include <png.h>

#include <cstdint>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "picture/png.h"

namespace {

struct CannotRead : std::runtime_error {
  CannotRead(const std::filesystem::path& path, const std::string& reason)
      : std::runtime_error("cannot read " + path.string() + ": " + reason) {}
};

std::string file_bytes(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  if (!file) throw CannotRead(path, "no such file, or not readable");
  return bytes;
}

std::size_t big_endian(const std::string& bytes, std::size_t at) {
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < 4; ++i)
    number = number << 8 | static_cast<unsigned char>(bytes[at + i]);
  return number;
}

}  // namespace

Image read_png(const std::filesystem::path& path) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  if (!png_image_begin_read_from_file(&png, path.c_str())) throw CannotRead(path, png.message);
  png.format = PNG_FORMAT_RGB;
  Image image = filled_image(static_cast<int>(png.width), static_cast<int>(png.height), {0, 0, 0});
  const png_color white{255, 255, 255};  // behind transparent pixels
  if (!png_image_finish_read(&png, &white, image.rgb.data(), 0, nullptr))
    throw CannotRead(path, png.message);
  return image;
}

// A PNG is 8 bytes of signature, then chunks: length (4 bytes), type (4), content, checksum (4).
// The content of a tEXt chunk is key, zero byte, text.
PngText read_png_text(const std::filesystem::path& path) {
  const std::string bytes = file_bytes(path);
  if (bytes.compare(0, 8, "\x89PNG\r\n\x1a\n") != 0) throw CannotRead(path, "not a PNG file");
  PngText text;
  for (std::size_t at = 8; at + 12 <= bytes.size();) {
    const std::size_t length = big_endian(bytes, at);
    if (length > bytes.size() - at - 12) throw CannotRead(path, "the file is cut short");
    const std::string content = bytes.substr(at + 8, length);
    const std::size_t zero = content.find('\0');
    if (bytes.compare(at + 4, 4, "tEXt") == 0 && zero != std::string::npos)
      text.emplace_back(content.substr(0, zero), content.substr(zero + 1));
    at += length + 12;
  }
  return text;
}
