#include "scene/scene_file.h"

#include <algorithm>
#include <cctype>
#include <cstring>
#include <limits>

#include "scene/step_names.h"
#include "text/text.h"
#include "text/text_file.h"

namespace {

// The tables of a scene and the first step that teaches each.
struct KnownTable {
  std::string name;
  int step;
};

// Every term brings its table (math/cloth.h), and all of them bring [damping], which the second
// step teaches. In the order in which the steps teach them.
std::vector<KnownTable> tables_of_terms() {
  std::vector<KnownTable> tables = {{"damping", 2}};
  for (const std::string& name : term_tables())
    for (const TermInfo& term : term_infos())
      if (term.table == name) {
        tables.push_back({name, term.first_step});
        break;
      }
  std::stable_sort(tables.begin(), tables.end(),
                   [](const KnownTable& a, const KnownTable& b) { return a.step < b.step; });
  return tables;
}

const std::vector<KnownTable>& known_tables() {
  static const std::vector<KnownTable> all = [] {
    std::vector<KnownTable> tables = {{"cloth", 1}, {"gravity", 1}};
    for (KnownTable& table : tables_of_terms()) tables.push_back(std::move(table));
    for (const char* name : {"start", "time", "camera"}) tables.push_back({name, 1});
    return tables;
  }();
  return all;
}

const KnownTable* find_table(std::string_view name) {
  for (const KnownTable& table : known_tables())
    if (table.name == name) return &table;
  return nullptr;
}

// The tables that a step teaches, without those of later steps.
Names tables_of(int step) {
  Names names;
  for (const KnownTable& table : known_tables())
    if (table.step <= step) names.push_back(table.name);
  return names;
}

bool every_scene_needs(const std::string& table) {
  return table == "cloth" || table == "time";
}

// The tables that a scene can do without.
Names optional_tables() {
  Names names = tables_of(int(step_names().size()));
  std::erase_if(names, every_scene_needs);
  return names;
}

[[noreturn]] void refuse_setting(const std::filesystem::path& file, const std::string& setting,
                                 const std::string& reason) {
  throw BadInput(file.string() + ": --set " + one_line(setting) + ": " + reason);
}

// The table and the key of TABLE.KEY=VALUE.
std::array<std::string, 2> place_of(const std::filesystem::path& file, const std::string& setting) {
  const size_t dot = setting.find('.'), equals = setting.find('=');
  if (dot == 0 || equals == setting.npos || !(dot < equals - 1))
    refuse_setting(file, setting, "it must be TABLE.KEY=VALUE, such as stretch.k=1e4");
  return {setting.substr(0, dot), setting.substr(dot + 1, equals - dot - 1)};
}

// A table with nothing but the value of TABLE.KEY=VALUE. It is written as in the file, but a word needs no
// quotes.
toml::table value_of(const std::filesystem::path& file, const std::string& setting) {
  const std::string value = setting.substr(setting.find('=') + 1);
  const auto is_in_a_word = [](unsigned char c) {
    return std::isalnum(c) || std::strchr("-_./", c);
  };
  const bool is_word = !value.empty() && std::isalpha(static_cast<unsigned char>(value[0])) &&
                       std::ranges::all_of(value, is_in_a_word);
  try {
    toml::table parsed = toml::parse("value = " + (is_word ? '"' + value + '"' : value));
    if (parsed.size() == 1) return parsed;
  } catch (const toml::parse_error&) {
  }
  refuse_setting(file, setting,
                 "the value must be written as in the scene: a number, \"text\" or a list");
}

// No key may be set twice, be it by --set or by --h, --end, --frames or --cells.
void check_each_once(const std::filesystem::path& file, const Overrides& overrides) {
  Names given;
  if (overrides.h) given.push_back("time.h");
  if (overrides.end) given.push_back("time.end");
  if (overrides.frames) given.push_back("time.frames");
  if (overrides.cells) given.push_back("cloth.cells");
  for (const std::string& setting : overrides.set) {
    const auto [table, key] = place_of(file, setting);
    if (std::ranges::count(given, table + "." + key) > 0)
      refuse_setting(file, setting, "the command line sets " + key + " of [" + table + "] twice");
    if (std::ranges::count(overrides.without, table) > 0)
      refuse_setting(file, setting, "the command line leaves out [" + table + "], too");
    given.push_back(table + "." + key);
  }
}

}  // namespace

