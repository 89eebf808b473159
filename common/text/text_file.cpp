#include "text/text_file.h"

#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>

#include "text/bad_input.h"
#include "text/whole_file.h"

namespace {

std::string reason() {
  return errno ? std::strerror(errno) : "the system gives no reason";
}

}  // namespace

void write_text(const std::filesystem::path& path, std::string_view text) {
  WholeFile file(path);
  file.write(text);
  file.finish();
}

std::string no_file(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) return "there is no such file";
  if (std::filesystem::is_directory(path, error)) return "this is a directory, a file is needed";
  if (!std::filesystem::is_regular_file(path, error)) return "this is no regular file";
  return "";
}

std::string read_text(const std::filesystem::path& path) {
  const std::string name = path.string(), missing = no_file(path);
  if (!missing.empty()) throw BadInput(name + ": " + missing);
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(file), {}};
  if (!file.is_open() || file.bad()) throw BadInput(name + ": cannot be read: " + reason());
  return text;
}

void append_number(std::string& text, double number) {
  char digits[32];
  const std::to_chars_result end =
      std::to_chars(digits, digits + sizeof digits, number, std::chars_format::general, 17);
  text.append(digits, end.ptr);
}

bool take_number(std::string_view& text, double& number) {
  size_t begin = text.find_first_not_of(" \t");
  if (begin == text.npos) return false;
  if (text[begin] == '+' && !text.substr(begin + 1).starts_with('-'))
    ++begin;  // legal in most formats, but not for from_chars
  const char* const end = text.data() + text.size();
  double value = 0;
  const std::from_chars_result read = std::from_chars(text.data() + begin, end, value);
  if (read.ec != std::errc() || !std::isfinite(value)) return false;
  number = value;
  text.remove_prefix(size_t(read.ptr - text.data()));
  return true;
}

bool take_line(std::string_view& text, std::string_view& line) {
  if (text.empty()) return false;
  line = text.substr(0, text.find_first_of("\r\n"));
  text.remove_prefix(line.size());
  text.remove_prefix(text.starts_with("\r\n") ? 2 : text.empty() ? 0 : 1);
  return true;
}
