// tradeoff.csv: a row per trial, written as soon as it is there, so that an interrupted study goes on
// where it was.
#pragma once
#include <fstream>

#include "tradeoff/score.h"

namespace tradeoff {

class Record {
 public:
  // Reads what `file` already holds of this study: `study` names everything that a score depends on. Rows
  // of other studies stay where they are. Throws std::runtime_error where the file cannot be written.
  Record(const std::filesystem::path& file, const std::string& study);

  const Score* find(int cells, const Trial&) const;
  void add(const Score&,
           double seconds);  // throws std::runtime_error, naming the file, on a full disk

  const std::vector<Score>& scores() const { return all; }
  size_t found() const { return kept; }  // rows of an earlier run

 private:
  std::filesystem::path file;
  std::string study;
  std::ofstream out;
  std::vector<Score> all;
  size_t kept = 0;
};

}  // namespace tradeoff
