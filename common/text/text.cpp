#include "text/text.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdarg>
#include <cstdio>

namespace {

size_t width_of(const std::string& words) {
  return size_t(std::count_if(words.begin(), words.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xc0) != 0x80;  // only the first byte of a character
  }));
}

}  // namespace

std::string text(const char* format, ...) {
  va_list arguments, again;
  va_start(arguments, format);
  va_copy(again, arguments);
  std::string words(size_t(std::vsnprintf(nullptr, 0, format, arguments)), ' ');
  std::vsnprintf(words.data(), words.size() + 1, format, again);
  va_end(again);
  va_end(arguments);
  return words;
}

std::string joined(const std::vector<std::string>& parts, const std::string& between) {
  std::string all;
  for (const std::string& part : parts) all += (&part == &parts[0] ? "" : between) + part;
  return all;
}

std::string one_line(std::string words) {
  while (!words.empty() && std::isspace(static_cast<unsigned char>(words.back()))) words.pop_back();
  for (char& c : words)
    if (c == '\n' || c == '\r') c = ' ';
  return words;
}

std::string count(long number, const std::string& thing) {
  return std::to_string(number) + " " + thing + (number == 1 ? "" : "s");
}

std::string shortest(double number) {
  char digits[32];
  return {digits, std::to_chars(digits, digits + sizeof digits, number).ptr};
}

std::string length(double m) {
  return m < 0.9995 ? text("%.3g mm", 1000 * m) : text("%.3g m", m);
}

std::string bytes(size_t number) {
  if (number < 10000) return text("%zu B", number);
  if (number < 1000000) return text("%.0f kB", double(number) / 1e3);
  return text("%.1f MB", double(number) / 1e6);
}

std::string percent(double part) {
  return std::abs(part) < 0.005 ? "0 %" : text("%.0f %%", 100 * part);
}

std::string per_cent(double part) {
  return part < 0.995 ? text("%.2g %%", 100 * part) : text("%.0f %%", 100 * part);
}

std::string padded(const std::string& words, size_t width) {
  return words + std::string(width - std::min(width, width_of(words)), ' ');
}

std::string wrapped(const std::string& words, size_t width) {
  std::string lines, line = "   ";
  for (size_t begin = 0; begin < words.size();) {
    const size_t end = std::min(words.find(' ', begin), words.size());
    const std::string word = words.substr(begin, end - begin);
    begin = end + 1;
    if (width_of(line) + 1 + width_of(word) > width) {
      lines += line + "\n";
      line = "     ";
    }
    line += " " + word;
  }
  return lines + line + "\n";
}
