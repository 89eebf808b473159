// The directory that a run of a step's program has written, as far as it is there.
#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

struct RunFrame {
  int number = 0;
  double time = 0;                       // s
  std::map<std::string, double> values;  // its row of log.csv, by column

  std::optional<double> value(const std::string& column) const;
  std::filesystem::path picture() const;  // frame_0012.png, whether it is there or not
  std::filesystem::path mesh() const;     // frame_0012.obj
};

struct RecordedRun {
  std::string name;                 // the directory as it was given
  std::filesystem::path directory;  // its absolute path
  std::string program;              // step03_implicit; empty if run.toml does not say
  double h = 0;                     // s; 0 if run.toml does not say
  // run.toml, flat and sorted: time.h = 0.01; an option of the list is a key of its own: --newton = 1.
  std::map<std::string, std::string> inputs;
  std::vector<RunFrame> frames;     // at least one; times increase
  std::vector<std::string> faults;  // one line each: what is wrong with run.toml
};

// Throws BadInput where there is no run: no log.csv, one without rows, or one that cannot be understood.
RecordedRun read_run(const std::filesystem::path& directory);

// The command that makes this run, and with it the same bytes, in that directory; empty where no step made
// it.
std::string command_that_makes(const RecordedRun&, const std::filesystem::path& directory);
