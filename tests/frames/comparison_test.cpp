#include "comparison.h"

#include <gtest/gtest.h>
#include <cmath>

#include "cloth_pixels.h"
#include "comparison_text.h"
#include "made_up_run.h"
#include "support/program_runner.h"
#include "test_scene.h"
#include "text/bad_input.h"

namespace comparison_test {

class RunsTest : public ProgramDirectory {
 protected:
  const Comparison& compare() {
    a = read_run(first.directory);
    b = read_run(second.directory);
    comparison = compare_runs(a, b);
    return comparison;
  }
  bool notes(const std::string& words) const {
    return std::find(comparison.notes.begin(), comparison.notes.end(), words) !=
           comparison.notes.end();
  }
  // Both runs get the same frame with these pictures.
  void both(double time, const Image& of_a, const Image& of_b) {
    first.frame(time).picture(of_a);
    second.frame(time).picture(of_b);
  }

  MadeUpRun first{directory / "a"}, second{directory / "b"};
  RecordedRun a, b;
  Comparison comparison;
};

// --- what belongs together

TEST_F(RunsTest, FramesArePairedByTimeWithinHalfAStepOfEach) {
  first.toml(0.01).frame(0).frame(0.13).frame(0.25).frame(0.38);
  second.toml(0.02).frame(0).frame(0.12).frame(0.18).frame(0.26).frame(0.4);
  ASSERT_EQ(compare().frames.size(), 3u);
  EXPECT_EQ(comparison.frames[1].a->number, 1);
  EXPECT_EQ(comparison.frames[1].b->number, 1);
  EXPECT_EQ(comparison.frames[2].a->number, 2);
  EXPECT_EQ(comparison.frames[2].b->number, 3);
  EXPECT_TRUE(notes("B has no frame at t = 0.38 s")) << comparison_text(comparison);
  EXPECT_TRUE(notes("A has no frame at 2 times, of which the first is t = 0.18 s"));
}

TEST_F(RunsTest, NoFrameIsTheNearestOfTwo) {
  first.toml(0.1).frame(0).frame(0.1).frame(0.2);
  second.toml(0.1).frame(0).frame(0.2);
  ASSERT_EQ(compare().frames.size(), 2u);
  EXPECT_EQ(comparison.frames[1].a->number, 2);
}

TEST_F(RunsTest, RunThatBrokeOffIsDifferentEvenIfItsFramesAreIdentical) {
  first.frame(0).frame(0.1).frame(0.2);
  second.frame(0).frame(0.1);
  EXPECT_EQ(compare().verdict, Verdict::DIFFERENT);
  EXPECT_FALSE(comparison.first_difference);
  EXPECT_EQ(summary(comparison),
            "No frame differs, but B has partners for only 2 of A's 3 frames.");
}

TEST_F(RunsTest, RunsWithoutACommonTimeAreDifferent) {
  first.frame(0);
  second.frame(5);
  EXPECT_EQ(compare().verdict, Verdict::DIFFERENT);
  EXPECT_EQ(summary(comparison), "No two frames are of the same time.");
}

// --- pictures

TEST_F(RunsTest, PixelsAreCountedInTheUnionOfTheTwoCloths) {
  both(0, cloth_on_the_wall(20), cloth_on_the_wall(20));
  both(1, cloth_on_the_wall(20), cloth_on_the_wall(25));
  EXPECT_EQ(compare().verdict, Verdict::DIFFERENT);
  EXPECT_EQ(comparison.frames[0].verdict, Verdict::IDENTICAL);
  EXPECT_EQ(comparison.frames[0].picture->of, 400);
  EXPECT_EQ(comparison.frames[1].picture->of, 500);
  EXPECT_EQ(comparison.frames[1].picture->pixels, 200);
  EXPECT_EQ(comparison.first_difference, 1u);
  EXPECT_EQ(summary(comparison),
            "The first frame that differs is frame 1, t = 1 s: 200 of the 500 pixels of the cloth "
            "differ.");
}

TEST_F(RunsTest, DifferenceBesideTheClothIsSaidToBeThere) {
  Image shadow = cloth_on_the_wall(20);
  paste(filled_image(10, 10, {150, 160, 170}), 50, 2, shadow);
  both(0, cloth_on_the_wall(20), shadow);
  EXPECT_EQ(compare().verdict, Verdict::DIFFERENT);
  EXPECT_EQ(comparison.frames[0].picture->pixels, 0);
  EXPECT_NE(summary(comparison).find("100 pixels differ, none of them shows the cloth"),
            std::string::npos)
      << summary(comparison);
}

TEST_F(RunsTest, ScatteredNoiseIsEquivalent) {
  Image noise = cloth_on_the_wall(20);
  noise.rgb[pixel_at(noise, 30, 20)] = 202;
  both(0, cloth_on_the_wall(20), noise);
  EXPECT_EQ(compare().verdict, Verdict::EQUIVALENT);
  EXPECT_EQ(summary(comparison), "All frames (1) are equivalent.");
}

// A pixel shows the cloth where the same cloth looks different by strain.
TEST(ClothPixels, AreThoseOfTheClothFromBothSides) {
  for (const double side : {1.0, -1.0}) {
    TestScene scene = hung_cloth();
    scene.stage.eye.z() *= side;
    Renderer renderer(scene.surface);
    const Image checker = renderer.draw(scene.stage, scene.x, scene.style);
    scene.style.strain_scale = 0.1;
    const Image strain = renderer.draw(scene.stage, scene.x, scene.style, scene.strain);
    long cloth = 0, missed = 0, wrong = 0;
    for (size_t i = 0; i < checker.rgb.size(); i += 3) {
      const bool is_cloth = pixel_difference(&checker.rgb[i], &strain.rgb[i]) > 0;
      for (const Image* image : {&checker, &strain}) {
        cloth += is_cloth;
        missed += is_cloth && !shows_cloth(&image->rgb[i]);
        wrong += !is_cloth && shows_cloth(&image->rgb[i]);
      }
    }
    std::printf("%ld pixels of cloth, %ld missed, %ld of something else\n", cloth, missed, wrong);
    EXPECT_GT(cloth, 10000);
    EXPECT_LT(double(missed), 0.02 * double(cloth)) << "pixels at the border";
    EXPECT_LT(double(wrong), 0.005 * double(cloth)) << "pins";
  }
}

// --- positions

TEST_F(RunsTest, DistancesAreInMetresWithTheWorstVertex) {
  first.frame(0).mesh(triangle);
  second.frame(0).mesh({{0, 0, 0.003}, {1, 0.004, 0}, {0, 1, 0}});
  EXPECT_EQ(compare().verdict, Verdict::DIFFERENT);
  const PositionComparison& position = *comparison.frames[0].position;
  EXPECT_NEAR(position.worst, 0.004, 1e-15);
  EXPECT_EQ(position.worst_vertex, 1);
  EXPECT_NEAR(position.rms, 0.005 / std::sqrt(3), 1e-15);
  EXPECT_EQ(summary(comparison),
            "The first frame that differs is frame 0, t = 0 s: vertex 1 is 4 mm away.");
}

TEST_F(RunsTest, HiddenVertexThatMovedMakesEqualPicturesDifferent) {
  both(0, cloth_on_the_wall(20), cloth_on_the_wall(20));
  first.mesh(triangle);
  second.mesh({{0, 0, 0.005}, {1, 0, 0}, {0, 1, 0}});
  EXPECT_EQ(compare().verdict, Verdict::DIFFERENT);
}

TEST_F(RunsTest, PicturesThatDifferAreDifferentEvenIfNoVertexMoved) {
  both(0, cloth_on_the_wall(20), cloth_on_the_wall(25));
  first.mesh(triangle);
  second.mesh(triangle);
  EXPECT_EQ(compare().verdict, Verdict::DIFFERENT);
}

TEST_F(RunsTest, PositionsAreEquivalentUpToAFiveThousandthOfTheSize) {
  first.frame(0).mesh(triangle).frame(1).mesh(triangle);  // the size is √2
  second.frame(0).mesh({{0, 0, 0.00028}, {1, 0, 0}, {0, 1, 0}});
  second.frame(1).mesh({{0, 0, 0.00029}, {1, 0, 0}, {0, 1, 0}});
  compare();
  EXPECT_EQ(comparison.frames[0].verdict, Verdict::EQUIVALENT);
  EXPECT_EQ(comparison.frames[1].verdict, Verdict::DIFFERENT);
}

// --- the log

TEST_F(RunsTest, WithoutPicturesAndMeshesTheLogDecides) {
  first.frame(0).frame(1).frame(2).frame(3).frame(4, -1, -0.6);  // the largest energy is 4 J
  second.frame(0).frame(1, -1.0003).frame(2, -1.0003).frame(3, -1.1).frame(4, -1, -0.61);
  std::vector<Verdict> verdicts;
  for (const FramePair& pair : compare().frames) verdicts.push_back(pair.verdict);
  EXPECT_EQ(verdicts, (std::vector{Verdict::IDENTICAL, Verdict::EQUIVALENT, Verdict::DIFFERENT,
                                   Verdict::DIFFERENT, Verdict::DIFFERENT}));
  EXPECT_NE(summary(comparison).find("total is -2 in A and -2.0006 in B"), std::string::npos)
      << summary(comparison);
  EXPECT_TRUE(notes("no distances in mm: make both runs with --export obj to have them"));
}

TEST_F(RunsTest, ExplosionLaterHidesNoEarlierDifference) {
  first.frame(0).frame(1).frame(2);
  second.frame(0).frame(1, -1.1).frame(2, INFINITY);
  compare();
  EXPECT_EQ(comparison.first_difference, 1u);
  EXPECT_EQ(comparison.frames[2].verdict, Verdict::DIFFERENT);
  EXPECT_EQ(compare_runs(b, a).first_difference, 1u) << "a reference that explodes";
}

TEST_F(RunsTest, EnergyThatIsNoNumberIsDifferent) {
  first.frame(0).frame(1);
  second.frame(0).frame(1, NAN);
  EXPECT_EQ(compare().verdict, Verdict::DIFFERENT);
}

// --- what differs in the input

TEST_F(RunsTest, InputsAreComparedKeyByKeyAndOptionByOption) {
  first.frame(0).toml(0.01, "'--newton=1', '--wireframe'", "[cloth]\npins = ['top', 3]\n");
  second.frame(0).toml(0.02, "'--newton=3'", "[cloth]\npins = ['top', 4]\ndensity = 0.2\n");
  std::string lines;
  for (const InputDifference& input : compare().inputs)
    lines += input.key + ": " + input.a + " | " + input.b + "\n";
  EXPECT_EQ(lines,
            "--newton: 1 | 3\n"
            "--wireframe: on | (absent)\n"
            "cloth.density: (absent) | 0.2\n"
            "cloth.pins: ['top', 3] | ['top', 4]\n"
            "time.h: 0.01 | 0.02\n");
  EXPECT_EQ(comparison.verdict, Verdict::IDENTICAL) << "inputs alone decide nothing";
}

// --- what is missing or broken: one line each, and the rest is compared

TEST_F(RunsTest, MissingPicturesAreNamedOnce) {
  both(0, cloth_on_the_wall(20), cloth_on_the_wall(20));
  for (const double time : {1., 2., 3.}) {
    first.frame(time).picture(cloth_on_the_wall(20));
    second.frame(time);
  }
  EXPECT_EQ(compare().frames.size(), 4u);
  EXPECT_TRUE(notes("B has no picture at 3 times, of which the first is t = 1 s"));
}

TEST_F(RunsTest, BrokenFilesAreNamedAndTheRestIsCompared) {
  both(0, cloth_on_the_wall(20), cloth_on_the_wall(20));
  second.file("frame_0000.png", "no picture");
  both(1, cloth_on_the_wall(20), cloth_on_the_wall(20));
  first.mesh(triangle);
  second.file("frame_0001.obj", "v 1 2\nf 1 1 1\n");
  second.file("run.toml", "[time\n");
  compare();
  EXPECT_TRUE(comparison.frames[1].picture);
  EXPECT_TRUE(comparison.inputs.empty()) << "nothing is known of B";
  ASSERT_EQ(comparison.notes.size(), 3u) << comparison_text(comparison);
  EXPECT_NE(comparison.notes[0].find("B: "), std::string::npos);
  EXPECT_NE(comparison.notes[0].find("run.toml:1: "), std::string::npos) << comparison.notes[0];
  EXPECT_NE(comparison.notes[1].find("frame_0000.png: not a PNG file"), std::string::npos);
  EXPECT_NE(comparison.notes[2].find("frame_0001.obj:1: "), std::string::npos);
}

TEST_F(RunsTest, DirectoryInPlaceOfAPictureIsNamed) {
  first.frame(0).picture(cloth_on_the_wall(20));
  second.frame(0);
  create_directory(second.directory / "frame_0000.png");
  EXPECT_EQ(compare().verdict, Verdict::DIFFERENT);
  EXPECT_NE(comparison.notes[0].find("frame_0000.png: this is a directory"), std::string::npos)
      << comparison.notes[0];
  EXPECT_EQ(summary(comparison),
            "The first frame that differs is frame 0, t = 0 s: a file of it cannot be read.");
}

TEST_F(RunsTest, MeshesWithoutVerticesAreIdentical) {
  first.frame(0).file("frame_0000.obj", "");
  second.frame(0).file("frame_0000.obj", "");
  EXPECT_EQ(compare().verdict, Verdict::IDENTICAL);
}

TEST_F(RunsTest, BrokenPictureOrMeshIsDifferent) {
  both(0, cloth_on_the_wall(20), cloth_on_the_wall(20));
  second.file("frame_0000.png", "no picture");
  EXPECT_EQ(compare().verdict, Verdict::DIFFERENT);
}

TEST_F(RunsTest, OtherSizesOfPicturesAndClothsAreSaidAndNotCompared) {
  both(0, cloth_on_the_wall(20), cloth_on_the_wall(20, 80));
  first.mesh(triangle);
  second.mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}});
  compare();
  EXPECT_FALSE(comparison.frames[0].picture);
  EXPECT_FALSE(comparison.frames[0].position);
  EXPECT_TRUE(notes("the pictures of A are 64x48, those of B 80x48: not compared"));
  EXPECT_TRUE(notes("A has 3 vertices, B 4: positions are not compared"));
}

