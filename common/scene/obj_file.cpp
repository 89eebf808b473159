#include "scene/obj_file.h"

#include <algorithm>
#include <charconv>

#include "scene/bad_input.h"
#include "scene/text_file.h"

namespace {

constexpr std::string_view blanks = " \t";

std::string_view take_word(std::string_view& line) {
  line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
  const std::string_view word = line.substr(0, line.find_first_of(blanks));
  line.remove_prefix(word.size());
  return word;
}

// What may follow the numbers, a weight or a colour, is not needed.
template <class Vec>
bool take_numbers(std::string_view line, Vec& v) {
  for (double& number : v)
    if (!take_number(line, number)) return false;
  return line.empty() || blanks.find(line[0]) != blanks.npos;
}

bool take_slash(std::string_view& word) {
  if (!word.starts_with('/')) return false;
  word.remove_prefix(1);
  return true;
}

// The index of one of `count` lines so far: 1 is the first of the file, −1 the last one so far. What
// names none of them becomes negative, or is found too large once the whole file is read.
bool take_index(std::string_view& word, size_t count, int& index) {
  int number = 0;
  const std::from_chars_result read =
      std::from_chars(word.data(), word.data() + word.size(), number);
  if (read.ec != std::errc()) return false;
  word.remove_prefix(size_t(read.ptr - word.data()));
  index = number < 0 ? std::max(-1, int(count) + number) : number - 1;
  return true;
}

// 1, 1/2, 1//3 or 1/2/3: vertex, texture coordinate, normal. The normal is not needed.
bool take_corner(std::string_view word, const ObjFile& file, ObjCorner& corner) {
  int index = 0;
  if (!take_index(word, file.positions.size(), corner.vertex)) return false;
  if (word.empty()) return true;
  if (!take_slash(word)) return false;
  if (take_index(word, file.uv.size(), index)) {
    corner.uv = index;
    if (word.empty()) return true;
  }
  return take_slash(word) && take_index(word, 0, index) && word.empty();
}

bool take_triangle(std::string_view line, const ObjFile& file, ObjFace& face) {
  for (ObjCorner& corner : face.corners)
    if (!take_corner(take_word(line), file, corner)) return false;
  return take_word(line).empty();
}

// "" for a good line, and what it should have been for a bad one. Other keywords are skipped.
std::string read_line(std::string_view line, int number, ObjFile& file) {
  line = line.substr(0, line.find('#'));
  const std::string_view keyword = take_word(line);
  if (keyword == "v" && !take_numbers(line, file.positions.emplace_back()))
    return "v and three finite numbers, in m";
  if (keyword == "vt" && !take_numbers(line, file.uv.emplace_back()))
    return "vt and two finite numbers, in m";
  if (keyword == "f" && !take_triangle(line, file, file.faces.emplace_back(ObjFace{number, {}})))
    return "a triangle: f and three corners, like f 1 2 3 or f 1/1 2/2 3/3";
  return "";
}

bool is_one_of(int index, size_t count) {
  return index >= 0 && size_t(index) < count;
}

std::string range(size_t count) {
  return count ? "1 to " + std::to_string(count) : "none";
}

// Why a face does not fit to the v and vt lines of the file; "" where it does.
std::string misfit(const ObjFace& face, const ObjFile& file) {
  for (const ObjCorner& corner : face.corners) {
    if (!is_one_of(corner.vertex, file.positions.size()))
      return "a vertex that does not exist; the file has " + range(file.positions.size());
    if (corner.uv && !is_one_of(*corner.uv, file.uv.size()))
      return "a texture coordinate that does not exist; the file has " + range(file.uv.size());
    if (corner.uv.has_value() != face.corners[0].uv.has_value())
      return "texture coordinates at some corners only; all three need one, or none";
  }
  return "";
}

}  // namespace

ObjFile read_obj_file(const std::filesystem::path& path) {
  const std::string whole = read_text(path);
  const auto at = [&](int line) { return path.string() + ":" + std::to_string(line) + ": "; };
  ObjFile file;
  std::string_view text = whole, line;
  for (int number = 1; take_line(text, line); ++number) {
    const std::string needed = read_line(line, number, file);
    if (!needed.empty())
      throw BadInput(at(number) + "\"" + std::string(line) + "\" is not " + needed);
  }
  for (const ObjFace& face : file.faces) {
    const std::string reason = misfit(face, file);
    if (!reason.empty()) throw BadInput(at(face.line) + "the face names " + reason);
  }
  return file;
}
