#include <map>

#include "scene/mesh.h"
#include "text/text_file.h"

namespace {

using VertexUv = std::array<double, 3>;  // vertex, u, v

void append_record(std::string& text, const char* keyword, const auto& numbers) {
  text += keyword;
  for (const double number : numbers) {
    text += ' ';
    append_number(text, number);
  }
  text += '\n';
}

// The vt lines, and for every face corner the number of its line. Corners of a vertex with the same
// (u, v) share one; the corners on the two sides of a seam do not.
std::string texture_lines(const Mesh& mesh, std::vector<Face>& numbers) {
  std::string text;
  std::map<VertexUv, int> number_of;
  for (size_t face = 0; face < mesh.faces.size(); ++face) {
    Face& number = numbers.emplace_back();
    for (size_t c = 0; c < 3; ++c) {
      const Vec2& uv = mesh.rest[face][c];
      const VertexUv corner = {double(mesh.faces[face][c]), uv.x(), uv.y()};
      const auto [at, is_new] = number_of.try_emplace(corner, int(number_of.size()) + 1);
      if (is_new) append_record(text, "vt", uv);
      number[c] = at->second;
    }
  }
  return text;
}

}  // namespace

// v: where a vertex is. vt: the rest shape. f: vertex/rest shape of each corner, counted from 1.
void write_obj(const std::filesystem::path& path, const Mesh& mesh, const VecX& x) {
  std::string text;
  for (int i = 0; i < mesh.vertices(); ++i) append_record(text, "v", Vec3(x.segment<3>(3 * i)));
  std::vector<Face> numbers;
  text += texture_lines(mesh, numbers);
  for (size_t face = 0; face < mesh.faces.size(); ++face) {
    text += 'f';
    for (size_t c = 0; c < 3; ++c)
      text +=
          ' ' + std::to_string(mesh.faces[face][c] + 1) + '/' + std::to_string(numbers[face][c]);
    text += '\n';
  }
  write_text(path, text);
}
