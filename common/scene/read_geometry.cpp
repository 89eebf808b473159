#include <algorithm>
#include <map>

#include "scene/memory.h"
#include "scene/scene_file.h"

namespace {

Mesh read_grid(const TomlTable& cloth, const Vec2& size) {
  const std::array<int, 2> cells = cloth.two_whole_numbers("cells");
  const bool alternating =
      cloth.has("diagonals") && cloth.one_of("diagonals", {"same", "alternating"}) == "alternating";
  if (const std::optional<std::string> reason = too_large(cells)) cloth.refuse("cells", *reason);
  Mesh mesh = make_grid(size, cells, alternating ? Diagonals::alternating : Diagonals::same);
  if (!has_area(mesh.rest[0]))
    cloth.refuse("size",
                 "with these cells the triangles have no area; the sides of a cell must "
                 "differ by less than a factor of 1e12");
  return mesh;
}

Mesh read_mesh(const TomlTable& cloth) {
  for (const char* key : {"size", "cells", "diagonals"})
    if (cloth.has(key)) cloth.refuse(key, "a cloth with a mesh has none; take out one of the two");
  return read_obj(cloth.existing_file("mesh"));
}

const Names pin_names = {"top left", "top right", "bottom left", "bottom right",
                         "top",      "bottom",    "left",        "right"};

// The vertices of a corner or an edge: "top" leaves i free and "left" leaves j free.
std::vector<int> named_vertices(const std::string& name, const std::array<int, 2>& cells) {
  const auto says = [&](const char* word) { return name.find(word) != name.npos; };
  const auto [i0, i1] = says("left")    ? std::array{0, 0}
                        : says("right") ? std::array{cells[0], cells[0]}
                                        : std::array{0, cells[0]};
  const auto [j0, j1] = says("bottom") ? std::array{0, 0}
                        : says("top")  ? std::array{cells[1], cells[1]}
                                       : std::array{0, cells[1]};
  std::vector<int> vertices;
  for (int j = j0; j <= j1; ++j)
    for (int i = i0; i <= i1; ++i) vertices.push_back(j * (cells[0] + 1) + i);
  return vertices;
}

// The vertices of a pin that is a name or a number: the value of `key` in `table`.
std::vector<int> pinned(const TomlTable& cloth, const TomlTable& table, const char* key,
                        const toml::node& pin, int vertices) {
  const std::string numbers = "a vertex number from 0 to " + std::to_string(vertices - 1);
  if (pin.is_integer()) {
    const int64_t vertex = *pin.value<int64_t>();
    if (vertex < 0 || vertex >= vertices) table.refuse(key, pin, "it must be " + numbers);
    return {int(vertex)};
  }
  if (!pin.is_string()) table.refuse(key, pin, "a pin is a name or " + numbers);
  const std::string name = *pin.value<std::string>();
  if (cloth.has("mesh"))
    table.refuse(key, pin, "only a grid has named corners and edges; a mesh needs " + numbers);
  if (std::find(pin_names.begin(), pin_names.end(), name) == pin_names.end())
    table.refuse(key, pin, valid_names(name, pin_names) + ", or " + numbers);
  return named_vertices(name, cloth.two_whole_numbers("cells"));
}

// One entry of pins. A name or a number holds its vertices in all directions; a table names the
// directions and a velocity.
std::vector<Pin> read_entry(const TomlTable& cloth, const toml::node& entry, int vertices) {
  if (!entry.is_table()) {
    const std::vector<int> held = pinned(cloth, cloth, "pins", entry, vertices);
    return {held.begin(), held.end()};
  }
  const TomlTable table = cloth.inner("pin", *entry.as_table());
  table.allow_only({"vertex", "fix", "velocity"});
  const toml::node& vertex = table.need("vertex", "a vertex number or a name");
  std::vector<Pin> pins;
  for (const int i : pinned(cloth, table, "vertex", vertex, vertices))
    pins.push_back(read_pin(table, i));
  return pins;
}

bool hold_the_same(const Pin& a, const Pin& b) {
  return a.S.isApprox(b.S, 1e-12) && a.velocity.isApprox(b.velocity, 1e-12);
}

std::vector<Pin> read_pins(const TomlTable& cloth, int vertices) {
  if (!cloth.has("pins")) return {};
  std::map<int, Pin> pins;
  for (const toml::node& entry : cloth.list("pins", "a list, like [\"top left\", \"top right\"]"))
    for (const Pin& pin : read_entry(cloth, entry, vertices)) {
      const auto [before, is_new] = pins.try_emplace(pin.vertex, pin);
      if (!is_new && !hold_the_same(before->second, pin))
        cloth.refuse("pins", entry,
                     "vertex " + std::to_string(pin.vertex) +
                         " is already pinned in another way; name it once");
    }
  std::vector<Pin> sorted;
  sorted.reserve(pins.size());
  for (const auto& [vertex, pin] : pins) sorted.push_back(pin);
  return sorted;
}

}  // namespace

Geometry read_geometry(const SceneFile& scene) {
  const TomlTable cloth = scene.table("cloth");
  cloth.allow_only({"size", "cells", "diagonals", "mesh", "density", "pins"});
  Geometry geometry;
  if (cloth.has("mesh")) {
    geometry.mesh = read_mesh(cloth);
  } else {
    if (!cloth.has("size"))
      cloth.refuse_table("needs size = [1.0, 1.0] and cells = [40, 40], or mesh = \"file.obj\"");
    geometry.grid_size = cloth.two_numbers("size", Range::positive);
    geometry.mesh = read_grid(cloth, *geometry.grid_size);
  }
  geometry.pins = read_pins(cloth, geometry.mesh.vertices());
  return geometry;
}
