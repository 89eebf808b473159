// A scene is refused in one clear line, or all its numbers are finite, and its effective text is a scene that
// gives the same text again.
#include "fuzz/fuzz.h"
#include "scene/step_names.h"

namespace {

void check_scene(const Scene& scene, const std::string& program) {
  const Cloth& cloth = scene.cloth;
  require(cloth.mass.allFinite() && cloth.mass.minCoeff() > 0, "masses are finite and positive");
  require(cloth.inverse_mass.allFinite(), "inverse masses are finite");
  require(scene.start.x.allFinite() && scene.start.v.allFinite(), "the start is finite");
  require(scene.time.steps() >= 1, "there is a step");
  const Scene again = read_scene(input_file("scene.toml", scene.effective), program);
  require(again.effective == scene.effective, "the effective scene reads itself back");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  for (const std::string& program : step_names()) {
    const std::filesystem::path path = input_scene(text);
    if (has_many_cells(path, 10000)) return 0;
    try {
      check_scene(read_scene(path, program), program);
    } catch (const BadInput& refusal) {
      require_clear(refusal);
    }
  }
  return 0;
}
