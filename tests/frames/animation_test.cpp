#include "picture/animation.h"

#include "support/read_animation.h"
#include "test_scene.h"

namespace animation_test {

// One picture for each number, none the same as another.
std::vector<AnimationFrame> frames_of(const std::vector<int>& milliseconds) {
  std::vector<AnimationFrame> frames;
  for (const int time : milliseconds) {
    frames.push_back({filled_image(23, 17, {10, 200, 30}), time});
    for (std::size_t i = 0; i < frames.size(); ++i) frames.back().image.rgb[7 * i] = 255;
  }
  return frames;
}

struct File {
  std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("animation_" + std::to_string(getpid()) + ".png");
  ~File() { std::filesystem::remove(path); }
};

TEST(Animation, EveryFrameIsReadBackWithItsTime) {
  const std::vector<int> times = {42, 43, 65535, 0};
  const std::vector<AnimationFrame> frames = frames_of(times);
  const PngText text = {{"Software", "frames test"}, {"Time", "1 s"}};
  const File file;
  write_png(file.path, encode_animation(frames, text));
  const std::vector<AnimationFrame> back = read_animation(file.path);
  ASSERT_EQ(back.size(), frames.size());
  for (std::size_t k = 0; k < frames.size(); ++k) {
    EXPECT_EQ(back[k].image.rgb, frames[k].image.rgb) << "frame " << k;
    EXPECT_EQ(back[k].milliseconds, times[k]);
  }
  EXPECT_EQ(read_png_text(file.path), text);
}

TEST(Animation, AReaderOfPlainPngSeesTheFirstFrame) {
  const File file;
  const std::vector<AnimationFrame> frames = frames_of({40, 40, 40});
  write_png(file.path, encode_animation(frames));
  EXPECT_EQ(read_png(file.path).rgb, frames[0].image.rgb);
}

TEST(Animation, SameFramesSameBytes) {
  EXPECT_EQ(encode_animation(frames_of({40, 50})), encode_animation(frames_of({40, 50})));
  EXPECT_NE(encode_animation(frames_of({40, 50})), encode_animation(frames_of({40, 51})));
}

// 25 pictures of a run are to have 1.5 MB at most.
TEST(Animation, ADrawnPictureOf480By270HasLessThan60Kilobytes) {
  TestScene scene = hung_cloth();
  scene.style.width = 480;
  scene.style.height = 270;
  Renderer renderer(scene.surface);
  const Image image = renderer.draw(scene.stage, scene.x, scene.style);
  EXPECT_LT(encode_animation({{image, 40}}).size(), 60000u);
}

TEST(Animation, RefusesNothingMixedSizesAndImagesWithoutPixels) {
  EXPECT_THROW(encode_animation({}), std::invalid_argument);
  std::vector<AnimationFrame> frames = frames_of({40, 40});
  frames.push_back({filled_image(23, 16, {0, 0, 0}), 40});
  EXPECT_THROW(encode_animation(frames), std::invalid_argument);
  EXPECT_THROW(encode_animation({{Image{}, 40}}), std::invalid_argument);
}

}  // namespace animation_test
