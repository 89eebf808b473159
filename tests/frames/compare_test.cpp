#include "picture/compare.h"

#include <gtest/gtest.h>
#include <unistd.h>
#include <cstdlib>
#include <filesystem>

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
  EXPECT_EQ(verdict_of(10, 8), Verdict::EQUIVALENT) << "1e-4 of the pixels by more than 2";
  EXPECT_EQ(verdict_of(11, 8), Verdict::DIFFERENT);
  EXPECT_EQ(verdict_of(1, 100), Verdict::EQUIVALENT) << "1e-5 of the pixels by more than 8";
  EXPECT_EQ(verdict_of(2, 100), Verdict::DIFFERENT);
  const Image all = filled_image(1000, 100, {101, 101, 101});
  EXPECT_EQ(verdict(compare(reference, all)), Verdict::DIFFERENT) << "rmse 1";
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
