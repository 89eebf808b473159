#include "picture/png_chunks.h"

#include <zlib.h>

#include <stdexcept>

std::string big_endian(long number, int bytes) {
  std::string text;
  for (int i = bytes - 1; i >= 0; --i) text += static_cast<char>(number >> 8 * i & 255);
  return text;
}

std::uint32_t from_big_endian(std::string_view bytes) {
  std::uint32_t number = 0;
  for (const char byte : bytes) number = number << 8 | static_cast<unsigned char>(byte);
  return number;
}

std::vector<PngChunk> png_chunks(std::string_view bytes) {
  if (!bytes.starts_with(png_signature)) throw std::runtime_error("not a PNG file");
  std::vector<PngChunk> chunks;
  for (std::size_t at = png_signature.size(); at + 12 <= bytes.size();) {
    const std::size_t length = from_big_endian(bytes.substr(at, 4));
    if (length > bytes.size() - at - 12) throw std::runtime_error("the file is cut short");
    chunks.push_back({bytes.substr(at + 4, 4), bytes.substr(at + 8, length)});
    at += length + 12;
  }
  return chunks;
}

// The checksum is that of type and content.
void append_png_chunk(std::string& file, std::string_view type, std::string_view content) {
  file += big_endian(static_cast<long>(content.size()));
  const std::size_t begin = file.size();
  file.append(type).append(content);
  const auto* const bytes = reinterpret_cast<const unsigned char*>(file.data() + begin);
  file += big_endian(static_cast<long>(crc32_z(0, bytes, file.size() - begin)));
}
