// --motion and --export pc2: the run as a film and as a point cache.
#include <algorithm>
#include <bit>
#include <cstdlib>
#include <cstring>
#include <sstream>

#include "scene/mesh.h"
#include "support/program_runner.h"
#include "support/read_animation.h"

namespace program_film_test {

class FilmTest : public ProgramDirectory {
 protected:
  // The falling square metre on few cells.
  Outcome run_square(const std::string& options, const std::string& out = "out") const {
    Arguments arguments = {program.square(), "--cells", "6", "--out=" + out};
    std::istringstream words(options);
    for (std::string word; words >> word;) arguments.push_back(word);
    return run(program, arguments);
  }

  // An ffmpeg that does what the lines of the script say, and the only program that is found.
  void install_ffmpeg(const std::string& script) const {
    std::filesystem::create_directory(directory / "bin");
    std::filesystem::permissions(write("bin/ffmpeg", "#!/bin/sh\n" + script),
                                 std::filesystem::perms::owner_all);
    setenv("PATH", (directory / "bin").c_str(), 1);
  }

  ~FilmTest() override { setenv("PATH", path.c_str(), 1); }

  // That film.png holds these frames in reading order, in rows of `columns`. Pictures of 80x45 are not reduced,
  // and with --caption they have no time in their corner.
  void expect_film_of(const std::vector<int>& frames, int columns) const {
    const Image film = read_png(directory / "out/film.png");
    const int width = 80 + 4, height = 45 + 4, count = int(frames.size());
    ASSERT_EQ(film.width, columns * width);
    ASSERT_EQ(film.height, (count + columns - 1) / columns * height);
    Image expected = filled_image(film.width, film.height, {255, 255, 255});
    for (int i = 0; i < count; ++i) {
      char name[32];
      std::snprintf(name, sizeof name, "out/frame_%04d.png", frames[size_t(i)]);
      paste(read_png(directory / name), 2 + i % columns * width, 2 + i / columns * height,
            expected);
    }
    EXPECT_TRUE(film.rgb == expected.rgb);
  }

