#include "program/pictures.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "picture/film.h"
#include "picture/overlay.h"
#include "program/diagnostics.h"
#include "program/stage.h"
#include "text/text.h"

namespace {

constexpr int film_parts = 12;          // into which the film divides a run, at most
constexpr int longest_row_of_film = 5;  // pictures
constexpr Colour ink = {70, 78, 92};
constexpr std::array frame_size = {640, 360};
constexpr int longest_side_of_motion = 480;  // pixels

Surface surface_of(const Scene& scene, double size) {
  Surface surface;
  surface.faces = scene.mesh.faces;
  surface.texture = scene.mesh.rest;
  surface.checker = size / 10;
  for (const Pin& pin : scene.cloth.pins) surface.pins.push_back(pin.vertex);
  return surface;
}

// The size of a frame, made smaller so that no side is too long.
std::array<int, 2> motion_size(std::array<int, 2> size) {
  const double scale = std::min(1.0, double(longest_side_of_motion) / std::max(size[0], size[1]));
  for (int& side : size) side = std::max(1, int(std::lround(scale * side)));
  return size;
}

int rounded_up(int number, int divisor) {
  return (number + divisor - 1) / divisor;
}

}  // namespace

Pictures::Pictures(const Options& options_, const Scene& scene_)
    : options(options_), scene(scene_), stage(make_stage(scene_)),
      renderer(surface_of(scene_, stage.size)) {
  if (options.motion) motion.emplace(scene.time);
}

Image Pictures::draw(const VecX& x, double time, int width, int height) const {
  Style style;
  style.width = width;
  style.height = height;
  style.wireframe = options.wireframe;
  style.strain_scale = options.strain_scale;
  Image image =
      renderer.draw(stage, x, style, options.strain_scale ? vertex_strain(scene.mesh, x) : VecX());
  if (options.strain_scale) draw_legend(image, *options.strain_scale);
  if (options.caption)
    draw_caption(image, options.program,
                 scene.name() + text("  h = %.6g s  t = %.3f s", scene.time.h, time));
  return image;
}

// The time in the lower left, unless the caption has it.
void Pictures::draw_time(Image& image, double time) const {
  if (options.caption) return;
  const double height = image.height;
  draw_text(image, 0.03 * image.width, 0.92 * height, 0.05 * height, text("%.3f s", time), ink);
}

// How a frame was made. Without date and machine, so that equal runs give equal bytes.
PngText Pictures::about(double time) const {
  return {{"Software", "Large Steps, " + options.program},
          {"Scene", scene.name()},
          {"TimeStep", text("%.6g s", scene.time.h)},
          {"Time", text("%.6g s", time)}};
}

// The film shows frame 0 and then each s-th frame, with the smallest s that divides the run into at
// most 12 parts. Whatever frame comes last is on it, too, and so is the end of a run that broke off.
bool Pictures::on_film(int number) const {
  return number % rounded_up(scene.time.frames, film_parts) == 0;
}

void Pictures::frame(int number, const VecX& x, double time) {
  const auto [width, height] = options.size.value_or(frame_size);
  Image image = draw(x, time, width, height);
  write_png(options.out / text("frame_%04d.png", number), image, about(time));
  draw_time(image, time);
  film_end = time;
  if (!last_is_kept) strip.pop_back();
  strip.push_back(std::move(image));
  last_is_kept = on_film(number);
}

void Pictures::still(const VecX& x, double time) {
  const auto [width, height] = options.size.value_or(std::array{1280, 720});
  write_png(options.out / "still.png", draw(x, time, width, height), about(time));
}

void Pictures::film() {
  if (strip.empty()) return;
  const int pictures = int(strip.size());
  const int rows = rounded_up(pictures, longest_row_of_film);
  write_png(options.out / "film.png", film_strip(strip, rounded_up(pictures, rows)),
            about(film_end));
  if (has_motion())
    write_png(options.out / "motion.png", encode_animation(motion->frames(), about(motion_end)));
}

void Pictures::add_to_motion(const VecX& x, double time) {
  const auto [width, height] = motion_size(options.size.value_or(frame_size));
  Image image = draw(x, time, width, height);
  draw_time(image, time);
  motion->add(std::move(image));
  motion_end = time;
}
