// The default run of each program draws the frame.png beside it. The positions and energies of that run are
// compared in tests/steps/program_results_test.cpp.
#include <cstdio>

#include "picture/compare.h"
#include "picture/png.h"
#include "support/program_runner.h"

namespace golden_test {

// Pictures of one size, from left to right.
Image beside(const std::vector<Image>& pictures) {
  const int width = pictures[0].width, height = pictures[0].height;
  Image all = filled_image(width * int(pictures.size()), height, {255, 255, 255});
  for (size_t p = 0; p < pictures.size(); ++p) paste(pictures[p], int(p) * width, 0, all);
  return all;
}

class GoldenFrame : public ProgramTest {};

TEST_P(GoldenFrame, IsWhatTheDefaultRunDraws) {
  const std::filesystem::path golden = GetParam().scene().parent_path() / "frame.png";
  ASSERT_TRUE(exists(golden)) << golden << " is missing: the target update_frames draws it";
  expect_done({"--out", "out"});
  const Image expected = read_png(golden), actual = read_png(directory / "out/still.png");
  ASSERT_EQ(expected.width, 1280);
  ASSERT_EQ(expected.height, 720);
  const Difference difference = compare(expected, actual);
  if (verdict(difference) != Verdict::DIFFERENT) return;

  const std::filesystem::path shown =
      std::filesystem::path(testing::TempDir()) / ("golden_" + GetParam().name + ".png");
  write_png(shown, beside({expected, actual, difference_picture(expected, actual)}));
  FAIL() << describe(difference) << "\nexpected | actual | difference: " << shown.string()
         << "\nIf the change is wanted: cmake --build build/release --target update_frames";
}

INSTANTIATE_TEST_SUITE_P(Programs, GoldenFrame, testing::ValuesIn(programs()), name_of);

}  // namespace golden_test
