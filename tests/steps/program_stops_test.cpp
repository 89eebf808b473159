// Runs that end early: full disk, explosion, Ctrl-C. The files written until then stay.
#include <cmath>
#include <csignal>
#include <regex>

#include "picture/png.h"
#include "scene/mesh.h"
#include "scene/velocities.h"
#include "support/program_runner.h"

namespace program_stops_test {

// The longest stable step that the program prints.
double critical_step_of(const std::string& output) {
  std::smatch match;
  if (!std::regex_search(output, match, std::regex("h_crit = ([0-9.e-]+) s"))) return 0;
  return std::stod(match[1]);
}

double number_after(const std::string& text, const std::string& words) {
  const size_t at = text.find(words);
  return at == text.npos ? -1 : std::stod(text.substr(at + words.size()));
}

std::string text_of(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", number);
  return text;
}

class StopsTest : public ProgramTest {
 protected:
  // No file may grow beyond `bytes`: the run breaks off at the first file that would.
  void expect_full_disk(long bytes, const std::string& file, const Arguments& more) const {
    SCOPED_TRACE(file);
    std::filesystem::remove_all(directory / "out");
    Arguments arguments = small_square(8, {"--end", "0.02", "--out", "out"});
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome full = run(arguments, bytes);
    EXPECT_EQ(full.code, 1);
    EXPECT_EQ(lines_of(full.err).size(), 1u) << full.err;
    EXPECT_NE(full.err.find("out/" + file), std::string::npos) << full.err;
    EXPECT_NE(full.err.find("File too large"), std::string::npos) << full.err;
    const std::vector<std::string> files = files_in(directory / "out");
    EXPECT_EQ(count_starting(files, "", ".part"), 0);
    EXPECT_EQ(count_starting(files, file, ""), file == "log.csv" ? 1 : 0) << "part of it is left";
    EXPECT_GE(read_table(directory / "out/log.csv")["frame"].size(), 1u) << "every whole row stays";
  }
};
class ExplosionTest : public StopsTest {};

TEST_P(StopsTest, FullDiskIsNamedWithFileAndReasonAndLeavesNoPartOfIt) {
  expect_full_disk(1500, "log.csv", {"--frames", "100", "--no-pictures"});
  expect_full_disk(1500, "frame_0000.png", {"--size", "160x90"});
  expect_full_disk(1500, "frame_0000.obj", {"--frames", "2", "--no-pictures", "--export", "obj"});
  expect_full_disk(1500, "final.obj", {"--frames", "2", "--no-pictures"});
}

// Where not even one byte can be written, the run does not start.
TEST_P(StopsTest, DiskThatIsFullFromTheStartIsRefused) {
  const Outcome full = run(small_square(8, {"--out", "out"}), 0);
  EXPECT_NE(full.code, 0);
  EXPECT_EQ(lines_of(full.err).size(), 1u) << full.err;
  EXPECT_NE(full.err.find("out: File too large"), std::string::npos) << full.err;
  EXPECT_EQ(files_in(directory / "out"), std::vector<std::string>{});
}

// No frame has been recorded then: neither a log without rows nor a film without pictures is left.
TEST_P(StopsTest, AStartThatHasExplodedLeavesNoFile) {
  write("start.obj", "v 0 0 0\nv 2000 0 0\nv 0 0 -1\nv 1 0 -1\nf 1 2 3\nf 2 4 3\n");
  write("scene.toml",
        "[cloth]\nsize = [1.0, 1.0]\ncells = [1, 1]\ndensity = 0.2\n[stretch]\nk = 1000.0\n"
        "[time]\nh = 0.0001\nend = 0.01\n[start]\npositions = \"start.obj\"\n");
  const Outcome outcome = run({"scene.toml", "--size", "80x45", "--out", "out"});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_EQ(lines_of(outcome.err).size(), 1u) << outcome.err;
  EXPECT_NE(outcome.err.find("a thread is 2e+03 times its length"), std::string::npos)
      << outcome.err;
  EXPECT_FALSE(exists(directory / "out")) << "a new directory without a file goes";
}

// … and the --h that it names works.
TEST_P(ExplosionTest, BeyondTheStableStepItBreaksOffAndSaysWhatToTry) {
  const Arguments scene = small_square(16, {"--end", "1", "--frames", "100", "--size", "80x45"});
  const auto with_h = [&](double h, const std::string& out) {
    Arguments arguments = scene;
    arguments.insert(arguments.end(), {"--h", text_of(h), "--out", out});
    return arguments;
  };
  const Outcome stable = run(small_square(16, {"--end", "0.001", "--no-pictures"}));
  const double h_crit = critical_step_of(stable.out);
  ASSERT_GT(h_crit, 1e-4) << stable.out;

  const double h = std::stod(text_of(1.1 * h_crit));
  const Outcome outcome = run(with_h(h, "out"));
  EXPECT_EQ(outcome.code, 1);
  const std::vector<std::string> said = lines_of(outcome.err);
  ASSERT_EQ(said.size(), 2u) << outcome.err;
  EXPECT_TRUE(said[0].starts_with("warning: h = ")) << said[0];
  EXPECT_TRUE(std::regex_search(said[1], std::regex("length|longer|not finite"))) << said[1];
  EXPECT_NE(said[1].find("is 1.10 of the stable step"), std::string::npos) << said[1];
  const double step = number_after(said[1], "exploded in step "),
               time = number_after(said[1], "(t = "), try_h = number_after(said[1], "try --h ");
  EXPECT_GT(time, 0);
  EXPECT_LE(time, 1) << "within one simulated second";
  EXPECT_NEAR(time, step * h, 1e-5 * time);

  const std::vector<std::string> files = files_in(directory / "out");
  const Table log = read_table(directory / "out/log.csv");
  const int frames = int(log.at("frame").size());
  EXPECT_GE(frames, 2);
  EXPECT_LE(log.at("time").back(), time);
  EXPECT_EQ(count_starting(files, "frame_", ".png"), frames);
  for (int frame = 0; frame < frames; ++frame) {
    char name[32];
    std::snprintf(name, sizeof name, "frame_%04d.png", frame);
    EXPECT_EQ(read_png(directory / "out" / name).width, 80);
  }
  EXPECT_TRUE(exists(directory / "out/film.png"));
  EXPECT_EQ(count_starting(files, "", ".part"), 0);
  EXPECT_EQ(count_starting(files, "final", ""), 0) << "an exploded state is not worth continuing";

  EXPECT_NEAR(try_h, 0.8 * h_crit, 0.05 * h_crit);
  Arguments advised = with_h(try_h, "advised");
  advised.push_back("--no-pictures");
  expect_done(advised);
}

// A terminal that is closed sends SIGHUP; a reader of the output that ends, SIGPIPE.
TEST_P(StopsTest, CtrlCFinishesTheLogTheFilmAndTheLastState) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) {
    std::filesystem::remove_all(directory / "out");
    Running running(GetParam().path,
                    {GetParam().square(), "--end", "1000", "--frames", "9999", "--size", "80x45",
                     "--out", "out"},
                    directory);
    ASSERT_TRUE(running.wait_for_output("frame 2 of", 60));
    running.send(signal);
    const Outcome outcome = running.wait(20);
    EXPECT_EQ(outcome.code, 130);
    EXPECT_EQ(outcome.err, "");

    const std::vector<std::string> files = files_in(directory / "out");
    EXPECT_EQ(count_starting(files, "", ".part"), 0);
    const Table log = read_table(directory / "out/log.csv");
    const size_t frames = log.at("frame").size();
    EXPECT_GE(frames, 3u);
    EXPECT_EQ(size_t(count_starting(files, "frame_", ".png")), frames);
    for (size_t frame = 0; frame < frames; ++frame)
      EXPECT_NEAR(log.at("time")[frame], 1000.0 / 9999 * double(frame), 0.006)
          << "every frame stands at its own time";
    EXPECT_TRUE(exists(directory / "out/film.png"));
    EXPECT_EQ(read_obj(directory / "out/final.obj").vertices(), 1681);
    EXPECT_EQ(read_velocities(directory / "out/final_velocities.csv", 1681).size(), 3 * 1681);
    const double time = number_after(outcome.out, "hold the cloth at t = ");
    EXPECT_GE(time, log.at("time").back());
    EXPECT_NE(outcome.out.find("stopped: "), std::string::npos) << outcome.out;
  }
}

