#include "fuzz/fuzz.h"

#include <unistd.h>

#include <toml++/toml.h>
#include <cstdio>
#include <cstdlib>
#include <fstream>

namespace {

namespace fs = std::filesystem;

constexpr std::string_view files_of_a_scene[] = {"velocities.csv", "start.obj", "mesh.obj"};

// In memory, where there is such a directory; removed at the end.
struct Scratch {
  fs::path path;

  Scratch() {
    const fs::path memory = "/dev/shm";
    path = (fs::is_directory(memory) ? memory : fs::temp_directory_path()) /
           ("fuzz" + std::to_string(getpid()));
    fs::create_directories(path);
  }
  ~Scratch() { fs::remove_all(path); }
};

fs::path in_scratch(std::string_view name) {
  static const Scratch scratch;
  return scratch.path / name;
}

}  // namespace

void require(bool holds, std::string_view what) {
  if (holds) return;
  std::fprintf(stderr, "false: %.*s\n", int(what.size()), what.data());
  std::abort();
}

fs::path input_file(std::string_view name, std::string_view text) {
  const fs::path path = in_scratch(name);
  std::ofstream(path, std::ios::binary).write(text.data(), std::streamsize(text.size()));
  return path;
}

fs::path input_scene(std::string_view text) {
  for (const std::string_view name : files_of_a_scene) {
    const std::string head = "\n=== " + std::string(name) + "\n";
    const size_t at = text.rfind(head);
    fs::remove(in_scratch(name));
    if (at == text.npos) continue;
    input_file(name, text.substr(at + head.size()));
    text = text.substr(0, at + 1);
  }
  return input_file("scene.toml", text);
}

bool has_many_cells(const fs::path& scene, int most) {
  try {
    const toml::table tables = toml::parse_file(scene.string());
    const auto cells = tables["cloth"]["cells"];
    const auto side = [&](size_t i) { return double(cells[i].value_or(std::int64_t{1})); };
    return side(0) * side(1) > most;
  } catch (const toml::parse_error&) {
    return false;
  }
}

void require_clear(const BadInput& refusal) {
  const std::string said = refusal.what();
  bool names_a_file = said.find("scene.toml") != said.npos;
  for (const std::string_view name : files_of_a_scene)
    names_a_file = names_a_file || said.find(name) != said.npos;
  require(names_a_file, "a refusal names the file: " + said);
}
