// Directories of runs that no program ran: a few pixels, three vertices, a log.
#pragma once
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "picture/png.h"
#include "text/text.h"

constexpr Colour wall = {200, 208, 218}, red_cloth = {200, 60, 50};

// The wall, and a square of cloth, 20 pixels wide, this many pixels from the left.
inline Image cloth_on_the_wall(int left, int width = 64) {
  Image image = filled_image(width, 48, wall);
  paste(filled_image(20, 20, red_cloth), left, 14, image);
  return image;
}

class MadeUpRun {
 public:
  explicit MadeUpRun(const std::filesystem::path& directory_) : directory(directory_) {
    std::filesystem::create_directories(directory);
    toml(0.01);
  }

  // A row of the log. Energy and lowest point follow from the time, or are given.
  MadeUpRun& frame(double time, double energy = -1, double lowest = -0.5) {
    rows.push_back(text("%zu,%.12g,%.12g,0.25,1.5,%.12g,7,%d", rows.size(), time, energy * time,
                        lowest, int(rows.size())));
    std::string log = "frame,time,total,elastic,max_stretch,lowest,iterations,milliseconds\n";
    for (const std::string& row : rows) log += row + "\n";
    return file("log.csv", log);
  }

  // Of the latest frame.
  MadeUpRun& picture(const Image& image) {
    write_png(directory / name(".png"), image);
    return *this;
  }
  MadeUpRun& mesh(const std::vector<std::array<double, 3>>& vertices) {
    std::string obj;
    for (const auto& [x, y, z] : vertices) obj += text("v %.17g %.17g %.17g\n", x, y, z);
    return file(name(".obj"), obj + "f 1 2 3\n");
  }

  MadeUpRun& toml(double h, const std::string& options = "", const std::string& more = "") {
    return file("run.toml", "[run]\nprogram = 'step03_implicit'\noptions = [" + options +
                                "]\n[time]\nh = " + text("%g", h) + "\n" + more);
  }

  MadeUpRun& file(const std::string& file_name, const std::string& content) {
    std::ofstream(directory / file_name, std::ios::binary) << content;
    return *this;
  }
  std::string name(const char* ending) const {
    return text("frame_%04zu", rows.size() - 1) + ending;
  }

  const std::filesystem::path directory;

 private:
  std::vector<std::string> rows;
};

const std::vector<std::array<double, 3>> triangle = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
