// log.csv: a header, and a row per frame as soon as it is there.
#pragma once
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

// Written as log.csv.part, so that a log.csv is always whole, and renamed by close(). Throws
// std::runtime_error with the path and the reason where writing fails.
class Log {
 public:
  Log(const std::filesystem::path& path, const std::vector<std::string>& columns);
  ~Log();
  void row(const std::vector<double>& values);
  void close();

 private:
  void write(const std::string& line);

  std::filesystem::path path, part;
  std::FILE* file;
};
