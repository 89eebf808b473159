// A PNG file cannot be read, or it is written and read back pixel for pixel.
#include "fuzz/fuzz.h"
#include "picture/png.h"

namespace {

void check_picture(const std::filesystem::path& path) {
  const Image image = read_png(path);
  require(image.width > 0 && image.height > 0, "a picture has pixels");
  require(image.rgb.size() == 3 * size_t(image.width) * size_t(image.height), "three bytes each");
  write_png(path, image);
  require(read_png(path).rgb == image.rgb, "the same pixels come back");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::filesystem::path path =
      input_file("frame.png", {reinterpret_cast<const char*>(data), size});
  try {
    read_png_text(path);
  } catch (const std::runtime_error&) {
  }
  try {
    check_picture(path);
  } catch (const std::runtime_error&) {
  }
  return 0;
}
