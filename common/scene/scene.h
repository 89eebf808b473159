// scene.toml: what is simulated. One table per thing modelled; an absent table is not modelled.
#pragma once
#include <cmath>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "math/cloth.h"
#include "scene/mesh.h"
#include "scene/overrides.h"
#include "text/bad_input.h"

struct Time {
  double h = 0;    // s
  double end = 0;  // s
  int frames = 12;

  // The time of step n is n h. The slack of 1e-6 allows for rounding where end / h is whole.
  long steps() const { return std::lround(std::ceil(end / h - 1e-6)); }
  long step_of_frame(int frame) const {
    return std::lround(double(frame) * double(steps()) / double(frames));
  }
};

// The camera. An absent value is chosen such that the whole motion is in the picture.
struct Camera {
  std::optional<Vec3> eye, target;  // m
  std::optional<double> still;      // s, the moment of the still; the end if absent
};

struct Scene {
  std::string name() const;  // for people: the file and the directory that it is in

  std::filesystem::path file;
  Mesh mesh;
  Cloth cloth;
  State start;
  Time time;
  Camera camera;
  std::string effective;  // the scene in TOML, with the changes of the command line
};

// Reads and checks everything before the first step. `program` is the name of the step (its first
// six letters, step01 … step05, decide which tables it teaches). Throws BadInput.
Scene read_scene(const std::filesystem::path&, const std::string& program, const Overrides& = {});

// The options in the table [run] of a scene, which a run of this program has written (run.toml); none where
// there is no such table, or where another program wrote it. Throws BadInput.
std::vector<std::string> options_of_run(const std::filesystem::path&, const std::string& program);

// A value of a scene as the file has it, for people; "" where the scene does not have it, or cannot be read.
std::string value_in_scene(const std::filesystem::path&, const char* table, const char* key);
