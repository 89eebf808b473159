#include "picture/compare.h"

#include <gtest/gtest.h>
#include <unistd.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <random>

#include "picture/png.h"
#include "test_scene.h"

namespace compare_test {

const Image reference = filled_image(1000, 100, {100, 100, 100});  // 1e5 pixels

Image changed(int pixels, int by) {
  Image image = reference;
  for (int i = 0; i < pixels; ++i)
    image.rgb[pixel_at(image, 7 * i % 1000, i % 100) + 1] = static_cast<unsigned char>(100 + by);
  return image;
}

Verdict verdict_of(int pixels, int by) {
  return verdict(compare(reference, changed(pixels, by)));
}

// The exit code of the tool for two files.
int exit_code(const std::string& arguments) {
  const std::string command = "\"" COMPARE_FRAMES "\" " + arguments + " > /dev/null 2>&1";
  return WEXITSTATUS(std::system(command.c_str()));
}

TEST(Compare, Verdicts) {
  EXPECT_EQ(verdict_of(0, 0), Verdict::IDENTICAL);
  EXPECT_EQ(verdict_of(1, 1), Verdict::EQUIVALENT);
  EXPECT_EQ(verdict_of(500, 2), Verdict::EQUIVALENT);
  EXPECT_EQ(verdict_of(1, 100), Verdict::EQUIVALENT) << "a silhouette's pixel jumps";
  EXPECT_EQ(verdict_of(20, 9), Verdict::EQUIVALENT) << "2e-4 of the pixels, scattered";
  EXPECT_EQ(verdict_of(21, 9), Verdict::DIFFERENT);
  const Image all = filled_image(1000, 100, {101, 101, 101});
  EXPECT_EQ(verdict(compare(reference, all)), Verdict::DIFFERENT) << "rmse 1";
}

// Pixels in a row, one every `step`.
Verdict verdict_of_row(int pixels, int step) {
  Image image = reference;
  for (int i = 0; i < pixels; ++i) image.rgb[pixel_at(image, 500 + step * i, 50)] = 103;
  return verdict(compare(reference, image));
}

TEST(Compare, PixelsSideBySideAreDifferentWhereScatteredOnesAreEquivalent) {
  EXPECT_EQ(verdict_of_row(6, 1), Verdict::EQUIVALENT);
  EXPECT_EQ(verdict_of_row(7, 1), Verdict::DIFFERENT);
  EXPECT_EQ(verdict_of_row(20, 3), Verdict::EQUIVALENT) << "at most 6 in 16 columns";
}

// The densest window, counted window by window.
int counted_window(const Image& a, const Image& b) {
  int most = 0;
  for (int top = 0; top < a.height; ++top)
    for (int left = 0; left < a.width; ++left) {
      int marked = 0;
      for (int y = top; y < std::min(top + 16, a.height); ++y)
        for (int x = left; x < std::min(left + 16, a.width); ++x)
          marked += pixel_difference(&a.rgb[pixel_at(a, x, y)], &b.rgb[pixel_at(b, x, y)]) > 2;
      most = std::max(most, marked);
    }
  return most;
}

TEST(Compare, DensestWindowIsThatOfCountingEachWindow) {
  std::mt19937 random(7);
  for (const auto& [width, height] : {std::array{1, 1}, {5, 40}, {16, 16}, {40, 31}}) {
    const Image a = filled_image(width, height, {100, 100, 100});
    Image b = a;
    for (std::size_t i = 0; i < b.rgb.size(); i += 3)
      if (random() % 6 == 0) b.rgb[i] = 103;
    EXPECT_EQ(compare(a, b).window, counted_window(a, b)) << width << "x" << height;
    Image corner = a;
    corner.rgb.back() = 0;
    EXPECT_EQ(compare(a, corner).window, 1) << width << "x" << height;
  }
}

Image frame_of(const TestScene& scene) {
  TestScene s = scene;
  s.style = {.width = 640, .height = 360};
  return Renderer(s.surface).draw(s.stage, s.x, s.style);
}

// Both kinds from the table in tests/README.md, at the size of a frame.
TEST(Compare, MovedEdgeIsDifferentWhereRoundingOfAllVerticesIsEquivalent) {
  const int cells = 40;
  const TestScene scene = hung_cloth(cells);
  const Image before = frame_of(scene);

  TestScene edge = scene;
  edge.x.segment<3>(3 * cells / 2) += Vec3(0.001, 0.001, 0);  // in the middle of the lower border
  const Difference moved = compare(before, frame_of(edge));
  EXPECT_EQ(verdict(moved), Verdict::DIFFERENT) << describe(moved);

  TestScene noise = scene;
  std::mt19937 random(1);
  for (double& x : noise.x) x += 1e-5 * std::uniform_real_distribution<double>(-1, 1)(random);
  const Difference scattered = compare(before, frame_of(noise));
  EXPECT_EQ(verdict(scattered), Verdict::EQUIVALENT) << describe(scattered);
  EXPECT_GE(scattered.largest, 30) << "the largest difference would not tell the two apart";
  EXPECT_GE(scattered.above2, 10);
}

TEST(Compare, Numbers) {
  Image image = reference;
  image.rgb[pixel_at(image, 10, 20)] = 103;
  image.rgb[pixel_at(image, 30, 40) + 1] = 60;
  image.rgb[pixel_at(image, 50, 60) + 2] = 140;
  const Difference d = compare(reference, image);
  EXPECT_EQ(d.largest, 40);
  EXPECT_EQ(d.above0, 3);
  EXPECT_EQ(d.above2, 3);
  EXPECT_EQ(d.above8, 2);
  EXPECT_EQ(d.window, 1);
  EXPECT_NEAR(d.rmse, std::sqrt((9 + 1600 + 1600) / 3e5), 1e-12);
  EXPECT_EQ(d.left, 30);
  EXPECT_EQ(d.top, 40);
  EXPECT_EQ(d.right, 50);
  EXPECT_EQ(d.bottom, 60);
  EXPECT_EQ(d.centre_x, 40);
  EXPECT_EQ(d.centre_y, 50);
}

TEST(Compare, SizesMustAgree) {
  EXPECT_THROW(compare(reference, filled_image(999, 100, {0, 0, 0})), std::invalid_argument);
}

TEST(Compare, DifferencePictureShowsWhere) {
  const Image picture = difference_picture(reference, changed(1, 50));
  const Colour there = pixel(picture, 0, 0), elsewhere = pixel(picture, 500, 50);
  EXPECT_GT(there[0], there[2] + 100) << "orange to red";
  EXPECT_EQ(elsewhere[0], elsewhere[2]) << "grey";
}

TEST(CompareFrames, ExitCodes) {
  const std::filesystem::path directory =
      std::filesystem::temp_directory_path() / ("compare_frames_" + std::to_string(getpid()));
  std::filesystem::create_directory(directory);
  const std::string a = (directory / "a.png").string(), b = (directory / "b.png").string(),
                    c = (directory / "c.png").string(), d = (directory / "d.png").string();
  write_png(a, reference);
  write_png(b, changed(1, 1));
  write_png(c, changed(900, 90));
  write_png(d, filled_image(10, 10, {0, 0, 0}));
  EXPECT_EQ(exit_code(a + " " + a + " --exact"), 0);
  EXPECT_EQ(exit_code(a + " " + b), 0);
  EXPECT_EQ(exit_code(a + " " + b + " --exact"), 1);
  EXPECT_EQ(exit_code(a + " " + c), 1);
  EXPECT_EQ(exit_code(a + " " + d), 2);
  EXPECT_EQ(exit_code(a + " " + a + "x"), 2);
  EXPECT_EQ(exit_code(a), 2);
  EXPECT_EQ(exit_code(a + " " + c + " --diff " + d), 1);
  EXPECT_EQ(read_png(d).width, 1000);
  std::filesystem::remove_all(directory);
}

}  // namespace compare_test
