#include "scene/scene_file.h"
#include "text/text.h"

namespace {

const std::string fix_words =
    "letters of x, y and z, each at most once, like \"y\" or \"xz\", or the three numbers of one "
    "direction that is not zero, like [0, 1, 1]";

// I − Σ d dᵀ over the axes d that the letters name.
Mat3 without_axes(const TomlTable& pin, const std::string& letters) {
  Mat3 S = Mat3::Identity();
  for (const char letter : letters) {
    const int axis = letter - 'x';
    if (axis < 0 || axis > 2 || S(axis, axis) == 0) pin.refuse("fix", "it must be " + fix_words);
    S(axis, axis) = 0;
  }
  if (letters.empty()) pin.refuse("fix", "it must be " + fix_words);
  return S;
}

Mat3 without_direction(const TomlTable& pin) {
  const Vec3 given = pin.three_numbers("fix", fix_words);
  if (given.isZero(0)) pin.refuse("fix", "it must be " + fix_words);
  const Vec3 p = given.stableNormalized();
  return Mat3::Identity() - p * p.transpose();
}

Mat3 read_filter(const TomlTable& pin) {
  if (!pin.has("fix")) return Mat3::Zero();
  const std::optional<std::string> letters = pin.text("fix");
  return letters ? without_axes(pin, *letters) : without_direction(pin);
}

// Only the part in the held directions. The rest must be rounding: 1e-6 of the velocity.
Vec3 read_velocity(const TomlTable& pin, const Mat3& S) {
  if (!pin.has("velocity")) return Vec3::Zero();
  const Vec3 velocity = pin.three_numbers("velocity"), held = velocity - S * velocity;
  if ((velocity - held).stableNorm() > 1e-6 * velocity.stableNorm())
    pin.refuse("velocity",
               "it must lie in the directions that the pin fixes; the part that does is " +
                   text("[%.6g, %.6g, %.6g]", held[0], held[1], held[2]));
  return held;
}

}  // namespace

Pin read_pin(const TomlTable& table, int vertex) {
  const Mat3 S = read_filter(table);
  return {vertex, S, read_velocity(table, S)};
}
