#include "program/stage.h"

#include <algorithm>

#include "picture/camera.h"
#include "program/diagnostics.h"

namespace {

using Box = Eigen::AlignedBox3d;

// A pinned cloth swings about its pins: no lower than its longest reach, and as far to the other
// side as it starts on this one, or all around if it is given a velocity.
Box swing(const Scene& scene, const Box& start) {
  Box pins;
  for (const Pin& pin : scene.cloth.pins)
    for (const double t : {0.0, scene.time.end})
      pins.extend(Vec3(scene.start.x.segment<3>(3 * pin.vertex) + t * pin.velocity));
  double reach = 0;
  for (int i = 0; i < scene.cloth.vertices(); ++i) {
    double nearest = 1e300;
    for (const Pin& pin : scene.cloth.pins) {
      const Vec3 x_pin = scene.start.x.segment<3>(3 * pin.vertex);
      nearest = std::min(nearest, (scene.start.x.segment<3>(3 * i) - x_pin).norm());
    }
    reach = std::max(reach, nearest);
  }
  Box box = start;
  const bool pushed = scene.start.v.squaredNorm() > 0;
  for (int axis : {0, 2}) {
    const double aside = pushed ? reach
                                : std::max(pins.min()[axis] - start.min()[axis],
                                           start.max()[axis] - pins.max()[axis]);
    box.extend(Vec3(pins.min() - aside * Vec3::Unit(axis)));
    box.extend(Vec3(pins.max() + aside * Vec3::Unit(axis)));
  }
  if (scene.cloth.gravity) box.extend(Vec3(pins.min() - reach * Vec3::UnitY()));
  if (pushed) box.extend(Vec3(pins.max() + reach * Vec3::UnitY()));
  return box;
}

// The centre of a free cloth flies like a stone; the cloth may turn about it.
Box flight(const Scene& scene, const Box& start) {
  const double t = scene.time.end, mass = scene.cloth.mass.sum() / 3;
  Vec3 momentum = Vec3::Zero();
  for (int i = 0; i < scene.cloth.vertices(); ++i)
    momentum += scene.cloth.mass[3 * i] * scene.start.v.segment<3>(3 * i);
  const Vec3 g = scene.cloth.gravity.value_or(Vec3::Zero());
  const double radius = start.diagonal().norm() / 2;
  Box box = start;
  for (const double moment : {0.0, t / 2, t}) {
    const Vec3 centre = start.center() + momentum / mass * moment + g * moment * moment / 2;
    box.extend(Vec3(centre - Vec3::Constant(radius)));
    box.extend(Vec3(centre + Vec3::Constant(radius)));
  }
  return box;
}

// The distance from the target to the eye at which the whole box fits into a 16:9 picture: for
// every corner, its depth and its distance from the line of sight.
double distance_to_see(const Box& box, const Vec3& target, const Vec3& towards) {
  const double margin = 1.08, up_slope = std::tan(field_of_view / 2),
               right_slope = up_slope * 16 / 9;
  const Vec3 right = Vec3::UnitY().cross(towards).normalized(), up = towards.cross(right);
  double distance = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 offset = box.corner(Box::CornerType(corner)) - target;
    const double aside =
        std::max(std::abs(offset.dot(right)) / right_slope, std::abs(offset.dot(up)) / up_slope);
    distance = std::max(distance, offset.dot(towards) + margin * aside);
  }
  return distance;
}

}  // namespace

Stage make_stage(const Scene& scene) {
  const Box start = box_of(scene.start.x);
  const Box box = scene.cloth.pins.empty() ? flight(scene, start) : swing(scene, start);
  const double size = std::max(start.diagonal().norm() / std::sqrt(2.0), 1e-6);

  Stage stage;
  stage.target = scene.camera.target.value_or(box.center());
  const Vec3 towards = Vec3(0.45, 0.3, 1).normalized();
  stage.eye = scene.camera.eye.value_or(stage.target +
                                        distance_to_see(box, stage.target, towards) * towards);
  stage.ground = box.min().y() - 0.1 * size;
  stage.size = size;
  return stage;
}