SceneFile::SceneFile(const std::filesystem::path& path, const std::string& program,
                     const Overrides& overrides)
    : file(path), step(step_number(program)), tables(read_toml(path)) {
  tables.erase("run");  // see options_of_run
  take_out(overrides.without);
  apply(overrides);
  check_tables(program);
}

std::string SceneFile::effective() const {
  toml::table scene = tables;
  for (const auto& [table, key] :
       {std::pair{"cloth", "mesh"}, {"start", "positions"}, {"start", "velocities"}})
    if (toml::node* node = scene[table][key].node(); node && node->is_string()) {
      const std::filesystem::path path = file.parent_path() / *node->value<std::string>();
      if (no_file(path).empty())
        scene[table].as_table()->insert_or_assign(key, std::filesystem::absolute(path).string());
    }
  std::string text;
  for (const KnownTable& known : known_tables()) {
    const toml::table* table = scene[known.name].as_table();
    if (!table) continue;
    text += "\n[" + known.name + "]\n";
    for (const auto& [key, value] : *table)
      text += std::string(key.str()) + " = " + as_toml(value) + "\n";
  }
  return text;
}

TomlTable SceneFile::table(const std::string& name) const {
  const toml::table* table = tables[name].as_table();
  if (!table)
    throw BadInput(file.string() + ": the table [" + name + "] is missing; every scene needs it");
  return {file, "[" + name + "]", *table};
}

Names SceneFile::known(Names names) const {
  std::erase_if(names, [&](const std::string& name) { return find_table(name)->step > step; });
  return names;
}

// A term goes with its damping.
void SceneFile::take_out(const std::vector<std::string>& without) {
  for (const std::string& name : without) {
    const std::string refused = file.string() + ": --without " + name + ": ";
    if (!find_table(name))
      throw BadInput(refused + "there is no such table; " + valid_names(name, optional_tables()));
    if (every_scene_needs(name))
      throw BadInput(refused + "every scene needs [" + name +
                     "]; the other tables can be left out");
    tables.erase(name);
    if (toml::table* damping = tables["damping"].as_table()) damping->erase(name);
  }
}

void SceneFile::check_tables(const std::string& program) const {
  for (const auto& [key, value] : tables) {
    const std::string name(key.str()), line = location(file, value);
    const KnownTable* known = find_table(name);
    if (!known)
      throw BadInput(
          line + "there is no " +
          (value.is_table() ? "table [" + name + "]" : "key " + name + " outside of the tables") +
          "; " + valid_names(name, tables_of(step)));
    if (!value.is_table()) throw BadInput(line + name + " must be one table, [" + name + "]");
    check_step(program, name, value);
  }
  if (const toml::table* damping = tables["damping"].as_table())
    for (const auto& [key, value] : *damping)
      if (find_table(key.str())) check_step(program, std::string(key.str()), value);
  if (step < 4) check_pins(program);
}

void SceneFile::check_step(const std::string& program, const std::string& name,
                           const toml::node& value) const {
  const int first = find_table(name)->step;
  if (first > step)
    throw BadInput(location(file, value) + program + " does not model [" + name + "]; " +
                   step_names()[first - 1] + " does" +
                   (is_given(value) ? "" : ". --without " + name + " runs the scene without it"));
}

// A pin that is a table belongs to the filter of conjugate gradients.
void SceneFile::check_pins(const std::string& program) const {
  const toml::array* pins = tables["cloth"]["pins"].as_array();
  if (!pins) return;
  for (const toml::node& pin : *pins)
    if (pin.is_table())
      throw BadInput(location(file, pin) + program +
                     " does not model pins with single directions or a velocity; " +
                     step_names()[3] +
                     " does. A pin that is only a name or a number runs in every step");
}

