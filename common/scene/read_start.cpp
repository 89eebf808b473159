#include <cmath>
#include <numbers>

#include "scene/scene_file.h"
#include "scene/velocities.h"

namespace {

constexpr double pi = std::numbers::pi;

// A perfectly flat sheet has no reason to fold to one side rather than the other. This 1 mm wrinkle
// gives it one, the same for every mesh of the same sheet; the phases 1 and 2 keep its zeros off
// the middle, the edges and the vertices, and leave no mirror symmetry:
//
//   z = 1 mm sin(2π 3u/size_u + 1) sin(2π 2v/size_v + 2)
double wrinkle(const Vec2& uv, const Vec2& size) {
  return 1e-3 * std::sin(2 * pi * 3 * uv.x() / size.x() + 1) *
         std::sin(2 * pi * 2 * uv.y() / size.y() + 2);
}

// The sheet, laid at (u, 0, −v), upright: (u, v, wrinkle).
VecX hanging(const VecX& laid, const Vec2& size) {
  VecX x(laid.size());
  for (Eigen::Index c = 0; c < laid.size(); c += 3) {
    const Vec2 uv(laid[c], -laid[c + 2]);
    x.segment<3>(c) = Vec3(uv.x(), uv.y(), wrinkle(uv, size));
  }
  return x;
}

VecX read_positions(const TomlTable& start, const Geometry& geometry) {
  const std::filesystem::path path = start.existing_file("positions");
  const VecX x = read_obj_vertices(path);
  if (x.size() != geometry.mesh.x.size())
    start.refuse("positions", path.string() + " has " + std::to_string(x.size() / 3) +
                                  " vertices, but the cloth has " +
                                  std::to_string(geometry.mesh.vertices()) +
                                  "; it must have as many");
  return x;
}

VecX start_positions(const TomlTable& start, const Geometry& geometry) {
  if (start.has("positions")) {
    if (start.has("shape"))
      start.refuse("shape", "positions says where the cloth is; take out one");
    return read_positions(start, geometry);
  }
  if (!start.has("shape")) return geometry.mesh.x;
  if (!geometry.grid_size)
    start.refuse("shape", "a mesh starts as its file has it, or at positions = \"start.obj\"");
  const bool flat = start.one_of("shape", {"flat", "hanging"}) == "flat";
  return flat ? geometry.mesh.x : hanging(geometry.mesh.x, *geometry.grid_size);
}

// v_i = velocity + spin × (x_i − c),   c = Σ m_i x_i / Σ m_i
VecX moving(const Cloth& cloth, const VecX& x, const Vec3& velocity, const Vec3& spin) {
  Vec3 moment = Vec3::Zero();
  double mass = 0;
  for (int i = 0; i < cloth.vertices(); ++i) {
    moment += cloth.mass[3 * i] * x.segment<3>(3 * i);
    mass += cloth.mass[3 * i];
  }
  const Vec3 center = moment / mass;
  VecX v(x.size());
  for (int i = 0; i < cloth.vertices(); ++i) {
    const Vec3 arm = x.segment<3>(3 * i) - center;
    v.segment<3>(3 * i) = velocity + spin.cross(arm);
  }
  return v;
}

VecX start_velocities(const TomlTable& start, const Cloth& cloth, const VecX& x) {
  if (start.has("velocities")) {
    for (const char* key : {"velocity", "spin"})
      if (start.has(key)) start.refuse(key, "velocities gives each vertex its own; take out one");
    return read_velocities(start.existing_file("velocities"), cloth.vertices());
  }
  const auto given = [&](const char* key) -> Vec3 {
    return start.has(key) ? start.three_numbers(key) : Vec3::Zero();
  };
  return moving(cloth, x, given("velocity"), given("spin"));
}

}  // namespace

State read_start(const SceneFile& scene, const Geometry& geometry, const Cloth& cloth) {
  State state = {geometry.mesh.x, VecX::Zero(geometry.mesh.x.size())};
  if (scene.has("start")) {
    const TomlTable start = scene.table("start");
    start.allow_only({"shape", "positions", "velocity", "spin", "velocities"});
    state.x = start_positions(start, geometry);
    state.v = start_velocities(start, cloth, state.x);
  }
  for (const Pin& pin : cloth.pins) {
    auto v = state.v.segment<3>(3 * pin.vertex);
    v = pin.S * v.eval() + pin.velocity;
  }
  return state;
}
