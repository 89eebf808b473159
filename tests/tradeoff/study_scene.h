// What is studied: a scene.toml that the programs can run, read as they read it. A built-in scene is
// written as one first.
#pragma once
#include <functional>
#include <optional>

#include "scene/scene.h"

namespace tradeoff {

struct StudyScene {
  std::string name;
  Scene scene;          // as step 5 reads it; its file is what the programs are given
  std::string options;  // that the programs need beside the file
  double size = 0;  // m, the longer side of the cloth as it is laid: what errors are relative to

  std::vector<int> steps;                       // that can simulate it, each in its own way
  std::vector<std::string> not_tried;           // the others, and why: "step01: …"
  std::function<VecX(double time)> exact = {};  // where it is known, for a cloth without a mesh
};

// Of its grid, along u; 0 where it is none.
int cells_of(const StudyScene&);

struct BuiltIn {
  const char* name;
  const char* letter;
  const char* what;  // one line for --help
};
const std::vector<BuiltIn>& built_in_scenes();

struct Choice {
  std::string scene;              // a built-in name or letter, or a file
  std::optional<double> k = {};   // N/m, of stretch, and half of it of shear; for built-in scenes
  std::optional<int> cells = {};  // along u, of the drop, the strip and files
};

// Writes a built-in scene into `directory`. Throws BadInput for a name that is neither built in nor a
// file, and for what the scene cannot be asked.
StudyScene make_study_scene(const Choice&, const std::filesystem::path& directory);

bool is_built_in(const Choice&);

// Of a built-in scene its name; of a file, that of its directory and its own: step01_explicit_scene.
std::string short_name(const Choice&);

// The meshes that are compared if the choice names none: several where an answer without a mesh is known.
std::vector<Choice> meshes_of(const Choice&);

}  // namespace tradeoff
