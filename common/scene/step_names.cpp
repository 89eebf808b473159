#include "scene/step_names.h"

#include <sstream>
#include <stdexcept>

const Names& step_names() {
  static const Names all = [] {
    Names names;
    std::istringstream list(STEP_NAMES);
    for (std::string name; std::getline(list, name, ':');) names.push_back(name);
    return names;
  }();
  return all;
}

int step_number(const std::string& program) {
  for (size_t i = 0; i < step_names().size(); ++i)
    if (program.starts_with(step_names()[i].substr(0, 6))) return int(i) + 1;
  throw std::invalid_argument("no step is called " + program);
}
