#include "scene/scene.h"

#include <algorithm>

#include "scene/make_cloth.h"
#include "scene/scene_file.h"

namespace {

constexpr double most_steps = 1e9;
constexpr int most_frames = 9999;

Time read_time(const SceneFile& scene) {
  const TomlTable table = scene.table("time");
  table.allow_only({"h", "end", "frames"});
  Time time;
  time.h = table.number("h", Range::positive);
  time.end = table.number("end", Range::positive);
  if (table.has("frames")) time.frames = table.whole_number("frames");
  if (!(time.end / time.h <= most_steps))
    table.refuse("end", "end / h is more than 1e9 steps; take a larger h or a smaller end");
  if (time.frames > most_frames) table.refuse("frames", "it must be from 1 to 9999");
  return time;
}

// y is up.
std::optional<Vec3> read_gravity(const SceneFile& scene) {
  if (!scene.has("gravity")) return {};
  const TomlTable table = scene.table("gravity");
  table.allow_only({"g"});
  return Vec3(0, -table.number("g", Range::not_negative), 0);
}

std::optional<Term> read_term(const SceneFile& scene, const char* name) {
  if (!scene.has(name)) return {};
  const TomlTable table = scene.table(name);
  table.allow_only({"k"});
  return Term{name, table.number("k", Range::not_negative)};
}

const std::vector<std::pair<std::string, BendModel>> bend_models = {
    {"dihedral", BendModel::dihedral},
    {"bridson", BendModel::bridson},
    {"quadratic", BendModel::quadratic},
    {"springs", BendModel::springs}};

BendModel read_bend_model(const TomlTable& table) {
  if (!table.has("model")) return BendModel::dihedral;
  Names names;
  for (const auto& [name, model] : bend_models) names.push_back(name);
  const std::string chosen = table.one_of("model", names);
  for (const auto& [name, model] : bend_models)
    if (name == chosen) return model;
  return BendModel::dihedral;
}

// [bend] has a k, or the modulus B that k follows from.
void read_bend(const SceneFile& scene, Model& model) {
  if (!scene.has("bend")) return;
  const TomlTable table = scene.table("bend");
  table.allow_only({"model", "k", "B"});
  model.bend_model = read_bend_model(table);
  if (table.has("B") && table.has("k"))
    table.refuse("B", "k follows from B; take out one of the two");
  if (!table.has("B") && !table.has("k"))
    table.refuse_table("needs k = a number not less than 0, or B, the modulus that k follows from");
  if (table.has("k")) {
    model.bend = Term{"bend", table.number("k", Range::not_negative)};
    return;
  }
  const std::optional<double> k =
      stiffness_of_modulus(model.bend_model, table.number("B", Range::not_negative));
  if (!k)
    table.refuse("B", "springs have no bending modulus; give k in N/m, or take another model");
  model.bend = Term{"bend", *k};
}

void check_bend(const SceneFile& scene, const Mesh& mesh, const Model& model) {
  const bool rests_flat =
      model.bend_model == BendModel::quadratic || model.bend_model == BendModel::springs;
  const bool in_space =
      std::find(mesh.in_space.begin(), mesh.in_space.end(), true) != mesh.in_space.end();
  if (model.bend && rests_flat && in_space)
    scene.table("bend").refuse("model",
                               "this model rests flat, and the mesh has faces without texture "
                               "coordinates to lay them flat; use dihedral or bridson, which rest "
                               "there as the mesh lies");
}

// Damping belongs to a term: without its k there is nothing to damp.
void read_damping(const SceneFile& scene, Model& model) {
  if (!scene.has("damping")) return;
  const TomlTable table = scene.table("damping");
  table.allow_only(scene.known({"stretch", "shear", "bend"}));
  for (auto [name, term] : {std::pair("stretch", &model.stretch), std::pair("shear", &model.shear),
                            std::pair("bend", &model.bend)}) {
    if (!table.has(name)) continue;
    const double kd = table.number(name, Range::not_negative);
    const std::string term_name = name;
    if (!*term)
      table.refuse(name, "the scene has no [" + term_name + "] to damp; add [" + term_name +
                             "], or take out this key");
    (*term)->kd = kd;
  }
}

Model read_model(const SceneFile& scene) {
  Model model;
  model.density = scene.table("cloth").number("density", Range::positive);
  model.gravity = read_gravity(scene);
  model.stretch = read_term(scene, "stretch");
  model.shear = read_term(scene, "shear");
  read_bend(scene, model);
  read_damping(scene, model);
  return model;
}

// With --end the still stays within the run that it asks for.
Camera read_camera(const SceneFile& scene, double end, bool end_is_given) {
  Camera camera;
  if (!scene.has("camera")) return camera;
  const TomlTable table = scene.table("camera");
  table.allow_only({"eye", "target", "still"});
  if (table.has("eye")) camera.eye = table.three_numbers("eye");
  if (table.has("target")) camera.target = table.three_numbers("target");
  if (camera.eye && camera.target && *camera.eye == *camera.target)
    table.refuse("eye", "it must be another point than target");
  if (!table.has("still")) return camera;
  const double still = table.number("still", Range::not_negative);
  if (still > end && !end_is_given) table.refuse("still", "it must be from 0 to the end of [time]");
  camera.still = std::min(still, end);
  return camera;
}

}  // namespace

// What is quickly checked comes first, the mesh and what needs it last.
Scene read_scene(const std::filesystem::path& path, const std::string& program,
                 const Overrides& overrides) {
  const SceneFile file(path, program, overrides);
  Scene scene;
  scene.file = path;
  scene.time = read_time(file);
  scene.camera = read_camera(file, scene.time.end, overrides.end.has_value());
  Model model = read_model(file);
  Geometry geometry = read_geometry(file);
  model.pins = std::move(geometry.pins);
  check_bend(file, geometry.mesh, model);
  scene.cloth = make_cloth(geometry.mesh, model);
  scene.start = read_start(file, geometry, scene.cloth);
  scene.mesh = std::move(geometry.mesh);
  return scene;
}
