// Checks of options, for CLI11's check(): each returns an empty text, or the error.
#pragma once
#include <CLI/CLI.hpp>
#include <cmath>
#include <string>

#include "text/text.h"

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