TEST_P(StopsTest, TwoRunsNeverWriteIntoOneDirectory) {
  const Arguments endless = {GetParam().square(), "--end", "1000", "--frames", "9999",
                             "--no-pictures",     "--out", "out"};
  {
    Running first(GetParam().path, endless, directory);
    ASSERT_TRUE(first.wait_for_output("frame 0 of", 60));
    const Outcome second = run(small_square(4, {"--end", "0.01", "--out", "out"}));
    EXPECT_EQ(second.code, 2);
    EXPECT_NE(second.err.find("--out out: another run writes there"), std::string::npos)
        << second.err;
    first.send(SIGKILL);
    EXPECT_EQ(first.wait(20).code, -1);
  }
  EXPECT_EQ(count_starting(files_in(directory / "out"), "", ".part"), 1);
  expect_done(small_square(4, {"--end", "0.01", "--no-pictures", "--out", "out"}));
  EXPECT_EQ(count_starting(files_in(directory / "out"), "", ".part"), 0)
      << "a run that was killed blocks nobody";
}

TEST_P(StopsTest, FilesOfAnEarlierRunGoWhenTheFirstFrameComes) {
  std::filesystem::create_directory(directory / "out");
  for (const char* name : {"frame_0099.png", "frame_0099.obj", "film.png", "motion.png",
                           "motion.mp4", "points.pc2", "notes.txt"})
    write(std::string("out/") + name, "old");
  const Arguments small = small_square(4, {"--end", "0.01", "--no-pictures", "--out", "out"});
  Arguments refused = small;
  refused.insert(refused.end(), {"--h", "1"});
  EXPECT_EQ(run(refused).code, 2);
  EXPECT_EQ(files_in(directory / "out").size(), 7u) << "a run that fails touches nothing";
  expect_done(small);
  EXPECT_EQ(files_in(directory / "out"),
            (std::vector<std::string>{"final.obj", "final_velocities.csv", "log.csv", "notes.txt",
                                      "run.toml"}));
}

