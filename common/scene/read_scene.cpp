#include "scene/scene.h"

#include "scene/make_cloth.h"
#include "scene/scene_file.h"
#include "text/text.h"

namespace {

constexpr double most_steps = 1e9;
constexpr int most_frames = 9999;

Time read_time(const SceneFile& scene) {
  const TomlTable table = scene.table("time");
  table.allow_only({"h", "end", "frames"});
  Time time;
  time.h = table.number("h", Range::positive);
  time.end = table.number("end", Range::positive);
  if (table.has("frames")) time.frames = table.whole_number("frames", most_frames);
  if (time.h > time.end * (1 + 1e-6))
    table.refuse("h", "it must not be longer than end = " + shortest(time.end) + " s");
  if (!(time.end / time.h <= most_steps))
    table.refuse("end", "end / h is more than 1e9 steps; take a larger h or a smaller end");
  return time;
}

// y is up.
std::optional<Vec3> read_gravity(const SceneFile& scene) {
  if (!scene.has("gravity")) return {};
  const TomlTable table = scene.table("gravity");
  table.allow_only({"g"});
  return Vec3(0, -table.number("g", Range::not_negative), 0);
}

Model read_model(const SceneFile& scene) {
  Model model;
  model.density = scene.table("cloth").number("density", Range::positive);
  model.gravity = read_gravity(scene);
  read_terms(scene, model);
  return model;
}

Camera read_camera(const SceneFile& scene, double end) {
  Camera camera;
  if (!scene.has("camera")) return camera;
  const TomlTable table = scene.table("camera");
  table.allow_only({"eye", "target", "still"});
  if (table.has("eye")) camera.eye = table.three_numbers("eye");
  if (table.has("target")) camera.target = table.three_numbers("target");
  if (camera.eye && camera.target && !((*camera.eye - *camera.target).norm() > 1e-12))
    table.refuse("eye", "it must be another point than target");
  if (!table.has("still")) return camera;
  camera.still = table.number("still", Range::not_negative);
  if (*camera.still > end) table.refuse("still", "it must be from 0 to the end of [time]");
  return camera;
}

}  // namespace

std::string Scene::name() const {
  const std::filesystem::path directory = absolute(file).parent_path().filename();
  return (directory / file.filename()).string();
}

// Quick checks come first; the mesh and all that needs it last.
Scene read_scene(const std::filesystem::path& path, const std::string& program,
                 const Overrides& overrides) {
  const SceneFile file(path, program, overrides);
  Scene scene;
  scene.file = path;
  scene.effective = file.effective();
  scene.time = read_time(file);
  scene.camera = read_camera(file, scene.time.end);
  Model model = read_model(file);
  Geometry geometry = read_geometry(file);
  model.pins = std::move(geometry.pins);
  check_terms(file, geometry.mesh, model);
  scene.cloth = make_cloth(geometry.mesh, model);
  scene.start = read_start(file, geometry, scene.cloth);
  start_angles(scene.cloth.hinges.elements, scene.start.x);
  start_terms(scene.cloth, scene.start.x);
  scene.mesh = std::move(geometry.mesh);
  return scene;
}
