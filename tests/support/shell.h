// Commands that a person can paste into a shell.
#pragma once
#include <filesystem>
#include <string>

#include "text/text.h"

// A path for a shell, relative to the working directory, in quotes if it needs them.
inline std::string for_shell(const std::filesystem::path& path) {
  std::string words = std::filesystem::proximate(path).string();
  if (words.find('/') == std::string::npos) words = "./" + words;
  return shell_word(words);
}
