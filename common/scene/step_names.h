// The programs of the five steps.
#pragma once
#include "text/names.h"

// step01_explicit, …, in their order: the list of common/cmake/steps.cmake.
const Names& step_names();

// 3 of step03_implicit: the first six letters decide.
int step_number(const std::string& program);
