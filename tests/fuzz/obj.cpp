// A mesh is refused in one clear line, or its faces name vertices that exist, and the file that is written
// of it is the same mesh.
#include "fuzz/fuzz.h"

namespace {

void check_mesh(const Mesh& mesh) {
  require(mesh.x.allFinite(), "vertices are finite");
  require(mesh.rest.size() == mesh.faces.size(), "a rest shape per face");
  for (const Face& face : mesh.faces)
    for (const int vertex : face)
      require(vertex >= 0 && vertex < mesh.vertices(), "a face names vertices that exist");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::filesystem::path path =
      input_file("mesh.obj", {reinterpret_cast<const char*>(data), size});
  try {
    const Mesh mesh = read_obj(path);
    check_mesh(mesh);
    check(mesh, path);
    write_obj(path, mesh, mesh.x);
    const Mesh again = read_obj(path);
    require(again.faces == mesh.faces, "the same faces come back");
    require((again.x - mesh.x).norm() <= 1e-14 * mesh.x.norm(), "the same vertices come back");
  } catch (const BadInput& refusal) {
    require_clear(refusal);
  }
  try {
    require(read_obj_vertices(path).allFinite(), "start positions are finite");
  } catch (const BadInput& refusal) {
    require_clear(refusal);
  }
  return 0;
}
