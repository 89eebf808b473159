// Reads an animated PNG as the specification says, and fails the test where it breaks a rule.
#pragma once
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "picture/animation.h"
#include "picture/png_chunks.h"

// The checksum of PNG, bit by bit: the polynomial x³² + x²⁶ + x²³ + …, bits reversed.
inline std::uint32_t checksum_of(std::string_view bytes) {
  std::uint32_t rest = 0xffffffff;
  for (const char byte : bytes) {
    rest ^= static_cast<unsigned char>(byte);
    for (int bit = 0; bit < 8; ++bit) rest = rest & 1 ? rest >> 1 ^ 0xedb88320 : rest >> 1;
  }
  return ~rest;
}

inline void expect_right_checksums(const std::vector<PngChunk>& chunks) {
  for (const PngChunk& chunk : chunks) {
    const std::string_view covered(chunk.type.data(), 4 + chunk.content.size());
    EXPECT_EQ(from_big_endian({covered.data() + covered.size(), 4}), checksum_of(covered))
        << chunk.type;
  }
}

// The picture of one frame: a PNG of the same head, whose IDAT has the frame's data.
inline Image decoded(const PngChunk& head, std::string_view data) {
  std::string png(png_signature);
  append_png_chunk(png, head.type, head.content);
  append_png_chunk(png, "IDAT", data);
  append_png_chunk(png, "IEND", "");
  std::string path = (std::filesystem::temp_directory_path() / "frame_XXXXXX").string();
  close(mkstemp(path.data()));
  std::ofstream(path, std::ios::binary) << png;
  Image image = read_png(path);
  std::filesystem::remove(path);
  return image;
}

inline std::vector<AnimationFrame> read_animation(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  const std::vector<PngChunk> chunks = png_chunks(bytes);
  expect_right_checksums(chunks);
  EXPECT_EQ(chunks.front().type, "IHDR");
  EXPECT_EQ(chunks.back().type, "IEND");

  std::vector<AnimationFrame> frames;
  std::uint32_t number = 0, promised = 0;
  int milliseconds = -1;  // of the fcTL that waits for its data
  for (const PngChunk& chunk : chunks) {
    if (chunk.type == "acTL") {
      EXPECT_TRUE(frames.empty() && milliseconds == -1) << "acTL comes first";
      promised = from_big_endian(chunk.content.substr(0, 4));
      EXPECT_EQ(from_big_endian(chunk.content.substr(4)), 0u) << "it plays for ever";
    } else if (chunk.type == "fcTL") {
      EXPECT_EQ(milliseconds, -1) << "two fcTL without data between";
      EXPECT_EQ(from_big_endian(chunk.content.substr(0, 4)), number++);
      EXPECT_EQ(chunk.content.substr(4, 8), chunks[0].content.substr(0, 8)) << "width, height";
      EXPECT_EQ(chunk.content.substr(12, 8), std::string(8, '\0')) << "x, y";
      milliseconds = static_cast<int>(from_big_endian(chunk.content.substr(20, 2)));
      EXPECT_EQ(from_big_endian(chunk.content.substr(22, 2)), 1000u);
      EXPECT_EQ(chunk.content.substr(24), std::string(2, '\0'))
          << "a frame replaces the one before";
    } else if (chunk.type == "IDAT" || chunk.type == "fdAT") {
      EXPECT_EQ(chunk.type == "IDAT", frames.empty()) << "the first frame is the default image";
      EXPECT_NE(milliseconds, -1) << "data without fcTL";
      const bool numbered = chunk.type == "fdAT";
      if (numbered) {
        EXPECT_EQ(from_big_endian(chunk.content.substr(0, 4)), number++);
      }
      frames.push_back({decoded(chunks[0], chunk.content.substr(numbered ? 4 : 0)), milliseconds});
      milliseconds = -1;
    }
  }
  EXPECT_EQ(frames.size(), promised);
  return frames;
}