  const std::string two_frames = "--end 0.5 --frames 2 --motion --caption --size ";
  const std::string three_steps = "--end 0.0006 --frames 1 --motion --size ";
  const StepProgram program = program_called("step01_explicit");
  const std::string path = getenv("PATH");
};

// 26 frames have 13 parts of two frames, but 12 are the most: each third frame, and the last.
TEST_F(FilmTest, FilmShowsFrame0ThenEvenMomentsAndTheLastFrame) {
  EXPECT_EQ(run_square("--end 0.26 --frames 26 --caption --size 80x45").code, 0);
  expect_film_of({0, 3, 6, 9, 12, 15, 18, 21, 24, 26}, 5);
}

TEST_F(FilmTest, FilmShowsTheStartAndAllTwelveFramesOfARun) {
  EXPECT_EQ(run_square("--end 0.12 --caption --size 80x45").code, 0);
  expect_film_of({0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}, 5);
}

TEST_F(FilmTest, FilmEndsWithTheLastFrameBeforeAnExplosion) {
  EXPECT_EQ(run_square("--h 0.002 --end 0.4 --frames 100 --caption --size 80x45").code, 1);
  const int last = int(read_table(directory / "out/log.csv").at("frame").back());
  ASSERT_GT(last, 9);
  ASSERT_LT(last, 18);
  expect_film_of({0, 9, last}, 3);
}

// Pictures at the moments i/24, and frames at i = 0, 12, 24. With --caption neither has the time in its corner.
TEST_F(FilmTest, MotionHas24MomentsAfterTheStartAndShowsTheFrames) {
  setenv("PATH", "", 1);
  const Outcome outcome = run_square(two_frames + "80x45");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const std::vector<AnimationFrame> film = read_animation(directory / "out/motion.png");
  ASSERT_EQ(film.size(), 25u);
  for (const int frame : {0, 1, 2}) {
    const std::string name = "out/frame_000" + std::to_string(frame) + ".png";
    EXPECT_EQ(film[size_t(12 * frame)].image.rgb, read_png(directory / name).rgb) << name;
  }
  for (size_t i = 1; i < film.size(); ++i) {
    EXPECT_NE(film[i].image.rgb, film[i - 1].image.rgb) << "picture " << i << " moves on";
    EXPECT_EQ(film[i - 1].milliseconds, 42) << "a short run plays for 1 s";
  }
  EXPECT_EQ(film.back().milliseconds, 1042) << "then it rests for 1 s";
  EXPECT_EQ(read_png_text(directory / "out/motion.png").back(),
            (std::pair<std::string, std::string>{"Time", "0.5 s"}));

  EXPECT_NE(read_all(directory / "out/run.toml").find("'--motion'"), std::string::npos);
  EXPECT_EQ(run(program, {"out/run.toml", "--no-pictures", "--out", "none"}).code, 0)
      << "the command line goes before [run]";
  EXPECT_FALSE(exists(directory / "none/motion.png"));
  Table with = read_table(directory / "out/log.csv"), none = read_table(directory / "none/log.csv");
  with.erase("milliseconds"), none.erase("milliseconds");
  EXPECT_EQ(with, none) << "the film changes nothing";
}

TEST_F(FilmTest, MotionHasAPictureForEachOfFewSteps) {
  setenv("PATH", "", 1);
  EXPECT_EQ(run_square(three_steps + "80x45").code, 0);
  EXPECT_EQ(read_animation(directory / "out/motion.png").size(), 4u);
}

TEST_F(FilmTest, MotionHasAtMost480PixelsASide) {
  setenv("PATH", "", 1);
  EXPECT_EQ(run_square(three_steps + "24x961").code, 0);
  const Image image = read_png(directory / "out/motion.png");
  EXPECT_EQ(image.width, 12);
  EXPECT_EQ(image.height, 480);
}

TEST_F(FilmTest, AnExplosionLeavesTheFilmAndTheSamplesUntilThen) {
  setenv("PATH", "", 1);
  const Outcome outcome =
      run_square("--h 0.002 --end 0.1 --frames 25 --motion --export pc2 --size 80x45");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_NE(outcome.err.find("exploded"), std::string::npos) << outcome.err;
  const size_t pictures = read_animation(directory / "out/motion.png").size();
  EXPECT_GT(pictures, 1u);
  EXPECT_LT(pictures, 25u);
  const size_t rows = read_table(directory / "out/log.csv").at("frame").size();
  const std::string cache = read_all(directory / "out/points.pc2");
  EXPECT_EQ(cache.size(), 32 + rows * 12 * 49);
  EXPECT_EQ(size_t(cache[28]), rows);
  EXPECT_EQ(count_starting(files_in(directory / "out"), "", ".part"), 0);
}

// An explicit run is checked for an explosion every tenth step, and this one has a picture after each step.
TEST_F(FilmTest, AClothThatHasExplodedIsNotDrawn) {
  setenv("PATH", "", 1);
  const Outcome outcome = run_square("--h 0.05 --end 1 --frames 1 --motion --size 80x45");
  EXPECT_EQ(outcome.code, 1);
  const std::string words = "exploded in step ";
  const size_t at = outcome.err.find(words);
  ASSERT_NE(at, std::string::npos) << outcome.err;
  const size_t pictures = read_animation(directory / "out/motion.png").size();
  EXPECT_GT(pictures, 1u);
  EXPECT_LT(pictures, std::stoul(outcome.err.substr(at + words.size()))) << outcome.err;
}

const std::string video_is_missing = "motion.mp4 was not made: ";

TEST_F(FilmTest, WithoutFfmpegTheCommandIsPrintedAndWorksInAShell) {
  setenv("PATH", "", 1);
  const std::string out = "-y of $(id): 'a' \"b\"";
  const Outcome outcome = run_square(three_steps + "80x45", out);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find(video_is_missing + "ffmpeg is not installed"), std::string::npos)
      << outcome.out;
  EXPECT_FALSE(exists(directory / out / "motion.mp4"));

  install_ffmpeg("for word; do echo \"$word\"; done\n");
  const std::string command = lines_of(outcome.out).back();
  const std::vector<std::string> words =
      lines_of(Running("/bin/sh", {"-c", command}, directory).wait(60).out);
  EXPECT_EQ(words.back(), "file:" + out + "/motion.mp4");
  EXPECT_EQ(std::ranges::count(words, "file:" + out + "/motion.png"), 1) << command;
}