// --- what is no run

class RunRefusal : public ProgramDirectory {
 protected:
  std::string message() const {
    try {
      read_run(directory / "a");
      return "";
    } catch (const BadInput& refusal) {
      return refusal.what();
    }
  }
  std::string message_of_log(const std::string& log) const {
    MadeUpRun(directory / "a").file("log.csv", log);
    return message();
  }
};

TEST_F(RunRefusal, SaysWhatIsMissing) {
  EXPECT_NE(message().find("is no directory"), std::string::npos);
  MadeUpRun(directory / "a");
  EXPECT_NE(message().find("has no log.csv"), std::string::npos);
}

TEST_F(RunRefusal, NamesTheLineOfTheLog) {
  const std::vector<std::pair<std::string, std::string>> logs = {
      {"", "log.csv: is empty"},
      {"frame,time\n", "log.csv: has no frame"},
      {"frame,total\n0,1\n", "log.csv:1: has no column time"},
      {"frame,time\n0,0\n1\n", "log.csv:3: has 1 number, but the header names 2 columns"},
      {"frame,time\n0,zero\n", "log.csv:2: wants numbers, not \"zero\""},
      {"frame,time\n-1,0\n", "log.csv:2: has no valid number of a frame"},
      {"frame,time\n0,0\n1,0\n", "log.csv:3: its time is not after that of the row before"},
      {"frame,time\n0,nan\n", "log.csv:2: its time is not after"},
      {"frame,time\n0,0\n1,inf\n", "log.csv:3: its time is not after"},
  };
  for (const auto& [log, expected] : logs)
    EXPECT_NE(message_of_log(log).find(expected), std::string::npos) << message_of_log(log);
}

}  // namespace comparison_test
