// threshold_study DIRECTORY [OTHER]
// What tells another machine from another motion? Draws a cloth, and the same cloth with small changes, into
// DIRECTORY, and compares each picture with that of the unchanged cloth. OTHER is the DIRECTORY of another
// compiler, backend or release of Debian: each of its pictures is compared with the same one of DIRECTORY.
#include <cstdio>
#include <exception>
#include <filesystem>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "picture/compare.h"
#include "picture/png.h"
#include "test_scene.h"
#include "text/text.h"

namespace {

constexpr int cells = 40;

struct Change {
  std::string name;
  std::function<void(TestScene&)> make;
};

std::function<void(TestScene&)> move_vertex(int vertex, double metres) {
  return [=](TestScene& scene) { scene.x.segment<3>(3 * vertex) += Vec3(metres, metres, 0); };
}

std::function<void(TestScene&)> move_all(double metres) {
  return [=](TestScene& scene) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> by(-metres, metres);
    for (double& x : scene.x) x += by(random);
  };
}

std::vector<Change> changes() {
  const int inner = (cells / 2) * (cells + 1) + cells / 2, border = cells / 2;
  std::vector<Change> all = {{"none", [](TestScene&) {}}};
  for (const double metres : {1e-6, 1e-5, 1e-4})
    all.push_back({text("all vertices, at random by %.0e m", metres), move_all(metres)});
  for (const double metres : {1e-5, 1e-4, 1e-3}) {
    all.push_back({text("inner vertex by %.0e m", metres), move_vertex(inner, metres)});
    all.push_back({text("border vertex by %.0e m", metres), move_vertex(border, metres)});
  }
  for (const double metres : {1e-5, 1e-4, 1e-3})
    all.push_back(
        {text("camera by %.0e m", metres), [=](TestScene& s) { s.stage.eye.x() += metres; }});
  all.push_back({"a triangle is missing", [](TestScene& scene) {
                   const size_t middle = scene.surface.faces.size() / 2;
                   scene.surface.faces.erase(scene.surface.faces.begin() + long(middle));
                   scene.surface.texture.erase(scene.surface.texture.begin() + long(middle));
                 }});
  return all;
}

Image draw(const Change& change, int width) {
  TestScene scene = hung_cloth(cells);
  change.make(scene);
  scene.style.width = width;
  scene.style.height = width * 9 / 16;
  scene.style.supersampling = 3;
  return Renderer(scene.surface).draw(scene.stage, scene.x, scene.style, scene.strain);
}

constexpr const char* header =
    "| change | width | verdict | above 2 | densest window | rmse | largest |\n"
    "|---|---|---|---|---|---|---|\n";

void print(const std::string& name, int width, const Difference& d) {
  const std::string line = describe(d);
  std::printf("| %s | %d | %s | %ld | %d | %.3f | %d |\n", name.c_str(), width,
              line.substr(0, line.find(' ')).c_str(), d.above2, d.window, d.rmse, d.largest);
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc < 2 || argc > 3) {
    std::fprintf(stderr, "usage: threshold_study DIRECTORY [OTHER]\n");
    return 2;
  }
  const std::filesystem::path directory = argv[1];
  std::filesystem::create_directories(directory);
  std::printf("%s", header);
  for (const int width : {640, 1280}) {
    const Image unchanged = draw(changes().front(), width);
    for (const Change& change : changes()) {
      const Image image = draw(change, width);
      const std::filesystem::path file = change.name + text(" %d.png", width);
      write_png(directory / file, image);
      print(change.name, width, compare(unchanged, image));
      if (argc == 3)
        print(change.name + ", other machine", width, compare(image, read_png(argv[2] / file)));
    }
  }
} catch (const std::exception& error) {
  std::fprintf(stderr, "threshold_study: %s\n", error.what());
  return 1;
}
