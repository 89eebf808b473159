// A part that a scene does not name costs nothing: the scene moves as with stiffness 0, and as in a
// program that was built without the code, to the last bit and byte.
#include <gtest/gtest.h>

#include "absent/without.h"

namespace absent_test {

constexpr double rounding = 1e-10;  // m, where the order of operations changes with the pattern

class LeftOut : public testing::TestWithParam<Part> {};
INSTANTIATE_TEST_SUITE_P(
    Parts, LeftOut,
    testing::Values(Part{"gravity", "run_without_gravity"}, Part{"stretch", "run_without_stretch"},
                    Part{"shear", "run_without_shear"}, Part{"membrane", "run_without_sheets"},
                    Part{"spring", "run_without_sheets"}, Part{"bend", "run_without_bend"},
                    Part{"damping", "run_without_damping"},
                    Part{"stretch.kd", "run_without_damping", true},
                    Part{"shear.kd", "run_without_damping", true},
                    Part{"bend.kd", "run_without_damping", true},
                    Part{"toy", "run_full", false, "run_toy"}),
    [](const auto& test) {
      std::string name = test.param.name;
      if (const size_t dot = name.find('.'); dot != std::string::npos) name.replace(dot, 3, "Kd");
      return name;
    });

void expect_same_place(const Configuration& configuration, const Outcome& absent,
                       const Outcome& zero) {
  if (configuration.exact)
    EXPECT_TRUE(absent.moves_like(zero)) << distance(absent, zero) << " m";
  else
    EXPECT_LE(distance(absent, zero), rounding);
}

TEST_P(LeftOut, CostsNothing) {
  const Part& part = GetParam();
  for (const Configuration& configuration : configurations(part)) {
    SCOPED_TRACE(configuration.name);
    const Outcome absent = run(part.full, without(part, configuration));
    expect_same_place(configuration, absent, run(part.full, with_zero(part, configuration)));

    const Outcome built_without = run(part.program, without(part, configuration));
    EXPECT_TRUE(absent.moves_like(built_without)) << distance(absent, built_without) << " m";
    EXPECT_EQ(absent.counts, built_without.counts);

    // The part matters, and the program that was built without the part ignores it.
    const Outcome present = run(part.full, with(part, configuration));
    EXPECT_GT(distance(present, absent), 1e-6);
    EXPECT_LT(distance(present, absent), 10) << "the motion must not explode";
    EXPECT_GT(distance(present, run(part.program, with(part, configuration))), 1e-6);
  }
}

// Once a scene names [bend], it has hinges or springs, and their blocks.
TEST(BendOfZero, MovesAlikeInEveryModelAndIsNotFree) {
  const Part bend{"bend", "run_without_bend"};
  for (const Configuration& configuration : configurations(bend)) {
    const Outcome absent = run("run_full", without(bend, configuration));
    for (const char* model : {"dihedral", "bridson", "quadratic", "springs"}) {
      SCOPED_TRACE(std::string(configuration.name) + ", model " + model);
      Scene scene = with_zero(bend, configuration);
      scene["bend.model"] = model;
      const Outcome zero = run("run_full", scene);
      expect_same_place(configuration, absent, zero);
      for (const char* count : {"blocks", "allocations", "bytes"})
        EXPECT_GT(zero.counts.at(count), absent.counts.at(count)) << count;
    }
  }
}

}  // namespace absent_test
