// The forces of a step, in a file of their own: a compiler inlines as much as in the program of the step.
#pragma once
#include <functional>

#include "math/cloth.h"

std::function<void()> forces_of_step_1(const Cloth&, const State&);
std::function<void()> forces_of_step_3(const Cloth&, const State&);  // with K and D