TEST_F(FilmTest, FfmpegGetsTheNamesAsTheyAre) {
  install_ffmpeg("for word; do echo \"$word\"; done > words\necho video > \"${word#file:}\"\n");
  const std::string out = "-y of $(id): 'a' \"b\"";
  const Outcome outcome = run_square(three_steps + "80x45", out);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out.find(video_is_missing), std::string::npos) << outcome.out;
  EXPECT_EQ(read_all(directory / out / "motion.mp4"), "video\n");
  const std::vector<std::string> words = lines_of(read_all(directory / "words"));
  EXPECT_EQ(std::ranges::count(words, "file:" + out + "/motion.png"), 1);
}

TEST_F(FilmTest, AnFfmpegThatFailsIsSaidAndTheRunIsKept) {
  install_ffmpeg("for word; do :; done; echo half > \"${word#file:}\"\nexit 3\n");
  const Outcome outcome = run_square(three_steps + "80x45");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find(video_is_missing + "ffmpeg ended with exit code 3"), std::string::npos)
      << outcome.out;
  const std::vector<std::string> files = files_in(directory / "out");
  EXPECT_EQ(count_starting(files, "motion.", ""), 1) << "motion.png alone";
  EXPECT_EQ(count_starting(files, "final", ""), 2);
}

// What ffmpeg itself reads from both films; skipped where there is no ffmpeg.
TEST_F(FilmTest, FfmpegReadsAllPicturesFromBothFilms) {
  const auto frames = [&](const std::string& file) {
    return Running("/bin/sh",
                   {"-c",
                    "ffprobe -v error -count_frames -show_entries "
                    "stream=codec_name,width,height,pix_fmt,nb_read_frames -of csv=p=0 " +
                        file},
                   directory)
        .wait(60);
  };
  if (Running("/bin/sh", {"-c", "ffmpeg -encoders | grep libx264"}, directory).wait(60).code != 0)
    GTEST_SKIP() << "no ffmpeg with libx264 here";
  EXPECT_EQ(run_square(three_steps + "161x91").code, 0);
  EXPECT_EQ(frames("out/motion.png").out, "apng,161,91,rgb24,4\n");
  EXPECT_EQ(frames("out/motion.mp4").out, "h264,160,90,yuv420p,4\n");
}

template <class Number>
Number number_at(const std::string& bytes, size_t place) {
  static_assert(std::endian::native == std::endian::little);
  Number number;
  std::memcpy(&number, bytes.data() + place, sizeof number);
  return number;
}

TEST_F(FilmTest, ThePointCacheHasTheMeshesOfAllFrames) {
  const Outcome outcome =
      run_square("--end 0.5 --frames 2 --no-pictures --export obj --export pc2");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const std::string cache = read_all(directory / "out/points.pc2");
  ASSERT_EQ(cache.size(), 32u + 3 * 49 * 12);
  EXPECT_EQ(cache.substr(0, 12), std::string("POINTCACHE2\0", 12));
  EXPECT_EQ(number_at<int>(cache, 12), 1) << "version";
  EXPECT_EQ(number_at<int>(cache, 16), 49) << "vertices";
  EXPECT_EQ(number_at<float>(cache, 20), 0) << "first frame";
  EXPECT_EQ(number_at<float>(cache, 24), 1) << "frames per sample";
  EXPECT_EQ(number_at<int>(cache, 28), 3) << "samples";
  size_t place = 32;
  for (const char* name : {"frame_0000.obj", "frame_0001.obj", "frame_0002.obj"})
    for (const double coordinate : read_obj_vertices(directory / "out" / name)) {
      EXPECT_EQ(number_at<float>(cache, place), float(coordinate)) << name;
      place += sizeof(float);
    }
}

TEST_F(FilmTest, AFullDiskLeavesTheWholeSamplesOfThePointCache) {
  const Outcome full = run(program,
                           {program.square(), "--cells", "8", "--end", "0.02", "--frames", "2",
                            "--no-pictures", "--export", "pc2", "--out", "out"},
                           1500);
  EXPECT_EQ(full.code, 1);
  EXPECT_NE(full.err.find("out/points.pc2: File too large"), std::string::npos) << full.err;
  const std::string cache = read_all(directory / "out/points.pc2");
  EXPECT_EQ(cache.size(), 32u + 81 * 12);
  EXPECT_EQ(number_at<int>(cache, 28), 1);
}

}  // namespace program_film_test
