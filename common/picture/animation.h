// An animated PNG (APNG): a picture that moves in a browser. A reader that knows only plain PNG shows its first
// frame.
#pragma once
#include <string>
#include <vector>

#include "picture/png.h"

struct AnimationFrame {
  Image image;
  int milliseconds;  // how long it is shown, at most 65535
};

// The bytes of the file, for write_png. It plays for ever. Throws std::invalid_argument if there is no frame or if
// they differ in size.
std::string encode_animation(const std::vector<AnimationFrame>& frames, const PngText& text = {});
