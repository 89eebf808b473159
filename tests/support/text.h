// printf into a string, and numbers.
#pragma once
#include <cstdio>
#include <string>

#include "text/text_file.h"

namespace tradeoff {

template <class... Values>
std::string format(const char* pattern, Values... values) {
  std::string text(size_t(std::snprintf(nullptr, 0, pattern, values...)), ' ');
  std::snprintf(text.data(), text.size() + 1, pattern, values...);
  return text;
}

// The number with all of its digits.
inline std::string number(double value) {
  std::string text;
  append_number(text, value);
  return text;
}

}  // namespace tradeoff
