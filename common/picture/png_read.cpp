#include <png.h>

#include <fstream>
#include <iterator>
#include <stdexcept>
#include <vector>

#include "picture/png.h"
#include "picture/png_chunks.h"
#include "text/text_file.h"

namespace {

struct CannotRead : std::runtime_error {
  CannotRead(const std::filesystem::path& path, const std::string& reason)
      : std::runtime_error("cannot read " + path.string() + ": " + reason) {}
};

std::string file_bytes(const std::filesystem::path& path) {
  if (const std::string reason = no_file(path); !reason.empty()) throw CannotRead(path, reason);
  std::ifstream file(path, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  if (!file) throw CannotRead(path, "it is not readable");
  return bytes;
}

std::vector<PngChunk> chunks_of(const std::filesystem::path& path, const std::string& bytes) {
  try {
    return png_chunks(bytes);
  } catch (const std::runtime_error& error) {
    throw CannotRead(path, error.what());
  }
}

// Deflate packs at most 1032 bytes into one, and a byte holds at most 8 pixels. The header of a damaged file can
// claim more.
bool can_hold(const std::string& bytes, const png_image& png) {
  return double(png.width) * double(png.height) <= 8. * 1032. * double(bytes.size());
}

}  // namespace

Image read_png(const std::filesystem::path& path) {
  const std::string bytes = file_bytes(path);
  chunks_of(path, bytes);  // libpng would allocate what a chunk claims
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  if (!png_image_begin_read_from_memory(&png, bytes.data(), bytes.size()))
    throw CannotRead(path, png.message);
  png.format = PNG_FORMAT_RGB;
  if (!can_hold(bytes, png)) {
    png_image_free(&png);
    throw CannotRead(path, "the header claims more pixels than the file can hold");
  }
  Image image = filled_image(static_cast<int>(png.width), static_cast<int>(png.height), {0, 0, 0});
  const png_color white{255, 255, 255};  // behind transparent pixels
  if (!png_image_finish_read(&png, &white, image.rgb.data(), 0, nullptr))
    throw CannotRead(path, png.message);
  return image;
}

// The content of a tEXt chunk is key, zero byte, text.
PngText read_png_text(const std::filesystem::path& path) {
  const std::string bytes = file_bytes(path);
  PngText text;
  for (const PngChunk& chunk : chunks_of(path, bytes)) {
    const std::size_t zero = chunk.content.find('\0');
    if (chunk.type == "tEXt" && zero != std::string::npos)
      text.emplace_back(chunk.content.substr(0, zero), chunk.content.substr(zero + 1));
  }
  return text;
}
