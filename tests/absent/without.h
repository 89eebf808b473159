// What is left out of a scene, and what can be told of a run with it, without it, with its stiffness 0, and
// by a program that was built without its code.
#pragma once
#include <cstdint>
#include <map>
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

// A way to take a step. Where it is not exact, its operations depend on where the matrix has blocks.
struct Way {
  const char* name;
  Scene arguments;
  bool exact = true;

  int step() const { return std::stoi(arguments.at("step")); }
};
std::vector<Way> ways(const Part&);  // of the steps that teach this part

Scene with(const Part&, const Way&);
Scene without(const Part&, const Way&);
Scene with_zero(const Part&, const Way&);  // k = 0, kd = 0, g = 0

// All that a program tells of a run.
struct Outcome {
  std::map<std::string, long> counts;
  double microseconds = 0;     // CPU time of a step, median
  std::vector<uint64_t> x, v;  // bit by bit

  bool moves_like(const Outcome& other) const { return x == other.x && v == other.v; }
};

// Throws std::runtime_error where the program fails.
Outcome run(const std::string& program, const Scene&);

// The farthest that a coordinate is from itself, m; infinite where one is not a number.
double distance(const Outcome&, const Outcome&);
