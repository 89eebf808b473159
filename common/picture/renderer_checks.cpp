#include "picture/renderer_checks.h"

#include <cmath>
#include <stdexcept>
#include <string>

namespace {

constexpr int largest_side_anywhere = 16384;  // Mesa's limit, pixels
constexpr int usual_supersampling = 3;

[[noreturn]] void refuse(const std::string& reason) {
  throw std::invalid_argument(reason);
}

std::string size_text(int width, int height) {
  return std::to_string(width) + "x" + std::to_string(height);
}

void check_side_lengths(int width, int height, int largest) {
  if (width < 1 || height < 1 || width > largest || height > largest)
    refuse("a size of " + size_text(width, height) +
           " is not possible: width and height must be 1 to " + std::to_string(largest));
}

void check_index(int i, Eigen::Index vertices, const std::string& what) {
  if (i < 0 || i >= vertices)
    refuse(what + " names vertex " + std::to_string(i) + ", but there are " +
           std::to_string(vertices) + " vertices");
}

}  // namespace

void check_size(int width, int height) {
  check_side_lengths(width, height, largest_side_anywhere / usual_supersampling);
}

void check_surface(const Surface& surface) {
  if (surface.texture.size() != surface.faces.size())
    refuse(std::to_string(surface.faces.size()) + " faces, but texture for " +
           std::to_string(surface.texture.size()));
  if (!(surface.checker > 0)) refuse("the checker's squares must be larger than 0");
}

void check_stage(const Stage& stage) {
  if (!stage.eye.allFinite() || !stage.target.allFinite() || !std::isfinite(stage.ground) ||
      !std::isfinite(stage.size))
    refuse("eye, target, ground and size must be finite");
  if (!(stage.size > 0)) refuse("the size of the scene must be larger than 0");
  if ((stage.eye - stage.target).norm() == 0) refuse("eye and target are the same point");
}

void check_style(const Style& style, int largest_side) {
  if (style.supersampling < 1 || style.supersampling > largest_side)
    refuse("supersampling must be 1 to " + std::to_string(largest_side) + ", not " +
           std::to_string(style.supersampling));
  check_side_lengths(style.width, style.height, largest_side / style.supersampling);
  if (style.strain_scale && !(*style.strain_scale > 0 && std::isfinite(*style.strain_scale)))
    refuse("the strain scale must be larger than 0");
}

void check_vertices(const Surface& surface, const VecX& x) {
  if (x.size() % 3 != 0) refuse(std::to_string(x.size()) + " coordinates are not three per vertex");
  for (Eigen::Index i = 0; i < x.size() / 3; ++i)
    if (!x.segment<3>(3 * i).allFinite()) refuse("vertex " + std::to_string(i) + " is not finite");
  for (std::size_t f = 0; f < surface.faces.size(); ++f)
    for (const int i : surface.faces[f]) check_index(i, x.size() / 3, "face " + std::to_string(f));
  for (const int i : surface.pins) check_index(i, x.size() / 3, "a pin");
}

void check_strain(const VecX& strain, const VecX& x) {
  if (3 * strain.size() != x.size())
    refuse(std::to_string(strain.size()) + " strains for " + std::to_string(x.size() / 3) +
           " vertices");
  for (Eigen::Index i = 0; i < strain.size(); ++i)
    if (!std::isfinite(strain[i]))
      refuse("the strain of vertex " + std::to_string(i) + " is not finite");
}
