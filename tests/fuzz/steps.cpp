// Ten time steps of a small scene in each of the five steps. With the definite matrix an implicit step never
// makes a position that is not finite.
#include "fuzz/fuzz.h"
#include "math/direct_solver.h"
#include "math/preconditioner.h"
#include "ways/simulator.h"

namespace {

constexpr int most_cells = 30, most_vertices = 60;

void take_ten_steps(const Configuration& configuration, const std::filesystem::path& path) {
  Scene scene = read_scene(path, program_of(configuration.step));
  if (scene.cloth.vertices() > most_vertices) return;
  try {
    const auto simulator = make_simulator(configuration, scene.cloth);
    State state = scene.start;
    for (int step = 0; step < 10; ++step) simulator->step(scene.time.h, state);
    require(configuration.step <= 2 || configuration.method.jacobian == Jacobian::bw98 ||
                state.x.allFinite(),
            "positions are finite");
  } catch (const std::invalid_argument&) {
    // this cloth cannot have this method
  }
}

}  // namespace

// The length of the input chooses the method.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::filesystem::path path = input_scene({reinterpret_cast<const char*>(data), size});
  if (has_many_cells(path, most_cells)) return 0;
  for (int step = 1; step <= 5; ++step) try {
      Configuration configuration{.step = step};
      Method& method = configuration.method;
      method.jacobian = size % 4 == 0 ? Jacobian::bw98 : Jacobian::definite;
      method.newton = size % 3 == 0 ? 20 : 1;
      method.solver = solver_names[size % solver_names.size()];
      method.preconditioner = preconditioner_names[size % preconditioner_names.size()];
      take_ten_steps(configuration, path);
    } catch (const BadInput& refusal) {
      require_clear(refusal);
    }
  return 0;
}
