// printf into a string.
#pragma once
#include <cstdio>
#include <string>

namespace tradeoff {

template <class... Values>
std::string format(const char* pattern, Values... values) {
  std::string text(size_t(std::snprintf(nullptr, 0, pattern, values...)), ' ');
  std::snprintf(text.data(), text.size() + 1, pattern, values...);
  return text;
}

}  // namespace tradeoff
