// log.csv: a header, and a row per frame as soon as it is there.
#pragma once
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "text/whole_file.h"

using LogRow = std::vector<std::pair<std::string, double>>;  // name of the column, value

// The first row brings the header. A run that breaks off still leaves the rows that it wrote, and a
// run without a row leaves no file. Throws CannotWrite.
class Log {
 public:
  explicit Log(const std::filesystem::path& path_) : path(path_) {}
  ~Log();
  void write(const LogRow&);
  void close();

 private:
  std::filesystem::path path;
  std::optional<WholeFile> file;
};
