// The parts of a scene that can be left out, and runs of the scene: with the part, without it, with its
// stiffness 0, and by a program that was built without its code.
#pragma once
#include <cstdint>
#include <map>
#include <ostream>
#include <string>
#include <vector>

// name=value, as run_scene.cpp reads them.
using Scene = std::map<std::string, std::string>;

// A part of a scene that can be left out: gravity, a term with its damping, or damping alone.
struct Part {
  const char* name;               // stretch; stretch.kd is its damping, damping that of all terms
  const char* program;            // built without its code
  bool only_damping = false;      // the scene has no damping but this
  const char* full = "run_full";  // built with its code

  bool has(const std::string& argument) const;
  bool only_in_step_5() const;
};
inline void PrintTo(const Part& part, std::ostream* out) {
  *out << part.name;
}

// How a step is taken. If not `exact`, the order of operations depends on the pattern of the matrix.
struct Configuration {
  const char* name;
  Scene arguments;
  bool exact = true;

  int step() const { return std::stoi(arguments.at("step")); }
};
std::vector<Configuration> configurations(const Part&);  // of the steps that teach this part

Scene with(const Part&, const Configuration&);
Scene without(const Part&, const Configuration&);
Scene with_zero(const Part&, const Configuration&);  // k = 0, kd = 0, g = 0

// The output of a run.
struct Outcome {
  std::map<std::string, long> counts;
  double microseconds = 0;     // CPU time of a step, median
  std::vector<uint64_t> x, v;  // bit by bit

  bool moves_like(const Outcome& other) const { return x == other.x && v == other.v; }
};

// Throws std::runtime_error where the program fails.
Outcome run(const std::string& program, const Scene&);

// The largest difference of a coordinate, m; infinite where one is not a number.
double distance(const Outcome&, const Outcome&);
