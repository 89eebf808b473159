#include "picture/animation.h"

#include <stdexcept>

#include "picture/png_chunks.h"

namespace {

constexpr int smallest = 9;  // level of compression: a film is written once, and loaded often

void check(const std::vector<AnimationFrame>& frames) {
  if (frames.empty()) throw std::invalid_argument("animation: there are no frames");
  for (const AnimationFrame& frame : frames)
    if (frame.image.width != frames[0].image.width || frame.image.height != frames[0].image.height)
      throw std::invalid_argument("animation: all frames must be of one size");
}

// All chunks before the pixels: size, colour space and text.
void append_head(std::string& file, const std::string& png) {
  for (const PngChunk& chunk : png_chunks(png)) {
    if (chunk.type == "IDAT") return;
    append_png_chunk(file, chunk.type, chunk.content);
  }
}

std::string pixels(const std::string& png) {
  std::string data;
  for (const PngChunk& chunk : png_chunks(png))
    if (chunk.type == "IDAT") data += chunk.content;
  return data;
}

// fcTL: number of the chunk, width, height, x, y, seconds as a fraction. The frame replaces the one before.
std::string frame_control(long number, const AnimationFrame& frame) {
  const std::string keep = big_endian(0, 1), replace = big_endian(0, 1);
  return big_endian(number) + big_endian(frame.image.width) + big_endian(frame.image.height) +
         big_endian(0) + big_endian(0) + big_endian(frame.milliseconds, 2) + big_endian(1000, 2) +
         keep + replace;
}

}  // namespace

// The pixels of the first frame are in IDAT, as in every PNG; those of the others in fdAT, which begins with a
// number. One count numbers all fcTL and fdAT.
std::string encode_animation(const std::vector<AnimationFrame>& frames, const PngText& text) {
  check(frames);
  std::string file(png_signature);
  long number = 0;
  for (const AnimationFrame& frame : frames) {
    const bool is_first = number == 0;
    const std::string png = encode_png(frame.image, text, smallest);
    if (is_first) {
      append_head(file, png);
      const std::string for_ever = big_endian(0);
      append_png_chunk(file, "acTL", big_endian(frames.size()) + for_ever);
    }
    append_png_chunk(file, "fcTL", frame_control(number++, frame));
    if (is_first)
      append_png_chunk(file, "IDAT", pixels(png));
    else
      append_png_chunk(file, "fdAT", big_endian(number++) + pixels(png));
  }
  append_png_chunk(file, "IEND", "");
  return file;
}
