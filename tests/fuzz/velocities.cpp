// A table of velocities is refused in one clear line, or it is written and read back bit for bit.
#include "scene/velocities.h"

#include "fuzz/fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::filesystem::path path =
      input_file("velocities.csv", {reinterpret_cast<const char*>(data), size});
  for (const int vertices : {1, 4}) try {
      const VecX v = read_velocities(path, vertices);
      require(v.size() == 3 * vertices && v.allFinite(), "three finite numbers per vertex");
      write_velocities(path, v);
      require(read_velocities(path, vertices) == v, "the same velocities come back");
    } catch (const BadInput& refusal) {
      require_clear(refusal);
    }
  return 0;
}
