// Small steps (Macklin et al. 2019): for the same work, is one step of n iterations better, or n steps of
// one? An iteration is one of Newton's method, or a sweep of XPBD or VBD.
#pragma once
#include <array>

#include "tradeoff/study.h"

namespace tradeoff {

// A method that repeats something within a step, and how to tell it how often.
struct Iterated {
  const char* name;
  Configuration (*with)(const Study&, int iterations);
};
const std::vector<Iterated>& iterated_methods();

inline constexpr std::array<int, 3> iterations_per_step = {16, 4, 1};

// The errors at the end after `total` iterations, in steps of 16, 4 and 1 of them. NaN: no answer.
std::array<double, 3> small_step_errors(const Study&, size_t mesh, const Iterated&, long total);

// The table of a scene, for every mesh, and a picture of the first one: small_steps.png in the directory of
// the study.
void compare_small_steps(const Study&);

}  // namespace tradeoff
