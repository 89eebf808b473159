// The parsed scene: its tables, the changes that the command line makes in them, and the tables
// that a step teaches. Only the files that read a scene include this.
#pragma once
#include "scene/make_cloth.h"
#include "scene/scene.h"
#include "scene/toml_reader.h"

class SceneFile {
 public:
  // Refuses tables that do not exist, tables that a later step teaches, and damping of their terms.
  SceneFile(const std::filesystem::path& file, const std::string& program, const Overrides&);

  bool has(const std::string& table) const { return tables.contains(table); }
  TomlTable table(const std::string& name) const;  // refuses a scene without it
  Names known(Names names) const;                  // without the tables of later steps

  // The scene as it is run, in TOML: with the changes of the command line, and with absolute paths.
  std::string effective() const;

  const std::filesystem::path file;

 private:
  void take_out(const std::vector<std::string>& without);
  void check_tables(const std::string& program) const;
  void check_step(const std::string& program, const std::string& name, const toml::node&) const;
  void check_pins(const std::string& program) const;
  void apply(const Overrides&);
  void set(const std::string& setting);
  void apply_cells(int cells);
  void move_still();
  void check_numbered_pins(int cells) const;

  int step;  // 3 of step03_implicit
  toml::table tables;
};

// The tables of the terms that a scene can name, each once.
Names term_tables();

// The parts of a scene, each from its table.
struct Geometry {
  Mesh mesh;
  std::optional<Vec2> grid_size;  // m; absent for a mesh from a file
  std::vector<Pin> pins;
};
Geometry read_geometry(const SceneFile&);
Pin read_pin(const TomlTable&, int vertex);  // { fix, velocity }
void read_terms(const SceneFile&, Model&);   // with their damping
void check_terms(const SceneFile&, const Mesh&,
                 const Model&);  // can their models rest as the mesh lies?
State read_start(const SceneFile&, const Geometry&, const Cloth&);
