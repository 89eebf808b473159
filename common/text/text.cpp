#include "text/text.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <cstring>

namespace {

// Not the first byte of a character in UTF-8.
bool is_inside_a_character(char c) {
  return (static_cast<unsigned char>(c) & 0xc0) == 0x80;
}

size_t width_of(const std::string& words) {
  return words.size() - size_t(std::count_if(words.begin(), words.end(), is_inside_a_character));
}

bool is_control(char c) {
  return static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
}

std::string escaped(char c) {
  if (c == '\n') return "\\n";
  if (c == '\r') return "\\r";
  if (c == '\t') return "\\t";
  return text("\\x%02x", unsigned(c));
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
  std::string line;
  for (const char c : words) line += is_control(c) ? escaped(c) : std::string(1, c);
  if (line.size() <= 300) return line;
  size_t begin = 200, end = line.size() - 95;
  while (is_inside_a_character(line[begin])) --begin;
  while (is_inside_a_character(line[end])) ++end;
  return line.substr(0, begin) + " ... " + line.substr(end);
}

std::string shell_word(const std::string& word) {
  const auto is_plain = [](unsigned char c) { return std::isalnum(c) || std::strchr("-_./:+", c); };
  if (!word.empty() && std::ranges::all_of(word, is_plain)) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? "'\\''" : std::string(1, c);
  return quoted + "'";
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
