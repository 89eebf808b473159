// Runs the programs as a user does: with arguments, in a directory, until they end.
#pragma once
#include <gtest/gtest.h>
#include <sys/types.h>

#include <filesystem>
#include <map>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

// One of the five programs.
struct StepProgram {
  std::string name;  // step01_explicit
  std::filesystem::path path;

  int number() const { return name[5] - '0'; }
  bool is_explicit() const { return number() <= 2; }
  bool is_iterative() const { return number() >= 4; }
  std::filesystem::path scene() const;  // its own scene.toml

  // A square metre of 40 × 40 cells that falls, hung by two corners: the program's own scene, or,
  // if that is another scene, tests/steps/squares/…/scene.toml.
  std::filesystem::path square() const;
};
inline void PrintTo(const StepProgram& program, std::ostream* out) {
  *out << program.name;
}

std::vector<StepProgram> programs();
std::vector<StepProgram> explicit_programs();
std::vector<StepProgram> iterative_programs();
StepProgram program_called(const std::string& name);
std::string name_of(const testing::TestParamInfo<StepProgram>& info);

struct Outcome {
  int code = -1;  // −1: killed by a signal, or by the test after too long a time
  std::string out, err;
};

using Arguments = std::vector<std::string>;

// A running program; it is killed if the test ends before it.
class Running {
 public:
  // No file may grow beyond `largest_file` bytes: this imitates a full disk without being root.
  Running(const std::filesystem::path& program, const Arguments& arguments,
          const std::filesystem::path& directory, std::optional<long> largest_file = {});
  ~Running();
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;

  bool wait_for_output(const std::string& text, double seconds);
  void send(int signal) const;
  Outcome wait(double seconds);

 private:
  bool read_for(double seconds);  // false once both ends are closed

  pid_t child = 0;
  int out = -1, err = -1;
  Outcome outcome;
};

using Table = std::map<std::string, std::vector<double>>;  // column by name

// A test in a fresh directory, which is removed after it.
class ProgramDirectory : public testing::Test {
 protected:
  ProgramDirectory();
  ~ProgramDirectory() override;

  Outcome run(const StepProgram&, const Arguments&, std::optional<long> largest_file = {}) const;
  std::filesystem::path write(const std::string& name, const std::string& text) const;

  const std::filesystem::path directory;
};

// The same test for every program of the list.
class ProgramTest : public ProgramDirectory, public testing::WithParamInterface<StepProgram> {
 protected:
  Outcome run(const Arguments& arguments, std::optional<long> largest_file = {}) const {
    return ProgramDirectory::run(GetParam(), arguments, largest_file);
  }
  void expect_done(const Arguments&) const;  // exit code 0, and nothing on the standard error

  // The program's square metre with so few cells that many runs are quick.
  Arguments small_square(int cells, const Arguments& more) const;
};

std::string read_all(const std::filesystem::path&);
std::vector<std::string> lines_of(const std::string& text);
std::vector<std::string> columns_of(const std::string& csv);
Table read_table(const std::filesystem::path& csv);  // fails the test if a row is incomplete

// The names of the files in a directory, sorted; none if it does not exist.
std::vector<std::string> files_in(const std::filesystem::path& directory);
int count_starting(const std::vector<std::string>& names, const std::string& start,
                   const std::string& end);
