// The cloth that the frame tests draw: hung by two corners, given by a formula.
#pragma once
#include <cmath>

#include "picture/renderer.h"

struct TestScene {
  Surface surface;
  VecX x, strain;
  Stage stage{Vec3(0.75, 1.35, 2.35), Vec3(0.05, 0.75, 0), 0, 1};
  Style style{.width = 320, .height = 180, .supersampling = 2};
};

inline TestScene hung_cloth(int cells = 24) {
  TestScene scene;
  const int side = cells + 1;
  scene.x.resize(3 * side * side);
  scene.strain.resize(side * side);
  for (int j = 0; j < side; ++j)
    for (int i = 0; i < side; ++i) {
      const int k = j * side + i;
      const double u = static_cast<double>(i) / cells, v = static_cast<double>(j) / cells;
      const double sag = 1.2 * u * (1 - u) * v;
      scene.x.segment<3>(3 * k) =
          Vec3(0.9 * (u - 0.5), 0.4 + v - sag, 0.08 * std::sin(9 * u + 3 * v) * (1 - v));
      scene.strain[k] = 0.1 * u;
    }
  const auto place = [&](int k) {
    return Vec2(static_cast<double>(k % side) / cells, static_cast<double>(k / side) / cells);
  };
  const auto add_face = [&](int a, int b, int c) {
    scene.surface.faces.push_back({a, b, c});
    scene.surface.texture.push_back({place(a), place(b), place(c)});
  };
  for (int j = 0; j < cells; ++j)
    for (int i = 0; i < cells; ++i) {
      const int k = j * side + i;
      add_face(k, k + 1, k + side);
      add_face(k + 1, k + side + 1, k + side);
    }
  scene.surface.pins = {cells * side, cells * side + cells};
  return scene;
}

inline Colour pixel(const Image& image, int x, int y) {
  const std::size_t at = pixel_at(image, x, y);
  return {image.rgb[at], image.rgb[at + 1], image.rgb[at + 2]};
}
