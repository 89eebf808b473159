#include <png.h>

#include <csetjmp>
#include <cstdio>
#include <new>
#include <stdexcept>

#include "picture/png.h"
#include "text/whole_file.h"

namespace {

// libpng reports an error by calling on_error, which must not return.
using Message = char[200];

void on_error(png_structp png, const char* reason) {
  std::snprintf(static_cast<char*>(png_get_error_ptr(png)), sizeof(Message), "%s", reason);
  png_longjmp(png, 1);
}

void on_warning(png_structp, const char*) {}

// libpng is a C library: no exception may pass through it.
bool append(std::string& file, const png_byte* bytes, std::size_t count) {
  try {
    file.append(reinterpret_cast<const char*>(bytes), count);
    return true;
  } catch (const std::bad_alloc&) {
    return false;
  }
}

void write_bytes(png_structp png, png_bytep bytes, std::size_t count) {
  if (!append(*static_cast<std::string*>(png_get_io_ptr(png)), bytes, count))
    png_error(png, "out of memory");
}

void flush_bytes(png_structp) {}

std::vector<png_text> text_chunks(const PngText& text) {
  std::vector<png_text> chunks(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    chunks[i].compression = PNG_TEXT_COMPRESSION_NONE;
    chunks[i].key = const_cast<char*>(text[i].first.c_str());
    chunks[i].text = const_cast<char*>(text[i].second.c_str());
    chunks[i].text_length = text[i].second.size();
  }
  return chunks;
}

// An error in libpng jumps back to setjmp and skips destructors: this function makes no objects
// that have one.
bool write_chunks(png_structp png, png_infop info, const Image& image,
                  const std::vector<png_text>& text, int level) {
  if (setjmp(png_jmpbuf(png))) return false;
  png_set_IHDR(png, info, static_cast<png_uint_32>(image.width),
               static_cast<png_uint_32>(image.height), 8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
  png_set_text(png, info, text.data(), static_cast<int>(text.size()));
  png_set_compression_level(png, level);
  png_write_info(png, info);
  for (int y = 0; y < image.height; ++y) png_write_row(png, &image.rgb[pixel_at(image, 0, y)]);
  png_write_end(png, info);
  return true;
}

void require_regular(const std::filesystem::path& path) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
    throw CannotWrite(path, "it exists and is not a regular file");
}

}  // namespace

std::string encode_png(const Image& image, const PngText& text, int level) {
  if (image.width < 1 || image.height < 1 || image.rgb.size() != 3 * pixel_count(image))
    throw std::invalid_argument("the image is empty or its size does not fit its pixels");
  Message message = "out of memory";
  std::string file;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, message, on_error, on_warning);
  if (png == nullptr) throw std::runtime_error(message);
  png_infop info = png_create_info_struct(png);
  png_set_write_fn(png, &file, write_bytes, flush_bytes);
  const bool written = info != nullptr && write_chunks(png, info, image, text_chunks(text), level);
  png_destroy_write_struct(&png, &info);
  if (!written) throw std::runtime_error(message);
  return file;
}

void write_png(const std::filesystem::path& path, const std::string& bytes) {
  require_regular(path);
  WholeFile file(path);
  file.write(bytes);
  file.finish();
}

void write_png(const std::filesystem::path& path, const Image& image, const PngText& text) {
  write_png(path, encode_png(image, text));
}