TEST_P(StopsTest, ADirectoryWithTheNameOfAResultIsRefusedAtOnce) {
  std::filesystem::create_directories(directory / "out/final.obj");
  const Outcome outcome = run(small_square(4, {"--out", "out"}));
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(outcome.err.find("final.obj is a directory"), std::string::npos) << outcome.err;
  EXPECT_EQ(files_in(directory / "out"), std::vector<std::string>{"final.obj"});
}

// The log must not get the descriptor of the standard output.
TEST_P(StopsTest, WithTheStandardOutputClosedTheResultsAreTheSame) {
  const auto shell = [&](const std::string& out, const std::string& redirect) {
    std::string command = "exec '" + GetParam().path.string() + "'";
    for (const std::string& word : small_square(4, {"--end", "0.01", "--no-pictures"}))
      command += " '" + word + "'";
    return Running("/bin/sh", {"-c", command + " --out " + out + redirect}, directory).wait(60);
  };
  EXPECT_EQ(shell("open", "").code, 0);
  EXPECT_EQ(shell("closed", " >&-").code, 0);
  Table open = read_table(directory / "open/log.csv"),
        closed = read_table(directory / "closed/log.csv");
  open.erase("milliseconds"), closed.erase("milliseconds");
  EXPECT_EQ(open, closed);
}

TEST_P(StopsTest, APageThatIsLostIsAnError) {
  for (const std::string page : {"--help", "--version", "--explain --cells 4 --end 0.01"}) {
    const std::string command = "exec '" + GetParam().path.string() + "' '" +
                                GetParam().square().string() + "' " + page + " > /dev/full";
    const Outcome outcome = Running("/bin/sh", {"-c", command}, directory).wait(120);
    EXPECT_EQ(outcome.code, 1) << page;
    EXPECT_NE(outcome.err.find("could not be written"), std::string::npos) << outcome.err;
  }
}

INSTANTIATE_TEST_SUITE_P(Programs, StopsTest, testing::ValuesIn(programs()), name_of);
INSTANTIATE_TEST_SUITE_P(Programs, ExplosionTest, testing::ValuesIn(explicit_programs()), name_of);

}  // namespace program_stops_test