// The values of the command line replace those of the file and are checked like them.
void SceneFile::apply(const Overrides& overrides) {
  check_each_once(file, overrides);
  for (const std::string& setting : overrides.set) set(setting);
  if (toml::table* time = tables["time"].as_table()) {
    if (overrides.h) time->insert_or_assign("h", *overrides.h);
    if (overrides.end) time->insert_or_assign("end", *overrides.end);
    if (overrides.frames) time->insert_or_assign("frames", *overrides.frames);
  }
  if (overrides.cells) apply_cells(*overrides.cells);
  move_still();
}

// --set TABLE.KEY=VALUE. The value is copied, because a copy has no line in a file.
void SceneFile::set(const std::string& setting) {
  const auto [table, key] = place_of(file, setting);
  if (!find_table(table))
    refuse_setting(file, setting,
                   "there is no table [" + table + "]; " + valid_names(table, tables_of(step)));
  if (!tables.contains(table)) tables.insert(table, toml::table());
  const toml::table value = value_of(file, setting);
  if (toml::table* target = tables[table].as_table())
    value.begin()->second.visit([&, k = key](const auto& v) { target->insert_or_assign(k, v); });
}

// If the command line sets the end, a still that would come after it moves to the end.
void SceneFile::move_still() {
  const toml::node *end = tables["time"]["end"].node(), *still = tables["camera"]["still"].node();
  if (!end || !still || !end->is_number() || !still->is_number() || !is_given(*end)) return;
  if (*still->value<double>() > *end->value<double>())
    tables["camera"].as_table()->insert_or_assign("still", *end->value<double>());
}

// With other cells a vertex number means another place, or none.
void SceneFile::check_numbered_pins(int cells) const {
  const toml::array* pins = tables["cloth"]["pins"].as_array();
  if (!pins) return;
  for (const toml::node& pin : *pins) {
    const toml::node* vertex = pin.is_table() ? pin.as_table()->get("vertex") : &pin;
    if (vertex && vertex->is_integer())
      throw BadInput(location(file, *vertex) + "--cells " + std::to_string(cells) + ": pin " +
                     std::to_string(*vertex->value<int64_t>()) +
                     " is the number of a vertex, which on other cells lies elsewhere; pin named "
                     "corners and edges, or change cells and pins in the scene");
  }
}

// --cells N: N along u, and along v as many as keep the shape of the cells.
void SceneFile::apply_cells(int cells) {
  toml::table* cloth = tables["cloth"].as_table();
  if (!cloth) return;
  if (cloth->contains("mesh"))
    throw BadInput(file.string() + ": --cells " + std::to_string(cells) +
                   ": only a grid has cells; the cloth of this scene is a mesh");
  const auto old = [&](size_t i) { return (*cloth)["cells"][i].value_or(int64_t(1)); };
  const double ratio = old(0) > 0 && old(1) > 0 ? double(old(1)) / double(old(0)) : 1;
  const double along_v = std::min(cells * ratio, double(std::numeric_limits<int>::max()));
  const int64_t cells_v = cells < 1 ? cells : std::max(std::llround(along_v), 1LL);
  if (cells != old(0) || cells_v != old(1)) check_numbered_pins(cells);
  cloth->insert_or_assign("cells", toml::array{cells, cells_v});
}

std::vector<std::string> options_of_run(const std::filesystem::path& file,
                                        const std::string& program) {
  const toml::table scene = read_toml(file);
  if (!scene.contains("run")) return {};
  const toml::table* run = scene["run"].as_table();
  if (!run) throw BadInput(location(file, *scene.get("run")) + "run must be one table, [run]");
  const TomlTable table(file, "[run]", *run);
  table.allow_only({"program", "version", "options"});
  if (table.text("program") != program || !table.has("options")) return {};
  std::vector<std::string> options;
  for (const toml::node& option : table.list("options", "a list of options")) {
    if (!option.is_string()) table.refuse("options", "it must be a list of options, in quotes");
    options.push_back(*option.value<std::string>());
  }
  return options;
}

std::string value_in_scene(const std::filesystem::path& file, const char* table,
                           const char* key) try {
  const toml::table scene = read_toml(file);
  const toml::node* value = scene[table][key].node();
  return value ? as_toml(*value) : "";
} catch (const BadInput&) {
  return "";
}
