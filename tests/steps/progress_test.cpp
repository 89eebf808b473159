// What a run says of its progress.
#include "program/progress.h"

#include <gtest/gtest.h>

namespace progress_test {

TEST(Progress, TellsTheTimeLeftFromTheFirstStepOn) {
  EXPECT_EQ(progress_text(0, 200, 0.1), "0 % done");
  EXPECT_EQ(progress_text(1, 200, 0.1), "0 % done, 20 s left");
  EXPECT_EQ(progress_text(50, 200, 3), "25 % done, 9 s left");
  EXPECT_EQ(progress_text(200, 200, 12), "100 % done, 0 s left");
}

}  // namespace progress_test
