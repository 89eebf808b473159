#include <gtest/gtest.h>

#include "made_up_run.h"
#include "support/program_runner.h"

namespace renew_frames_test {

class RenewFrames : public ProgramDirectory {
 protected:
  Outcome renew() const {
    return Running(RENEW_FRAMES, {"sheet.png", "runs", "sources", "step01", "step02", "step03"},
                   directory)
        .wait(60);
  }
  void still(const std::string& step, const Image& image, const PngText& text = {}) const {
    create_directories(directory / "runs" / step);
    write_png(directory / "runs" / step / "still.png", image, text);
  }
  std::filesystem::path golden(const std::string& step, const Image& image) const {
    create_directories(directory / "sources" / step);
    write_png(directory / "sources" / step / "frame.png", image);
    return directory / "sources" / step / "frame.png";
  }
};

TEST_F(RenewFrames, RenewsWhatIsDifferentAndNothingElse) {
  Image noise = cloth_on_the_wall(20);
  noise.rgb[0] += 2;
  const std::filesystem::path kept = golden("step01", cloth_on_the_wall(20)),
                              moved = golden("step02", cloth_on_the_wall(20)),
                              other_text = golden("step03", cloth_on_the_wall(20));
  const std::string before = read_all(kept);
  still("step01", noise);
  still("step02", cloth_on_the_wall(25));
  still("step03", cloth_on_the_wall(20), {{"TimeStep", "0.02 s"}});
  const Outcome outcome = renew();
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(read_all(kept), before);
  EXPECT_EQ(read_all(moved), read_all(directory / "runs/step02/still.png"));
  EXPECT_EQ(read_all(other_text), read_all(directory / "runs/step03/still.png"));
  EXPECT_TRUE(outcome.out.starts_with("step01: kept: EQUIVALENT")) << outcome.out;
  EXPECT_NE(outcome.out.find("step02: renewed: DIFFERENT"), std::string::npos) << outcome.out;
  EXPECT_TRUE(exists(directory / "sheet.png"));
}

TEST_F(RenewFrames, RenewsNothingIfOneRunIsMissing) {
  const std::filesystem::path first = golden("step01", cloth_on_the_wall(20));
  const std::string before = read_all(first);
  still("step01", cloth_on_the_wall(25));
  EXPECT_EQ(renew().code, 1);
  EXPECT_EQ(read_all(first), before);
}

}  // namespace renew_frames_test
