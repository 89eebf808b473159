// Commands that a person can paste into a shell.
#pragma once
#include <filesystem>
#include <string>

// A path for a shell, relative to the working directory, in quotes if it needs them.
inline std::string for_shell(const std::filesystem::path& path) {
  std::string text = std::filesystem::proximate(path).string();
  if (text.find('/') == std::string::npos) text = "./" + text;
  const bool plain = text.find_first_not_of(
                         "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                         "0123456789_-./+") == std::string::npos;
  if (plain) return text;
  for (size_t at = 0; (at = text.find('\'', at)) != std::string::npos; at += 4)
    text.replace(at, 1, "'\\''");
  return "'" + text + "'";
}
