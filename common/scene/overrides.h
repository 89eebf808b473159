// The changes that the command line makes in a scene, before the scene is checked.
#pragma once
#include <optional>
#include <string>
#include <vector>

struct Overrides {
  std::optional<double> h = {}, end = {};
  std::optional<int> frames = {}, cells = {};  // cells along u; along v in proportion
  std::vector<std::string> without = {};       // tables to leave out; a term with its damping
  std::vector<std::string> set = {};           // TABLE.KEY=VALUE; makes a table that is absent
};
