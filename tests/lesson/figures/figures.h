// The figures of one step, and the program that draws them.
#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "tests/lesson/figures/svg.h"

namespace figures {

struct Figure {
  std::string name;  // triangle.svg
  std::function<Svg()> draw;
};

// draw_stepNN: writes the figures into stepNN_…/figures. draw_stepNN --check: compares them with the files
// there, prints the command that renews them, and returns 1 if one differs.
int run(int argc, char** argv, const std::filesystem::path& directory,
        const std::vector<Figure>& figures);

}  // namespace figures
