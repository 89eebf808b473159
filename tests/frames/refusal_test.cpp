// A scene that cannot be drawn is refused before anything is drawn, with the numbers in the
// message.
#include <gtest/gtest.h>
#include <limits>
#include <string>

#include "picture/renderer.h"
#include "test_scene.h"

namespace refusal_test {

std::string refusal(const TestScene& scene) {
  try {
    Renderer(scene.surface).draw(scene.stage, scene.x, scene.style, scene.strain);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "nothing was refused";
}

void expect_mentions(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << text;
  EXPECT_EQ(text.find('\n'), std::string::npos) << text;
}

TEST(Refusal, NamesTheVertexThatIsNotFinite) {
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    TestScene scene = hung_cloth();
    scene.x[3 * 12 + 1] = bad;
    expect_mentions(refusal(scene), "vertex 12 is not finite");
  }
}

TEST(Refusal, HugePositionsAreDrawn) {
  TestScene scene = hung_cloth();
  scene.x *= 1e200;
  EXPECT_EQ(refusal(scene), "nothing was refused");
}

TEST(Refusal, Sizes) {
  TestScene scene = hung_cloth();
  scene.style.width = 0;
  expect_mentions(refusal(scene), "0x180");
  scene.style.width = -5;
  expect_mentions(refusal(scene), "-5x180");
  scene.style.width = 20000;
  expect_mentions(refusal(scene), "1 to 8192");  // 16384 / 2
  scene.style = {.width = 320, .height = 180, .supersampling = 0};
  expect_mentions(refusal(scene), "supersampling");
}

TEST(Refusal, CheckSizeNeedsNoRenderer) {
  EXPECT_NO_THROW(check_size(1, 1));
  EXPECT_NO_THROW(check_size(5461, 5461));
  for (const auto& [width, height] : {std::pair{0, 720}, {1280, 0}, {5462, 10}, {10, -1}})
    EXPECT_THROW(check_size(width, height), std::invalid_argument) << width << "x" << height;
}

TEST(Refusal, Strain) {
  TestScene scene = hung_cloth();
  scene.style.strain_scale = 0.1;
  scene.strain.resize(0);
  expect_mentions(refusal(scene), "0 strains for 625 vertices");
  scene = hung_cloth();
  scene.style.strain_scale = 0.1;
  scene.strain[7] = std::numeric_limits<double>::quiet_NaN();
  expect_mentions(refusal(scene), "the strain of vertex 7");
  scene = hung_cloth();
  scene.style.strain_scale = 0;
  expect_mentions(refusal(scene), "strain scale");
}

TEST(Refusal, IndicesAndCounts) {
  TestScene scene = hung_cloth();
  scene.surface.faces[3][1] = 625;
  expect_mentions(refusal(scene), "face 3 names vertex 625");
  scene = hung_cloth();
  scene.surface.pins = {-1};
  expect_mentions(refusal(scene), "vertex -1");
  scene = hung_cloth();
  scene.x.conservativeResize(100);
  expect_mentions(refusal(scene), "100 coordinates");
  scene = hung_cloth();
  scene.surface.texture.pop_back();
  expect_mentions(refusal(scene), "1152 faces, but texture for 1151");
}

TEST(Refusal, Stage) {
  TestScene scene = hung_cloth();
  scene.stage.size = 0;
  expect_mentions(refusal(scene), "size of the scene");
  scene = hung_cloth();
  scene.stage.eye = scene.stage.target;
  expect_mentions(refusal(scene), "same point");
}

TEST(Refusal, DriverThatWouldCrashOsMesa) {
  setenv("GALLIUM_DRIVER", "swrast", 1);
  try {
    Renderer renderer(hung_cloth().surface);
    ADD_FAILURE() << "swrast was accepted";
  } catch (const std::runtime_error& error) {
    expect_mentions(error.what(), "GALLIUM_DRIVER is \"swrast\"");
  }
  unsetenv("GALLIUM_DRIVER");
}

}  // namespace refusal_test
