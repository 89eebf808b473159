#include "picture/overlay.h"

#include <gtest/gtest.h>
#include <set>
#include <string>

#include "picture/compare.h"
#include "picture/stroke_font.h"
#include "test_scene.h"

namespace overlay_test {

Image white() {
  return filled_image(320, 180, {255, 255, 255});
}

Image lettered(char c) {
  Image image = filled_image(40, 40, {255, 255, 255});
  draw_text(image, 8, 8, 18, std::string(1, c), {0, 0, 0});
  return image;
}

TEST(StrokeFont, EveryGlyphButSpaceIsThereAndItsOwn) {
  std::set<std::string> seen;
  for (char c = first_glyph; c <= last_glyph; ++c) {
    const Image image = lettered(c);
    const long ink = compare(filled_image(40, 40, {255, 255, 255}), image).above8;
    if (c == ' ')
      EXPECT_EQ(ink, 0);
    else
      EXPECT_GE(ink, 4) << c;
    const std::string bytes(image.rgb.begin(), image.rgb.end());
    EXPECT_TRUE(seen.insert(bytes).second) << c << " looks like another glyph";
  }
}

TEST(StrokeFont, PointsLieOnTheGrid) {
  for (const std::string_view strokes : stroke_font)
    for (std::size_t i = 0; i < strokes.size(); i += strokes[i] == ' ' ? 1 : 2) {
      if (strokes[i] == ' ') continue;
      ASSERT_LT(i + 1, strokes.size()) << strokes;
      EXPECT_TRUE(strokes[i] >= '0' && strokes[i] <= '6') << strokes;
      EXPECT_TRUE(strokes[i + 1] >= '0' && strokes[i + 1] <= '9') << strokes;
    }
}

TEST(StrokeFont, OtherCharactersBecomeQuestionMarks) {
  EXPECT_EQ(lettered('\x01').rgb, lettered('?').rgb);
  EXPECT_EQ(lettered('\xc3').rgb, lettered('?').rgb);
}

TEST(Overlay, TextOutsideThePictureIsCutOff) {
  Image image = white();
  draw_text(image, -50, -50, 200, "Wg", {0, 0, 0});
  draw_text(image, 300, 170, 60, "Wg", {0, 0, 0});
  draw_text(image, 5000, 5000, 10, "Wg", {0, 0, 0});
  EXPECT_GT(compare(white(), image).above8, 100);
}

TEST(Overlay, CaptionStaysInTheUpperLeftEvenIfLong) {
  Image image = white();
  draw_caption(image, "Step 3", std::string(300, 'm'));
  const Difference d = compare(white(), image);
  EXPECT_GT(d.above8, 50);
  EXPECT_LT(d.bottom, 90);
  EXPECT_LT(d.right, 319);
}

TEST(Overlay, LegendStandsAtTheRightForAnyScale) {
  for (const double scale : {1e-4, 0.1, 5.0}) {
    Image image = white();
    draw_legend(image, scale);
    const Difference d = compare(white(), image);
    EXPECT_GT(d.above8, 500) << scale;
    EXPECT_GT(d.left, 160) << scale;
    EXPECT_LT(d.right, 319) << scale;
  }
}

TEST(Overlay, TinyPicturesAreNoTrouble) {
  Image image = filled_image(1, 1, {255, 255, 255});
  draw_caption(image, "title", "line");
  draw_legend(image, 0.1);
  EXPECT_EQ(image.rgb.size(), 3u);
}

}  // namespace overlay_test
