#include "tests/lesson/figures/figures.h"

#include <cstdio>
#include <exception>

#include "text/text_file.h"
#include "text/whole_file.h"

namespace figures {

int run(int argc, char** argv, const std::filesystem::path& directory,
        const std::vector<Figure>& figures) try {
  const bool check = argc > 1 && std::string(argv[1]) == "--check";
  bool all_equal = true;
  for (const Figure& figure : figures) {
    const std::filesystem::path path = directory / figure.name;
    const std::string drawn = figure.draw().file();
    if (!check) {
      std::filesystem::create_directories(directory);
      write_text(path, drawn);
    } else if (!no_file(path).empty() || read_text(path) != drawn) {
      std::printf(
          "%s is not what the program draws; cmake --build build/release --target "
          "update_figures renews it\n",
          path.c_str());
      all_equal = false;
    }
  }
  return all_equal ? 0 : 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s: %s\n", argv[0], error.what());
  return 2;
}

}  // namespace figures
