// The three ways of the benchmark compute the same forces.
#include "three_ways.h"

#include <gtest/gtest.h>

namespace three_ways_test {

TEST(ThreeWays, GiveTheSameForces) {
  for (const int n : {1, 8, 32}) {
    const Sheet sheet(n);
    const VecX ours = Ours(sheet).forces(sheet.state);
    EXPECT_GT(ours.norm(), 1) << "no force to compare";
    EXPECT_LT(difference(ours, Transcribed(sheet).forces(sheet.state)), 1e-12) << n << " cells";
    EXPECT_LT(difference(ours, Differentiated(sheet).forces(sheet.state)), 1e-12) << n << " cells";
  }
}

// A second evaluation starts from zero again.
TEST(ThreeWays, EvaluateTheSameForcesEveryTime) {
  const Sheet sheet(8);
  Ours ours(sheet);
  Transcribed transcribed(sheet);
  Differentiated differentiated(sheet);
  const VecX f1 = ours.forces(sheet.state), f2 = transcribed.forces(sheet.state),
             f3 = differentiated.forces(sheet.state);
  EXPECT_EQ(f1, ours.forces(sheet.state));
  EXPECT_EQ(f2, transcribed.forces(sheet.state));
  EXPECT_EQ(f3, differentiated.forces(sheet.state));
}

}  // namespace three_ways_test
