#include "absent/without.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdio>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace {

// Step 2 at an h at which it is stable, steps 3 and 5 at a large one.
Scene explicit_step() {
  return {{"step", "2"}, {"method", "explicit"}, {"h", "0.0002"}, {"steps", "400"}};
}
Scene implicit_step(const char* step, const char* method) {
  return {{"step", step}, {"method", method}, {"h", "0.01"}, {"steps", "20"}};
}
Scene more(Scene scene, const Scene& additional) {
  for (const auto& [name, value] : additional) scene[name] = value;
  return scene;
}

// Conjugate gradients leave an error that depends on the preconditioner. ic and multigrid depend on
// the pattern of the matrix, so they iterate until this error is rounding.
std::vector<Configuration> all_configurations() {
  const Scene newton = {{"newton", "5"}, {"steps", "8"}}, to_rounding = {{"tolerance", "1e-13"}};
  const Scene bw98 = {{"bw98", "1"}, {"h", "0.001"}};  // definite only in small steps
  return {
      {"explicit", explicit_step()},
      {"none", implicit_step("5", "none")},
      {"jacobi", implicit_step("5", "jacobi")},
      {"block", implicit_step("5", "block")},
      {"block, bw98", more(implicit_step("5", "block"), bw98)},
      {"block, Newton", more(implicit_step("5", "block"), newton)},
      {"ldlt", implicit_step("3", "ldlt"), false},
      {"ldlt, Newton", more(implicit_step("3", "ldlt"), newton), false},
#ifdef LARGE_STEPS_CHOLMOD
      {"cholmod", implicit_step("3", "cholmod"), false},
#endif
      {"ic", more(implicit_step("5", "ic"), to_rounding), false},
      {"multigrid", more(implicit_step("5", "multigrid"), to_rounding), false},
      {"multigrid, bw98, Newton",
       more(more(more(implicit_step("5", "multigrid"), bw98), newton), to_rounding), false},
  };
}

}  // namespace

bool Part::has(const std::string& argument) const {
  const std::string of = name;
  if (of == "damping") return argument.ends_with(".kd");
  return argument == of || argument.starts_with(of + ".");
}

// run_toy has only step 5.
bool Part::only_in_step_5() const {
  return has("toy") || (has("bend.kd") && !has("stretch.kd"));
}

std::vector<Configuration> configurations(const Part& part) {
  std::vector<Configuration> teaching = all_configurations();
  if (part.only_in_step_5())
    std::erase_if(teaching,
                  [](const Configuration& configuration) { return configuration.step() < 5; });
  return teaching;
}

Scene with(const Part& part, const Configuration& configuration) {
  Scene scene = {{"cells", "8"},         {"gravity", "9.81"}, {"stretch", "1000"},
                 {"stretch.kd", "0.02"}, {"shear", "500"},    {"shear.kd", "0.01"}};
  if (configuration.step() == 5) scene = more(scene, {{"bend", "0.0001"}, {"bend.kd", "0.000002"}});
  if (part.has("membrane"))
    scene = more(scene,
                 {{"membrane", "300"}, {"membrane.kd", "0.01"}, {"membrane.model", "neo-hookean"}});
  if (part.has("spring")) scene = more(scene, {{"spring", "100"}, {"spring.kd", "0.01"}});
  if (part.has("toy")) scene = more(scene, {{"toy", "30"}, {"toy.kd", "0.01"}});
  if (part.only_damping)
    std::erase_if(scene, [&](const auto& argument) {
      return argument.first.ends_with(".kd") && !part.has(argument.first);
    });
  return more(scene, configuration.arguments);
}

Scene without(const Part& part, const Configuration& configuration) {
  Scene scene = with(part, configuration);
  std::erase_if(scene, [&](const auto& argument) { return part.has(argument.first); });
  return scene;
}

// The damping becomes 0, too: otherwise a term of stiffness 0 would still exert a force.
Scene with_zero(const Part& part, const Configuration& configuration) {
  Scene scene = with(part, configuration);
  for (auto& [name, value] : scene)
    if (part.has(name) && !name.ends_with(".model")) value = "0";
  return scene;
}

Outcome run(const std::string& program, const Scene& scene) {
  std::string command = "\"" PROGRAM_DIRECTORY "/" + program + "\"";
  for (const auto& [name, value] : scene) command += " " + name + "=" + value;
  FILE* pipe = popen(command.c_str(), "r");
  if (!pipe) throw std::runtime_error(command + ": could not be started");
  std::string text;
  std::array<char, 65536> piece;
  while (const size_t length = fread(piece.data(), 1, piece.size(), pipe))
    text.append(piece.data(), length);
  if (pclose(pipe) != 0) throw std::runtime_error(command + ": failed");

  Outcome outcome;
  std::istringstream in(text);
  for (std::string name; in >> name && name != "microseconds";) in >> outcome.counts[name];
  in >> outcome.microseconds;
  std::vector<uint64_t> bits;
  for (uint64_t number; in >> number;) bits.push_back(number);
  if (bits.empty()) throw std::runtime_error(command + ": printed no positions");
  outcome.x.assign(bits.begin(), bits.begin() + long(bits.size() / 2));
  outcome.v.assign(bits.begin() + long(bits.size() / 2), bits.end());
  return outcome;
}

double distance(const Outcome& a, const Outcome& b) {
  double farthest = 0;
  for (size_t i = 0; i < a.x.size(); ++i) {
    const double apart = std::abs(std::bit_cast<double>(a.x[i]) - std::bit_cast<double>(b.x[i]));
    if (std::isnan(apart)) return std::numeric_limits<double>::infinity();
    farthest = std::max(farthest, apart);
  }
  return farthest;
}
