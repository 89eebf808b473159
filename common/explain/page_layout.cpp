#include "explain/page_layout.h"

#include <algorithm>
#include <cstdio>

namespace {

constexpr size_t page_width = 100;

size_t width_of(const std::string& words) {
  return size_t(std::count_if(words.begin(), words.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xc0) != 0x80;  // not the rest of a character
  }));
}

}  // namespace

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
