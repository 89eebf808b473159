// An error that a user has to correct: one clear line with the file, the key or line, the fault,
// and what would be valid. The programs print it and end with exit code 2.
#pragma once
#include <stdexcept>

struct BadInput : std::runtime_error {
  using std::runtime_error::runtime_error;
};
