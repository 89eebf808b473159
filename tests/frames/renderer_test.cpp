#include "picture/renderer.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <cstdlib>
#include <limits>
#include <string>

#include "picture/compare.h"
#include "test_scene.h"

namespace renderer_test {

Image drawn(const TestScene& scene) {
  return Renderer(scene.surface).draw(scene.stage, scene.x, scene.style, scene.strain);
}

TestScene seen_from_behind() {
  TestScene scene = hung_cloth();
  scene.stage.eye.z() *= -1;
  return scene;
}

Colour mean_colour(const Image& image, int left, int top, int right, int bottom) {
  std::array<long, 3> sum{};
  for (int y = top; y < bottom; ++y)
    for (int x = left; x < right; ++x)
      for (std::size_t c = 0; c < 3; ++c) sum[c] += pixel(image, x, y)[c];
  Colour mean;
  for (std::size_t c = 0; c < 3; ++c)
    mean[c] = static_cast<unsigned char>(sum[c] / ((right - left) * (bottom - top)));
  return mean;
}

Colour colour_of_cloth(const Image& image) {
  return mean_colour(image, 130, 70, 190, 110);
}

long pixels_above(const Image& a, const Image& b, int level) {
  const Difference d = compare(a, b);
  return level == 0 ? d.above0 : d.above8;
}

TEST(Renderer, ShowsClothInFrontOfBackground) {
  const Image image = drawn(hung_cloth());
  ASSERT_EQ(image.width, 320);
  ASSERT_EQ(image.height, 180);
  const Colour cloth = colour_of_cloth(image), corner = pixel(image, 2, 2);
  EXPECT_GT(cloth[0], cloth[2] + 60) << "the front of the cloth is red and cream";
  EXPECT_LT(corner[0], corner[2] + 5) << "the background is a cool grey";
  EXPECT_GT(corner[0], 140);
}

TEST(Renderer, SidesDifferInHue) {
  const Colour front = colour_of_cloth(drawn(hung_cloth()));
  const Colour back = colour_of_cloth(drawn(seen_from_behind()));
  EXPECT_GT(front[0], front[2] + 60) << "front: red and cream";
  EXPECT_GT(back[2], back[0] + 40) << "back: blue";
}

TEST(Renderer, TopOfTheClothIsAtTheTopOfThePicture) {
  const TestScene scene = hung_cloth();
  TestScene without = hung_cloth();
  without.surface.pins.clear();
  const Difference pins = compare(drawn(scene), drawn(without));
  EXPECT_GT(pins.above8, 10) << "the pins must be visible";
  EXPECT_LT(pins.bottom, 60) << "the pins must be at the upper corners";
  EXPECT_GT(pins.right - pins.left, 80) << "both pins must be visible";
}

TEST(Renderer, PinIsHiddenBehindTheCloth) {
  TestScene scene = seen_from_behind(), without = seen_from_behind();
  for (TestScene* s : {&scene, &without}) {
    const Vec3 middle = s->x.segment<3>(3 * (12 * 25 + 12));
    s->x.conservativeResize(s->x.size() + 3);
    s->x.tail<3>() = middle + Vec3(0, 0, 0.1);  // a loose vertex on the far side
    s->strain.conservativeResize(s->strain.size() + 1);
    s->surface.pins.clear();
  }
  scene.surface.pins = {25 * 25};
  EXPECT_EQ(compare(drawn(scene), drawn(without)).above0, 0);
  scene.stage.eye.z() *= -1;
  without.stage.eye.z() *= -1;
  EXPECT_GT(compare(drawn(scene), drawn(without)).above8, 10) << "the pin must be visible";
}

TEST(Renderer, CastsASoftShadowOnTheFloor) {
  const TestScene scene = hung_cloth();
  TestScene far = hung_cloth();
  for (Eigen::Index i = 1; i < far.x.size(); i += 3) far.x[i] += 100;  // out of sight
  const Image with = drawn(scene), without = drawn(far);
  int darkest = 255, steepest = 0;
  for (int x = 1; x < 320; ++x)
    for (int y = 145; y < 180; ++y) {
      const int here = pixel(with, x, y)[1], free = pixel(without, x, y)[1];
      EXPECT_LE(here, free + 1) << "a shadow must not brighten a pixel: " << x << ", " << y;
      darkest = std::min(darkest, here);
      steepest = std::max(steepest, std::abs(here - pixel(with, x - 1, y)[1]));
    }
  EXPECT_LT(darkest, 170);
  EXPECT_LT(steepest, 16) << "from full shadow to full light takes many pixels";
}

TEST(Renderer, RepeatsByteForByte) {
  const TestScene scene = hung_cloth();
  Renderer one(scene.surface), two(scene.surface);
  const Image first = one.draw(scene.stage, scene.x, scene.style);
  EXPECT_EQ(first.rgb, one.draw(scene.stage, scene.x, scene.style).rgb);
  EXPECT_EQ(first.rgb, two.draw(scene.stage, scene.x, scene.style).rgb);
}

TEST(Renderer, FrameDoesNotDependOnTheOneBefore) {
  const TestScene scene = hung_cloth();
  TestScene other = seen_from_behind();
  other.x *= 1.3;
  other.style = {
      .width = 200, .height = 220, .supersampling = 1, .wireframe = true, .strain_scale = 0.05};
  const Image alone = drawn(scene);
  Renderer renderer(scene.surface);
  renderer.draw(other.stage, other.x, other.style, other.strain);
  EXPECT_EQ(alone.rgb, renderer.draw(scene.stage, scene.x, scene.style).rgb);
}

TEST(Renderer, SizeOfTheSceneIsOnlyAUnit) {
  const TestScene scene = hung_cloth();
  TestScene sail = hung_cloth();
  sail.x *= 8;
  sail.stage = {8 * sail.stage.eye, 8 * sail.stage.target, 0, 8};
  EXPECT_LE(pixels_above(drawn(scene), drawn(sail), 8), 5);
}

TEST(Renderer, GroundIsOnlyAHeight) {
  const TestScene scene = hung_cloth();
  TestScene hill = hung_cloth();
  for (Eigen::Index i = 1; i < hill.x.size(); i += 3) hill.x[i] += 64;
  hill.stage.eye.y() += 64;
  hill.stage.target.y() += 64;
  hill.stage.ground = 64;
  EXPECT_LE(pixels_above(drawn(scene), drawn(hill), 8), 5);
}

TEST(Renderer, WiresAreDarkAndOnlyOnTheCloth) {
  TestScene scene = hung_cloth(8);
  const Image plain = drawn(scene);
  scene.style.wireframe = true;
  const Image wires = drawn(scene);
  const Difference d = compare(plain, wires);
  EXPECT_GT(d.above8, 500);
  EXPECT_GT(d.left, 80);
  EXPECT_LT(d.right, 240);
  const Colour a = colour_of_cloth(plain), b = colour_of_cloth(wires);
  for (std::size_t c = 0; c < 3; ++c) EXPECT_LT(b[c], a[c]);
}

TEST(Renderer, StrainMapRunsFromVioletToYellow) {
  TestScene scene = hung_cloth();
  scene.style.strain_scale = 0.1;
  const Image image = drawn(scene);
  const Colour low = mean_colour(image, 110, 90, 116, 100);
  const Colour high = mean_colour(image, 196, 90, 202, 100);
  EXPECT_GT(low[2], low[1] + 20) << "violet where strain is small";
  EXPECT_GT(high[1], high[2] + 60) << "yellow at the end of the scale";
}

TEST(Renderer, SupersamplingSmoothsEdgesAndKeepsBrightness) {
  TestScene scene = hung_cloth();
  scene.style.supersampling = 1;
  const Image rough = drawn(scene);
  scene.style.supersampling = 3;
  const Image smooth = drawn(scene);
  EXPECT_GT(pixels_above(rough, smooth, 8), 100);
  for (std::size_t c = 0; c < 3; ++c)
    EXPECT_NEAR(mean_colour(rough, 0, 0, 320, 180)[c], mean_colour(smooth, 0, 0, 320, 180)[c], 1);
}

TEST(Renderer, DrawsAnEmptySurface) {
  TestScene scene = hung_cloth();
  scene.surface = {};
  EXPECT_EQ(drawn(scene).rgb.size(), 320u * 180u * 3u);
}

TEST(Renderer, NamesItsOpenGl) {
  const std::string text = Renderer(hung_cloth().surface).description();
  EXPECT_NE(text.find("pipe"), std::string::npos) << text;
}

}  // namespace renderer_test
