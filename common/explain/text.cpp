#include "explain/text.h"

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>

namespace {

constexpr size_t page_width = 100;

size_t width_of(const std::string& words) {
  return size_t(std::count_if(words.begin(), words.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xc0) != 0x80;  // not the rest of a character
  }));
}

}  // namespace

std::string text(const char* format, ...) {
  char buffer[1024];
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(buffer, sizeof buffer, format, arguments);
  va_end(arguments);
  return buffer;
}

std::string joined(const std::vector<std::string>& parts, const std::string& between) {
  std::string all;
  for (const std::string& part : parts) all += (all.empty() ? "" : between) + part;
  return all;
}

std::string padded(const std::string& words, size_t width) {
  return words + std::string(width - std::min(width, width_of(words)), ' ');
}

void print_row(const std::string& columns) {
  std::printf("%s\n", columns.substr(0, columns.find_last_not_of(' ') + 1).c_str());
}

void print_wrapped(const std::string& words) {
  std::string line = "   ";
  for (size_t begin = 0; begin < words.size();) {
    const size_t end = std::min(words.find(' ', begin), words.size());
    const std::string word = words.substr(begin, end - begin);
    begin = end + 1;
    if (width_of(line) + 1 + width_of(word) > page_width) {
      std::printf("%s\n", line.c_str());
      line = "     ";
    }
    line += " " + word;
  }
  std::printf("%s\n", line.c_str());
}

std::string length(double m) {
  return m < 1 ? text("%.3g mm", 1000 * m) : text("%.3g m", m);
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
  return text(part < 0.995 ? "%.2g %%" : "%.0f %%", 100 * part);
}
