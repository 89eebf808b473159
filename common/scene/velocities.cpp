#include "scene/velocities.h"

#include "text/bad_input.h"
#include "text/text_file.h"

namespace {

constexpr std::string_view header = "vx,vy,vz";

bool take_comma(std::string_view& text) {
  const size_t at = text.find_first_not_of(" \t");
  if (at == text.npos || text[at] != ',') return false;
  text.remove_prefix(at + 1);
  return true;
}

bool is_blank(std::string_view text) {
  return text.find_first_not_of(" \t") == text.npos;
}

bool take_row(std::string_view row, Vec3& v) {
  return take_number(row, v[0]) && take_comma(row) && take_number(row, v[1]) && take_comma(row) &&
         take_number(row, v[2]) && is_blank(row);
}

}  // namespace

void write_velocities(const std::filesystem::path& path, const VecX& v) {
  std::string text = std::string(header) + '\n';
  for (Eigen::Index c = 0; c < v.size(); ++c) {
    append_number(text, v[c]);
    text += c % 3 < 2 ? ',' : '\n';
  }
  write_text(path, text);
}

VecX read_velocities(const std::filesystem::path& path, int vertices) {
  const std::string file = read_text(path);
  std::string_view text = file, line;
  if (!take_line(text, line) || line != header)
    throw BadInput(path.string() + ":1: the first line must be the header " + std::string(header));

  VecX v(3 * vertices);
  int rows = 0;
  for (int number = 2; take_line(text, line); ++number) {
    if (is_blank(line)) continue;
    Vec3 row;
    if (!take_row(line, row))
      throw BadInput(path.string() + ":" + std::to_string(number) + ": \"" + std::string(line) +
                     "\" is not three finite numbers vx,vy,vz in m/s");
    if (rows < vertices) v.segment<3>(3 * rows) = row;
    ++rows;
  }
  if (rows != vertices)
    throw BadInput(path.string() + ": " + std::to_string(rows) +
                   " rows of velocities, but the cloth has " + std::to_string(vertices) +
                   " vertices; one row per vertex is needed");
  return v;
}
