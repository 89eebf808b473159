// OSMesa and EGL drive the same llvmpipe: their pictures must agree to the last byte. Each brings
// all of OpenGL's functions, so each draws in a program of its own.
#include <gtest/gtest.h>
#include <unistd.h>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace backends_test {

TEST(Backends, OsMesaAndEglDrawTheSame) {
#if !defined(OSMESA_FRAMES) || !defined(EGL_FRAMES)
  GTEST_SKIP() << "only one of OSMesa and EGL was found when the project was configured";
#else
  const auto frames = [](const std::string& program, const std::string& name) {
    const std::filesystem::path path =
        std::filesystem::temp_directory_path() / (name + "_frames_" + std::to_string(getpid()));
    EXPECT_EQ(std::system((program + " " + path.string()).c_str()), 0) << name;
    std::ifstream file(path, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    std::filesystem::remove(path);
    return bytes;
  };
  const std::string osmesa = frames(OSMESA_FRAMES, "osmesa"), egl = frames(EGL_FRAMES, "egl");
  EXPECT_EQ(osmesa.size(), 3u * 320 * 180 * 3);
  EXPECT_TRUE(osmesa == egl) << "the pictures differ";
#endif
}

}  // namespace backends_test
