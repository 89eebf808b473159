// Scenes and the files beside them, for one test, in a directory of its own.
#pragma once
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "scene/scene.h"

class SceneFiles : public testing::Test {
 protected:
  SceneFiles()
      : directory(std::filesystem::path(testing::TempDir()) /
                  (testing::UnitTest::GetInstance()->current_test_info()->name() +
                   std::to_string(getpid()))) {
    std::filesystem::create_directories(directory);
  }
  ~SceneFiles() override { std::filesystem::remove_all(directory); }

  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::ofstream(directory / name, std::ios::binary) << text;
    return directory / name;
  }

  Scene read(const std::string& text, const std::string& program = "step02_damping",
             const Overrides& overrides = {}) const {
    return read_scene(write("scene.toml", text), program, overrides);
  }

  // The message that refuses the scene, without the directory in front of the file names.
  std::string refusal(const std::string& text, const std::string& program = "step02_damping",
                      const Overrides& overrides = {}) const {
    return message([&] { read(text, program, overrides); });
  }

  template <class Act>
  std::string message(const Act& act) const {
    try {
      act();
    } catch (const BadInput& bad) {
      std::string said = bad.what();
      const std::string front = directory.string() + "/";
      for (size_t at; (at = said.find(front)) != said.npos;) said.erase(at, front.size());
      return said;
    }
    return "accepted";
  }

  const std::filesystem::path directory;
};

// The message is one line and contains all parts.
inline void expect_says(const std::string& message, const std::vector<std::string>& parts) {
  EXPECT_EQ(message.find('\n'), message.npos) << message;
  for (const std::string& part : parts)
    EXPECT_NE(message.find(part), message.npos) << "\"" << part << "\" is not in\n" << message;
}

// The smallest scene: 2 × 2 cells; its tables start in lines 1 and 5.
inline const std::string cloth_and_time =
    "[cloth]\nsize = [1.0, 1.0]\ncells = [2, 2]\ndensity = 0.2\n[time]\nh = 0.001\nend = 1.0\n";

// The scene with one of its lines replaced.
inline std::string with_line(int number, const std::string& line,
                             const std::string& scene = cloth_and_time) {
  size_t begin = 0;
  for (int i = 1; i < number; ++i) begin = scene.find('\n', begin) + 1;
  return scene.substr(0, begin) + line + scene.substr(scene.find('\n', begin));
}
