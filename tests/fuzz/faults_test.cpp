// Faults of the system: kills at any moment, a full disk, two runs at once, a reader that goes away.
#include <sys/mount.h>

#include <csignal>
#include <thread>

#include "picture/png.h"
#include "scene/mesh.h"
#include "scene/velocities.h"
#include "support/program_runner.h"

namespace faults_test {

constexpr int cells = 4, vertices = (cells + 1) * (cells + 1);

class FaultsTest : public ProgramTest {
 protected:
  Arguments small_run(int frames, const Arguments& more = {}) const {
    Arguments arguments =
        small_square(cells, {"--end", "1", "--frames", std::to_string(frames), "--out", "out"});
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }

  // Everything in out/ under its final name is whole. Returns the number of frames.
  int whole_frames() const {
    int frames = 0;
    for (const std::string& name : files_in(directory / "out")) {
      const std::filesystem::path file = directory / "out" / name;
      SCOPED_TRACE(name);
      if (name.ends_with(".part")) continue;
      if (name.ends_with(".png")) {
        EXPECT_NO_THROW(read_png(file));
      }
      if (name.ends_with(".obj")) {
        EXPECT_EQ(read_obj(file).vertices(), vertices);
      }
      if (name == "log.csv") {
        EXPECT_GE(read_table(file).size(), 10u);
      }
      if (name == "final_velocities.csv") {
        EXPECT_NO_THROW(read_velocities(file, vertices));
      }
      frames += name.starts_with("frame_") && name.ends_with(".obj");
    }
    return frames;
  }
};

// Forty kills for each of the five programs: in every part of the run, from before its first frame on.
TEST_P(FaultsTest, AKillLeavesNoHalfOfAFile) {
  constexpr int frames = 18;
  const Arguments arguments = small_run(frames, {"--size", "64x36", "--export", "obj"});
  std::vector<int> reached;
  for (int kill = 0; kill < 40; ++kill) {
    std::filesystem::remove_all(directory / "out");
    Running running(GetParam().path, arguments, directory);
    const int frame = kill % 20 - 1;
    if (frame >= 0) {
      EXPECT_TRUE(running.wait_for_output("frame " + std::to_string(frame) + " of", 60));
    }
    std::this_thread::sleep_for(std::chrono::microseconds(300 * kill));
    running.send(SIGKILL);
    running.wait(20);
    reached.push_back(whole_frames());
  }
  EXPECT_EQ(std::ranges::max(reached), frames + 1);
  EXPECT_GE(std::ranges::count_if(reached, [](int n) { return n > 0 && n <= frames; }), 15);
  expect_done(small_run(2, {"--no-pictures"}));
}

// A file system in memory with a few pages. Mounting one needs root.
TEST_P(FaultsTest, AFullDiskKeepsEveryWholeRow) {
  std::filesystem::create_directory(directory / "out");
  if (mount("tmpfs", (directory / "out").c_str(), "tmpfs", 0, "size=20k") != 0)
    GTEST_SKIP() << "a tmpfs cannot be mounted here";
  const Outcome outcome = run(small_run(400, {"--no-pictures"}));
  EXPECT_EQ(outcome.code, 1);
  EXPECT_NE(outcome.err.find("out/log.csv: No space left on device"), std::string::npos)
      << outcome.err;
  const size_t rows = read_table(directory / "out/log.csv").at("frame").size();
  EXPECT_GE(rows, 40u);
  EXPECT_LT(rows, 401u);
  EXPECT_EQ(count_starting(files_in(directory / "out"), "", ".part"), 0);
  EXPECT_EQ(umount((directory / "out").c_str()), 0);
}

TEST_P(FaultsTest, OfTwoRunsAtOnceOneIsRefusedAndTheOtherIsWhole) {
  for (int attempt = 0; attempt < 5; ++attempt) {
    std::filesystem::remove_all(directory / "out");
    const Arguments arguments = small_run(40, {"--size", "64x36", "--export", "obj"});
    Running one(GetParam().path, arguments, directory),
        other(GetParam().path, arguments, directory);
    const Outcome a = one.wait(60), b = other.wait(60);
    EXPECT_EQ(std::min(a.code, b.code), 0) << a.err << b.err;
    EXPECT_EQ(std::max(a.code, b.code), 2) << "both ran: " << a.err << b.err;
    EXPECT_NE((a.err + b.err).find("another run writes there"), std::string::npos);
    EXPECT_EQ(whole_frames(), 41);
    EXPECT_EQ(read_table(directory / "out/log.csv").at("frame").size(), 41u);
  }
}

TEST_P(FaultsTest, AReaderOfTheOutputThatGoesAwayEndsTheRunInGoodOrder) {
  std::string command = "'" + GetParam().path.string() + "'";
  for (const std::string& word : small_run(400, {"--no-pictures"})) command += " '" + word + "'";
  const Outcome outcome =
      Running("/bin/sh", {"-c", "{ " + command + "; echo $? > code; } | sed '/frame 1 of/q'"},
              directory)
          .wait(60);
  EXPECT_NE(outcome.out.find("frame 1 of"), std::string::npos) << outcome.out;
  EXPECT_EQ(read_all(directory / "code"), "130\n");
  const size_t rows = read_table(directory / "out/log.csv").at("frame").size();
  EXPECT_GE(rows, 1u);
  EXPECT_LT(rows, 401u);
  EXPECT_EQ(read_obj(directory / "out/final.obj").vertices(), vertices);
}
INSTANTIATE_TEST_SUITE_P(Programs, FaultsTest, testing::ValuesIn(programs()), name_of);

// The set-up of steps 1 and 2 is long: they look for h_crit.
class ExplicitFaultsTest : public FaultsTest {};
TEST_P(ExplicitFaultsTest, CtrlCBeforeTheFirstFrameLeavesNothing) {
  Running running(GetParam().path,
                  {GetParam().square(), "--cells", "250", "--no-pictures", "--out", "out"},
                  directory);
  ASSERT_TRUE(running.wait_for_output("vertices", 60));
  EXPECT_TRUE(exists(directory / "out"));
  running.send(SIGINT);
  const Outcome outcome = running.wait(20);
  EXPECT_EQ(outcome.code, -1) << outcome.out;
  EXPECT_EQ(outcome.out.find("frame 0"), std::string::npos) << outcome.out;
  EXPECT_FALSE(exists(directory / "out"));
}
INSTANTIATE_TEST_SUITE_P(Programs, ExplicitFaultsTest, testing::ValuesIn(explicit_programs()),
                         name_of);

}  // namespace faults_test
