// compare_frames a.png b.png [--diff d.png] [--exact]
// Exit code 0: the same picture (with --exact, to the last bit); 1: different; 2: not comparable.
#include <cstdio>
#include <exception>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "picture/compare.h"
#include "picture/png.h"

namespace {

struct Arguments {
  std::vector<std::string> files;
  std::string difference;
  bool exact = false;
};

Arguments arguments_of(int argc, char** argv) {
  Arguments arguments;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--exact")
      arguments.exact = true;
    else if (word == "--diff" && i + 1 < argc)
      arguments.difference = argv[++i];
    else
      arguments.files.push_back(word);
  }
  if (arguments.files.size() != 2 || arguments.files[0][0] == '-')
    throw std::runtime_error("usage: compare_frames a.png b.png [--diff d.png] [--exact]");
  return arguments;
}

std::optional<std::string> value_of(const std::string& key, const PngText& text) {
  for (const auto& [k, value] : text)
    if (k == key) return value;
  return std::nullopt;
}

// If the two pictures were made in different ways, prints how: this explains most differences.
void print_differing_keys(const PngText& a, const PngText& b) {
  for (const auto& [key, value] : a) {
    const std::string other = value_of(key, b).value_or("(absent)");
    if (value != other) std::printf("%s: %s | %s\n", key.c_str(), value.c_str(), other.c_str());
  }
  for (const auto& [key, value] : b)
    if (!value_of(key, a)) std::printf("%s: (absent) | %s\n", key.c_str(), value.c_str());
}

}  // namespace

int main(int argc, char** argv) try {
  const Arguments arguments = arguments_of(argc, argv);
  const std::string &a = arguments.files[0], &b = arguments.files[1];
  print_differing_keys(read_png_text(a), read_png_text(b));
  const Image first = read_png(a), second = read_png(b);
  const Difference difference = compare(first, second);
  std::printf("%s\n", describe(difference).c_str());
  if (!arguments.difference.empty())
    write_png(arguments.difference, difference_picture(first, second));
  const Verdict v = verdict(difference);
  return v == Verdict::DIFFERENT || (arguments.exact && v != Verdict::IDENTICAL) ? 1 : 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "compare_frames: %s\n", error.what());
  return 2;
}
