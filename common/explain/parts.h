// What a scene models, and the cloth without one part of it.
#pragma once
#include <string>
#include <vector>

#include "scene/scene.h"

// Something that can be left out.
struct Part {
  std::string name;    // shear, damping of shear, all damping
  std::string option;  // how to leave it out: an option, or a change of the scene
  bool is_damping;
  Cloth cloth;  // without it, as read_scene makes it
};

// Gravity, every term with its damping, and the damping of every term.
std::vector<Part> parts_of(const Cloth&);

// gravity 9.81 m/s², stretch k = 1000 N/m, kd = 0.02 N·s/m, …
std::vector<std::string> describe_terms(const Cloth&);

// The terms that share their elements, and the cost of visiting them, with another term.
struct Sharing {
  std::vector<std::string> elements, terms;  // triangles; stretch, shear
};
Sharing sharing_of(const Cloth&);

// 3200 triangles, 4720 hinges, …
std::string describe_elements(const Scene&);

// Of all elements of a cloth.
size_t element_bytes(const Cloth&);
