// Draws the test scene three ways with the backend it is linked to and writes the bytes of the
// pictures to the file named on the command line.
#include <cstdio>
#include <exception>
#include <fstream>

#include "test_scene.h"

int main(int argc, char** argv) try {
  if (argc != 2) return 2;
  TestScene scene = hung_cloth();
  Renderer renderer(scene.surface);
  std::ofstream file(argv[1], std::ios::binary);
  const auto write = [&](const Style& style) {
    const Image image = renderer.draw(scene.stage, scene.x, style, scene.strain);
    file.write(reinterpret_cast<const char*>(image.rgb.data()),
               static_cast<std::streamsize>(image.rgb.size()));
  };
  Style style = scene.style;
  write(style);
  style.wireframe = true;
  write(style);
  style.strain_scale = 0.1;
  write(style);
  std::printf("%s\n", renderer.description().c_str());
  return file.flush() ? 0 : 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "backend_frames: %s\n", error.what());
  return 1;
}
