// scene.toml: what is simulated. One table per thing modelled; an absent table is not modelled.
#pragma once
#include <cmath>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "math/cloth.h"
#include "scene/mesh.h"
#include "text/bad_input.h"

struct Time {
  double h = 0;    // s
  double end = 0;  // s
  int frames = 12;

  // The time of step n is n h. The slack forgives an end / h that is whole but for rounding.
  long steps() const { return std::lround(std::ceil(end / h - 1e-6)); }
  long step_of_frame(int frame) const {
    return std::lround(double(frame) * double(steps()) / double(frames));
  }
};

// How the scene is drawn; what is absent follows from where the cloth can go.
struct Camera {
  std::optional<Vec3> eye, target;  // m
  std::optional<double> still;      // s, the moment of the still; the end if absent
};

struct Scene {
  std::filesystem::path file;
  Mesh mesh;
  Cloth cloth;
  State start;
  Time time;
  Camera camera;
};

// What the command line changes in a scene before it is checked.
struct Overrides {
  std::optional<double> h = {}, end = {};
  std::optional<int> frames = {}, cells = {};  // cells along u; along v in proportion
  std::vector<std::string> without = {};       // tables taken out; a term goes with its damping
};

// Reads and checks everything before the first step. `program` is the name of the step (its first
// six letters, step01 … step05, decide which tables it teaches). Throws BadInput.
Scene read_scene(const std::filesystem::path&, const std::string& program, const Overrides& = {});
