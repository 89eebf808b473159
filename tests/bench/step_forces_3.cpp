#include <memory>

#include "bench/step_forces.h"
#include "step03_implicit/time_step.h"

std::function<void()> forces_of_step_3(const Cloth& cloth, const State& state) {
  const auto system = std::make_shared<step03::System>(cloth);
  return [&, system] { step03::forces(cloth, state, *system); };
}
