#include "picture/film.h"

#include <gtest/gtest.h>

#include "picture/reduce.h"
#include "test_scene.h"

namespace film_test {

Colour grey(int k) {
  const unsigned char value = static_cast<unsigned char>(10 * k);
  return {value, value, value};
}

std::vector<Image> greys(int count, int width, int height) {
  std::vector<Image> frames;
  for (int k = 0; k < count; ++k) frames.push_back(filled_image(width, height, grey(k)));
  return frames;
}

TEST(Reduce, ConstantStaysConstant) {
  for (const int value : {0, 1, 20, 127, 200, 254, 255}) {
    const unsigned char v = static_cast<unsigned char>(value);
    const Image image = box_reduce(filled_image(100, 71, {v, v, v}), 33, 24);
    for (const unsigned char out : image.rgb) EXPECT_EQ(out, v);
  }
}

TEST(Reduce, SameSizeIsTheSamePicture) {
  Image image = filled_image(16, 16, {0, 0, 0});
  for (std::size_t i = 0; i < 256; ++i) image.rgb[3 * i] = static_cast<unsigned char>(i);
  EXPECT_EQ(box_reduce(image, 16, 16).rgb, image.rgb);
}

TEST(Reduce, HalfLitIsTheMeanOfLightNotOfValues) {
  Image image = filled_image(2, 1, {0, 0, 0});
  image.rgb = {0, 0, 0, 255, 255, 255};
  EXPECT_EQ(pixel(box_reduce(image, 1, 1), 0, 0), (Colour{188, 188, 188}));  // sRGB of 1/2
}

TEST(Reduce, FractionsOfPixelsCount) {
  Image image = filled_image(3, 1, {0, 0, 0});
  image.rgb = {255, 255, 255, 255, 255, 255, 0, 0, 0};
  const Image two = box_reduce(image, 2, 1);
  EXPECT_EQ(pixel(two, 0, 0), (Colour{255, 255, 255}));
  EXPECT_EQ(pixel(two, 1, 0), (Colour{156, 156, 156}));  // sRGB of 1/3
}

TEST(Reduce, RefusesToEnlarge) {
  EXPECT_THROW(box_reduce(filled_image(4, 4, {0, 0, 0}), 5, 4), std::invalid_argument);
  EXPECT_THROW(box_reduce(filled_image(4, 4, {0, 0, 0}), 4, 0), std::invalid_argument);
}

TEST(FilmStrip, FramesStandInReadingOrderWithWhiteGaps) {
  for (const int count : {1, 2, 5, 13}) {
    const Image sheet = film_strip(greys(count, 640, 360), 3);
    const int columns = std::min(count, 3), rows = (count + columns - 1) / columns;
    const int width = sheet.width / columns, height = sheet.height / rows;
    EXPECT_EQ(sheet.width % columns, 0);
    EXPECT_NEAR(sheet.width, count == 1 ? 644 : 1290, 4);
    for (int k = 0; k < columns * rows; ++k) {
      const int x = k % columns * width, y = k / columns * height;
      EXPECT_EQ(pixel(sheet, x + width / 2, y + height / 2),
                k < count ? grey(k) : (Colour{255, 255, 255}))
          << "frame " << k << " of " << count;
      EXPECT_EQ(pixel(sheet, x, y), (Colour{255, 255, 255})) << "gap before frame " << k;
    }
  }
}

TEST(FilmStrip, WorksForFramesOfAnyShape) {
  EXPECT_EQ(film_strip(greys(1, 1, 1), 1).width, 5);
  EXPECT_EQ(film_strip(greys(2, 3000, 2), 2).height, 5);
  EXPECT_EQ(film_strip(greys(2000, 20, 20), 1500).width, 1500 * 5);
}

TEST(FilmStrip, RefusesNothingAndMixedSizes) {
  EXPECT_THROW(film_strip({}, 3), std::invalid_argument);
  EXPECT_THROW(film_strip(greys(2, 10, 10), 0), std::invalid_argument);
  std::vector<Image> frames = greys(2, 10, 10);
  frames.push_back(filled_image(11, 10, {0, 0, 0}));
  EXPECT_THROW(film_strip(frames, 3), std::invalid_argument);
}

}  // namespace film_test
