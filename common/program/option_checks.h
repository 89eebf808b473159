// What options have to be, for CLI11's check(): an empty text, or what is wrong.
#pragma once
#include <cctype>
#include <CLI/CLI.hpp>
#include <cmath>
#include <string>

inline std::string positive_number(const std::string& text) {
  double number = 0;
  if (CLI::detail::lexical_cast(text, number) && std::isfinite(number) && number > 0) return {};
  return "wants a number above 0, not \"" + text + "\"";
}

inline std::string positive_integer(const std::string& text) {
  int number = 0;
  if (CLI::detail::lexical_cast(text, number) && number > 0) return {};
  return "wants a whole number from 1 on, not \"" + text + "\"";
}

// An error is one line.
inline std::string one_line(std::string text) {
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back()))) text.pop_back();
  for (char& c : text)
    if (c == '\n') c = ' ';
  return text;
}
