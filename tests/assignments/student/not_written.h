// Stands in place of a body that a task asks for.
#pragma once
#include <stdexcept>
#include <string>

// A function that is not written yet does not use its parameters.
#pragma GCC diagnostic ignored "-Wunused-parameter"
#pragma GCC diagnostic ignored "-Wunused-but-set-parameter"

[[noreturn]] inline void not_written(const std::string& task, const std::string& function) {
  throw std::logic_error("not written yet: " + function + ", task " + task);
}
