// The command line: the same few options in all programs.
#pragma once
#include <array>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "math/method.h"
#include "scene/overrides.h"

// The concepts that a step has; each brings its options.
struct Concepts {
  bool implicit = false;   // --jacobian, --newton, --guard
  bool direct = false;     // --solver
  bool iterative = false;  // --preconditioner, --tolerance, --max-iterations
};

// A step, as its main.cpp names it.
struct Program {
  std::string name;                 // step01_explicit
  std::string idea;                 // one line for --help
  std::filesystem::path directory;  // where its scene.toml lies
  Concepts concepts = {};
};

struct Options {
  std::string program;  // step01_explicit
  std::filesystem::path scene;
  std::filesystem::path out;
  Overrides overrides;
  Concepts concepts;
  Method method;

  bool explain = false;
  bool pictures = true;
  bool motion = false;
  bool export_obj = false;
  bool export_pc2 = false;
  std::optional<std::array<int, 2>> size;  // of every picture
  bool wireframe = false;
  bool caption = false;
  std::optional<double> strain_scale;  // the strain at the end of the colour scale
};

// Runs simulate(options) and returns the exit code of the program: 0 done, 1 the run broke off, 2
// bad input or usage, 130 stopped by Ctrl-C. Errors are one line on the standard error.
int run_program(int argc, char** argv, const Program&,
                const std::function<int(const Options&)>& simulate);
