#include "program/watch.h"

#include <algorithm>

namespace {

EnergyScale energy_scale(const Scene& scene, const Energies& start) {
  if (!scene.cloth.gravity) return {std::max(start.total(), 1e-12), false};
  return {scene.cloth.mass.sum() / 3 * scene.cloth.gravity->norm() *
              box_of(scene.start.x).diagonal().norm(),
          true};
}

bool pins_move(const Cloth& cloth) {
  return std::any_of(cloth.pins.begin(), cloth.pins.end(),
                     [](const Pin& pin) { return pin.moves(); });
}

}  // namespace

Watch::Watch(const Scene& scene_)
    : scene(scene_), start(energies(scene.cloth, scene.start)), scale(energy_scale(scene, start)) {}

const Sample& Watch::sample(long step, const State& state) {
  if (step == latest_step) return latest;
  latest_step = step;
  latest = {energies(scene.cloth, state), max_stretch(scene.mesh, state.x), lowest(state.x)};
  most_stretch = std::max(most_stretch, latest.max_stretch);
  const double gain = latest.energies.total() - start.total();
  most_gained = std::max(most_gained, gain);
  if (gain > 1e-3 * scale.joule && !pins_move(scene.cloth)) ++gained;
  return latest;
}
