// The numbers that --explain prints are those of runs of the same program.
#include <cmath>
#include <regex>

#include "math/triangle.h"
#include "scene/mesh.h"
#include "support/program_runner.h"

namespace program_explain_test {

size_t width_of(const std::string& line) {
  return size_t(std::count_if(line.begin(), line.end(), [](char c) { return (c & 0xc0) != 0x80; }));
}

// The first group of the first match; fails the test where there is none.
std::string found(const std::string& page, const std::string& pattern) {
  std::smatch match;
  if (std::regex_search(page, match, std::regex(pattern))) return match[1];
  ADD_FAILURE() << pattern << " is not in\n" << page;
  return "0";
}

double number(const std::string& page, const std::string& pattern) {
  return std::stod(found(page, pattern));
}

// A length as the page prints it.
std::string length(double m) {
  char text[32];
  std::snprintf(text, sizeof text, m < 1 ? "%.3g mm" : "%.3g m", m < 1 ? 1000 * m : m);
  return text;
}

class Explain : public ProgramTest {
 protected:
  std::string page(Arguments arguments) const {
    arguments.insert(arguments.end(), {"--explain", "--out", "explained"});
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_FALSE(exists(directory / "explained"));
    return outcome.out;
  }
  Outcome results(const std::string& out, Arguments arguments, const Arguments& more = {}) const {
    arguments.insert(arguments.end(), {"--no-pictures", "--out", out});
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }
  VecX positions(const std::string& out, const Arguments& arguments, const Arguments& more) const {
    const Outcome outcome = results(out, arguments, more);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return read_obj_vertices(directory / out / "final.obj");
  }
  double distance(const Arguments& a, const Arguments& b, const Arguments& both) const {
    const VecX x = positions("a", a, both), y = positions("b", b, both);
    return (x - y).norm() / std::sqrt(double(x.size()) / 3);
  }
  // Small, and with an h at which the error can be estimated.
  Arguments square(const Arguments& more = {}) const {
    Arguments arguments = small_square(6, {"--h", GetParam().is_explicit() ? "0.0005" : "0.002"});
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }
};
class ExplainExplicit : public Explain {};
class ExplainIterative : public Explain {};

TEST_P(Explain, IsOneScreenAndWritesNothing) {
  for (const Arguments& arguments :
       {small_square(6, {"--end", "0.2"}), Arguments{GetParam().scene(), "--end", "0.01"}}) {
    Arguments all = arguments;
    all.insert(all.end(), {"--explain", "--out", "out"});
    const Outcome outcome = run(all);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_LE(lines_of(outcome.out).size(), 40u) << outcome.out;
    for (const std::string& line : lines_of(outcome.out)) {
      EXPECT_LE(width_of(line), 100u) << line;
      EXPECT_FALSE(line.ends_with(' ')) << line;
    }
    const auto has = [&](const std::string& section) {
      return outcome.out.find("\n" + section) != std::string::npos;
    };
    for (const char* section : {"A step costs", "What sets h"})
      EXPECT_TRUE(has(section)) << section;
    for (const char* section : {"The error of h", "What could be left out", "Advice"})
      EXPECT_TRUE(has(section) || has("Not measured in")) << section;  // on a slow machine
  }
  EXPECT_EQ(files_in(directory), std::vector<std::string>{});
}

TEST_P(Explain, NamesNoTermThatIsNotThere) {
  const std::string with = page(square({"--end", "0.02"}));
  const std::string without = page(square({"--end", "0.02", "--without", "shear"}));
  EXPECT_NE(with.find("shear"), std::string::npos);
  EXPECT_EQ(without.find("shear"), std::string::npos) << without;
}

TEST_P(Explain, ErrorOfHIsThatToAFineH) {
  const std::string said = page(square({"--end", "0.3"}));
  const std::string time = found(said, R"(t = (\S+) s: [0-9.]+ mm, .*observed order)");
  const double error = number(said, R"(t = \S+ s: (\S+) mm, .*observed order)") / 1000;
  const Arguments fine = {"--h", GetParam().is_explicit() ? "0.000025" : "0.0001"};
  Arguments finely = small_square(6, fine);
  const double measured = distance(square(), finely, {"--end", time}) * 20 / 19;
  EXPECT_NEAR(error, measured, 0.1 * measured) << said;
  EXPECT_GT(measured, 1e-5);
}

TEST_P(Explain, WhatIsLeftOutMovesTheClothAsFarAsItSays) {
  const Arguments arguments = square({"--end", "0.1"});
  const std::string said = page(arguments), time = found(said, R"(until t = (\S+) s\n)");
  int compared = 0;
  for (const std::string table : {"gravity", "stretch", "shear", "damping"}) {
    std::smatch row;
    if (!std::regex_search(said, row, std::regex("--without " + table + R"( +([0-9.e+-]+ mm))")))
      continue;
    EXPECT_EQ(row[1], length(distance(square(), square({"--without", table}), {"--end", time})));
    ++compared;
  }
  EXPECT_GE(compared, 2) << said;
}

TEST_P(ExplainExplicit, AnExplosionIsSaidInItsLine) {
  const Arguments too_long = small_square(10, {"--h", "0.002"});
  const std::string said = page(too_long);
  EXPECT_NE(said.find("the cloth explodes by t = "), std::string::npos) << said;
  EXPECT_EQ(said.find("What could be left out"), std::string::npos) << said;
  EXPECT_EQ(results("out", too_long).code, 1);
  EXPECT_LE(number(results("out", too_long).err, R"(exploded in step \d+ \(t = (\S+) s\))"),
            number(said, R"(explodes by t = (\S+) s)"));
}

TEST_P(ExplainExplicit, SaysTheCriticalStepOfARun) {
  const Arguments arguments = square({"--end", "0.02"});
  const std::string line = found(results("out", arguments).out, R"((stable below h_crit = .*)\n)");
  EXPECT_NE(page(arguments).find("    " + line + "\n"), std::string::npos) << line;
}

// The longest stable step without a term is that of a run without the term.
TEST_P(ExplainExplicit, SaysTheCriticalStepWithoutATerm) {
  const std::string said = page(square({"--end", "0.02"}));
  for (const std::string table : {"stretch", "shear"})
    EXPECT_EQ(found(said, "without " + table + R"( (\S+) s)"),
              found(results("out", square({"--end", "0.02", "--without", table})).out,
                    R"(h_crit = (\S+) s)"));
}

// Only of explicit steps: an implicit step also stores where its elements lie in the matrix.
TEST_P(ExplainExplicit, CountsTheBytesOfItsTriangles) {
  const std::string said = page(square({"--end", "0.02"}));
  EXPECT_EQ(number(said, R"(triangles .* (\d+) B  shared by stretch)"), 72 * sizeof(Triangle));
}

TEST_P(ExplainIterative, CountsTheIterationsOfARun) {
  const Arguments arguments = square({"--end", "0.1"});
  EXPECT_EQ(found(page(arguments), R"((\S+) iterations;)"),
            found(results("out", arguments).out, R"((\S+) iterations of)"));
}

INSTANTIATE_TEST_SUITE_P(Programs, Explain, testing::ValuesIn(programs()), name_of);
INSTANTIATE_TEST_SUITE_P(Programs, ExplainExplicit, testing::ValuesIn(explicit_programs()),
                         name_of);
INSTANTIATE_TEST_SUITE_P(Programs, ExplainIterative, testing::ValuesIn(iterative_programs()),
                         name_of);

const std::string damped_and_bending =
    "[cloth]\nsize = [1.0, 1.0]\ncells = [6, 6]\ndensity = 0.2\n"
    "pins = [\"top left\", {vertex = \"top right\", velocity = [-0.2, 0, 0]}]\n"
    "[gravity]\ng = 9.81\n[stretch]\nk = 1000.0\n[shear]\nk = 500.0\n[bend]\nk = 0.01\n"
    "[time]\nh = 0.005\nend = 0.1\n[damping]\nstretch = 0.2\nbend = 0.001\n";

class ExplainBend : public ProgramDirectory {
 protected:
  VecX final_of(const std::string& scene, const Arguments& more) const {
    Arguments arguments = {scene, "--no-pictures", "--out", "out"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    EXPECT_EQ(run(step05, arguments).code, 0);
    return read_obj_vertices(directory / "out/final.obj");
  }
  const StepProgram step05 = program_called("step05_bend");
};

// No option leaves out the damping of one term alone: the second scene has no line for it.
TEST_F(ExplainBend, BendingAndTheDampingOfOneTermMoveTheClothAsFarAsItSays) {
  write("scene.toml", damped_and_bending);
  std::string undamped = damped_and_bending;
  undamped.resize(undamped.find("bend = 0.001"));
  write("undamped.toml", undamped);
  const Outcome explained = run(step05, {"scene.toml", "--explain"});
  EXPECT_EQ(explained.code, 0);
  const std::string& said = explained.out;
  const std::string time = found(said, R"(until t = (\S+) s\n)");
  const VecX as_is = final_of("scene.toml", {"--end", time});
  const auto moved = [&](const VecX& x) {
    return length((x - as_is).norm() / std::sqrt(double(x.size()) / 3));
  };
  EXPECT_EQ(found(said, R"(--without bend +(\S+ mm))"),
            moved(final_of("scene.toml", {"--end", time, "--without", "bend"})));
  EXPECT_EQ(found(said, R"(\[damping\] without bend +(\S+ mm))"),
            moved(final_of("undamped.toml", {"--end", time})));
  EXPECT_NE(said.find("2 pinned (1 of them moves)"), std::string::npos) << said;
}

}  // namespace program_explain_test
