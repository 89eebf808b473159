#include <memory>

#include "bench/step_forces.h"
#include "step01_explicit/time_step.h"

std::function<void()> forces_of_step_1(const Cloth& cloth, const State& state) {
  const auto system = std::make_shared<step01::System>(cloth);
  return [&, system] { step01::forces(cloth, state, *system); };
}
