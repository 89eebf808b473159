// The parts of a PNG file: a signature of 8 bytes, then chunks.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

inline constexpr std::string_view png_signature = "\x89PNG\r\n\x1a\n";

struct PngChunk {
  std::string_view type, content;  // type: four letters
};

// The chunks of a file; they point into `bytes`. Checksums are not compared. Throws std::runtime_error for bytes
// that are no PNG, or that end within a chunk.
std::vector<PngChunk> png_chunks(std::string_view bytes);

// Appends length (4 bytes), type (4), content, and their checksum (4).
void append_png_chunk(std::string& file, std::string_view type, std::string_view content);

// Numbers in a PNG have their highest byte first.
std::string big_endian(long number, int bytes = 4);
std::uint32_t from_big_endian(std::string_view bytes);
