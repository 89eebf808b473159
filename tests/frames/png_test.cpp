#include "picture/png.h"

#include <gtest/gtest.h>
#include <fstream>

namespace png_test {

namespace fs = std::filesystem;

// An empty directory that is removed after the test.
struct Directory {
  fs::path path;
  Directory() {
    std::string name = (fs::temp_directory_path() / "frames_XXXXXX").string();
    path = mkdtemp(name.data());
  }
  ~Directory() { fs::remove_all(path); }
};

std::size_t entries(const fs::path& path) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(path), {}));
}

Image some_image(int width, int height) {
  Image image = filled_image(width, height, {0, 0, 0});
  unsigned state = 1;
  for (unsigned char& value : image.rgb)
    value = static_cast<unsigned char>((state = state * 1664525u + 1013904223u) >> 24);
  return image;
}

std::string bytes(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::string failure(const fs::path& path, const Image& image) {
  try {
    write_png(path, image);
  } catch (const std::exception& error) {
    return error.what();
  }
  return "nothing failed";
}

void expect_mentions(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << text;
}

TEST(Png, RoundTrip) {
  const Directory directory;
  const Image image = some_image(37, 21);
  const PngText text = {{"Software", "frames test"}, {"Time", "0.5 s"}, {"Empty", ""}};
  write_png(directory.path / "a.png", image, text);
  const Image back = read_png(directory.path / "a.png");
  EXPECT_EQ(back.width, 37);
  EXPECT_EQ(back.height, 21);
  EXPECT_EQ(back.rgb, image.rgb);
  EXPECT_EQ(read_png_text(directory.path / "a.png"), text);
  EXPECT_EQ(entries(directory.path), 1u) << "no .part is left";
}

TEST(Png, SameImageSameBytesAndMarkedSrgb) {
  const Directory directory;
  write_png(directory.path / "a.png", some_image(40, 30), {{"k", "v"}});
  write_png(directory.path / "b.png", some_image(40, 30), {{"k", "v"}});
  EXPECT_EQ(bytes(directory.path / "a.png"), bytes(directory.path / "b.png"));
  expect_mentions(bytes(directory.path / "a.png"), "sRGB");
}

TEST(Png, OverwritesARegularFile) {
  const Directory directory;
  std::ofstream(directory.path / "a.png") << "something else";
  write_png(directory.path / "a.png", some_image(5, 5));
  EXPECT_EQ(read_png(directory.path / "a.png").width, 5);
}

TEST(Png, MissingDirectoryIsNamed) {
  const Directory directory;
  const fs::path path = directory.path / "nowhere" / "a.png";
  expect_mentions(failure(path, some_image(5, 5)), path.string() + ": No such file or directory");
}

TEST(Png, RefusesWhatIsNotARegularFile) {
  const Directory directory;
  fs::create_directory(directory.path / "a.png");
  expect_mentions(failure(directory.path / "a.png", some_image(5, 5)), "not a regular file");
  expect_mentions(failure("/dev/null", some_image(5, 5)), "not a regular file");
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  EXPECT_EQ(entries(directory.path), 1u);
}

// The .part lies on a device that is always full.
TEST(Png, FullDiskIsSaidAndLeavesTheOldPicture) {
  if (!fs::is_character_file("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  const Directory directory;
  for (const int side : {5, 300}) {  // the first fails when flushed, the second before
    write_png(directory.path / "a.png", some_image(7, 7));
    fs::create_symlink("/dev/full", directory.path / "a.png.part");
    expect_mentions(failure(directory.path / "a.png", some_image(side, side)),
                    "No space left on device");
    EXPECT_EQ(entries(directory.path), 1u) << "no .part is left";
    EXPECT_EQ(read_png(directory.path / "a.png").width, 7) << "the old picture is whole";
    EXPECT_TRUE(fs::is_character_file("/dev/full"));
  }
}

TEST(Png, RefusesImagesWithoutPixels) {
  const Directory directory;
  expect_mentions(failure(directory.path / "a.png", Image{}), "empty");
  Image torn = some_image(5, 5);
  torn.rgb.pop_back();
  expect_mentions(failure(directory.path / "a.png", torn), "does not fit");
  EXPECT_EQ(entries(directory.path), 0u);
}

TEST(Png, UnreadableFilesAreNamed) {
  const Directory directory;
  EXPECT_THROW(read_png(directory.path / "a.png"), std::runtime_error);
  EXPECT_THROW(read_png_text(directory.path / "a.png"), std::runtime_error);
  std::ofstream(directory.path / "a.png") << "no picture";
  EXPECT_THROW(read_png(directory.path / "a.png"), std::runtime_error);
  EXPECT_THROW(read_png_text(directory.path / "a.png"), std::runtime_error);
  write_png(directory.path / "b.png", some_image(30, 30));
  fs::resize_file(directory.path / "b.png", 1000);
  EXPECT_THROW(read_png(directory.path / "b.png"), std::runtime_error);
  EXPECT_THROW(read_png_text(directory.path / "b.png"), std::runtime_error);
}

// A file of a hundred bytes cannot make the program allocate gigabytes.
TEST(Png, AHeaderAndAChunkThatClaimTooMuchAreRefused) {
  const fs::path corpus = CORPUS;
  for (const auto& [file, reason] :
       {std::pair{"million_by_million.png", "more pixels than the file can hold"},
        std::pair{"chunk_of_gigabytes.png", "the file is cut short"}}) {
    std::string said;
    try {
      read_png(corpus / file);
    } catch (const std::runtime_error& error) {
      said = error.what();
    }
    expect_mentions(said, reason);
  }
}

}  // namespace png_test
