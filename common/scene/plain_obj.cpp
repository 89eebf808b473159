#include "scene/plain_obj.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <string>
#include <vector>

#include "text/bad_input.h"
#include "text/text_file.h"

namespace {

struct Corner {
  int vertex = 0;  // from 0
  std::optional<int> uv;
};

struct FaceLine {
  int number;  // from 1
  std::array<Corner, 3> corners;
};

struct ObjFile {
  size_t positions = 0, uv = 0;  // lines so far
  std::vector<FaceLine> faces;
  std::string plain;  // the v and vt lines so far
};

constexpr std::string_view blanks = " \t";

std::string_view take_word(std::string_view& line) {
  line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
  const std::string_view word = line.substr(0, line.find_first_of(blanks));
  line.remove_prefix(word.size());
  return word;
}

// A weight or a colour may follow the numbers; both are left out.
bool copy_numbers(std::string_view keyword, std::string_view line, int count, std::string& plain) {
  plain += keyword;
  for (double number = 0; count > 0; --count) {
    if (!take_number(line, number)) return false;
    append_number(plain += ' ', number);
  }
  plain += '\n';
  return line.empty() || blanks.find(line[0]) != blanks.npos;
}

bool take_slash(std::string_view& word) {
  if (!word.starts_with('/')) return false;
  word.remove_prefix(1);
  return true;
}

// The index of one of `count` lines so far: 1 is the first of the file, −1 the last one so far. An
// index of no line becomes negative, or is found too large when the whole file has been read.
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
bool take_corner(std::string_view word, const ObjFile& file, Corner& corner) {
  int index = 0;
  if (!take_index(word, file.positions, corner.vertex)) return false;
  if (word.empty()) return true;
  if (!take_slash(word)) return false;
  if (take_index(word, file.uv, index)) {
    corner.uv = index;
    if (word.empty()) return true;
  }
  return take_slash(word) && take_index(word, 0, index) && word.empty();
}

bool take_triangle(std::string_view line, const ObjFile& file, FaceLine& face) {
  for (Corner& corner : face.corners)
    if (!take_corner(take_word(line), file, corner)) return false;
  return take_word(line).empty();
}

// What a bad line should have been; "" for a good line. Lines with other keywords are skipped.
std::string read_line(std::string_view line, int number, ObjFile& file) {
  line = line.substr(0, line.find('#'));
  const std::string_view keyword = take_word(line);
  file.positions += keyword == "v";
  file.uv += keyword == "vt";
  if (keyword == "v" && !copy_numbers(keyword, line, 3, file.plain))
    return "v and three finite numbers, in m";
  if (keyword == "vt" && !copy_numbers(keyword, line, 2, file.plain))
    return "vt and two finite numbers, in m";
  if (keyword == "f" && !take_triangle(line, file, file.faces.emplace_back(FaceLine{number, {}})))
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
std::string misfit(const FaceLine& face, const ObjFile& file) {
  for (const Corner& corner : face.corners) {
    if (!is_one_of(corner.vertex, file.positions))
      return "a vertex that does not exist; the file has " + range(file.positions);
    if (corner.uv && !is_one_of(*corner.uv, file.uv))
      return "a texture coordinate that does not exist; the file has " + range(file.uv);
    if (corner.uv.has_value() != face.corners[0].uv.has_value())
      return "texture coordinates at some corners only; all three need one, or none";
  }
  return "";
}

void append_face(const FaceLine& face, std::string& plain) {
  plain += 'f';
  for (const Corner& corner : face.corners) {
    plain += ' ' + std::to_string(corner.vertex + 1);
    if (corner.uv) plain += '/' + std::to_string(*corner.uv + 1);
  }
  plain += '\n';
}

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

}  // namespace

std::string plain_obj(std::string_view text, const std::filesystem::path& source) {
  const auto at = [&](int line) { return source.string() + ":" + std::to_string(line) + ": "; };
  if (text.starts_with(byte_order_mark))
    throw BadInput(at(1) +
                   "a byte order mark stands before the first line; save the file without it");
  ObjFile file;
  std::string_view line;
  for (int number = 1; take_line(text, line); ++number) {
    const std::string needed = read_line(line, number, file);
    if (!needed.empty())
      throw BadInput(at(number) + "\"" + std::string(line) + "\" is not " + needed);
  }
  for (const FaceLine& face : file.faces) {
    const std::string reason = misfit(face, file);
    if (!reason.empty()) throw BadInput(at(face.number) + "the face names " + reason);
    append_face(face, file.plain);
  }
  return file.plain;
}
