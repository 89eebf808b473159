// A scene that is studied: a scene.toml that the programs can run, read by the same reader. A
// built-in scene is first written to such a file.
#pragma once
#include <functional>
#include <optional>

#include "scene/scene.h"

namespace tradeoff {

struct StudyScene {
  std::string name;
  Scene scene;          // as step 5 reads it; the programs get its file
  std::string options;  // more options that the programs need
  double size = 0;      // m, the longest side of the mesh; errors are relative to it

  std::vector<int> steps;                       // that can simulate it, each in its own way
  std::vector<std::string> not_tried;           // the other steps, with the reason: "step01: …"
  std::function<VecX(double time)> exact = {};  // the exact solution, if it is known
};

// The cells of its grid along u; 0 if the mesh is not a grid.
int cells_of(const StudyScene&);

struct BuiltIn {
  const char* name;
  const char* letter;
  const char* what;  // one line for --help
};
const std::vector<BuiltIn>& built_in_scenes();

struct Choice {
  std::string scene;              // a built-in name or letter, or a file
  std::optional<double> k = {};   // N/m, of stretch; shear gets half of it; for built-in scenes
  std::optional<int> cells = {};  // along u; for the drop, the strip and files
};

// Reads a file, or writes a built-in scene into `directory` and reads that. Throws BadInput for a
// name that is neither, and for a k or cells that the scene does not take.
StudyScene make_study_scene(const Choice&, const std::filesystem::path& directory);

bool is_built_in(const Choice&);

// The name of a built-in scene. Of a file, the name of its directory and its
// own: step01_explicit_scene.
std::string short_name(const Choice&);

// The meshes to compare if the choice names no cells: several if the exact solution is known.
std::vector<Choice> meshes_of(const Choice&);

}  // namespace tradeoff
