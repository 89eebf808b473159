// tradeoff.csv: one row per trial. A row is written when its trial ends, so that an
// interrupted study can continue.
#pragma once
#include <fstream>

#include "tradeoff/score.h"

namespace tradeoff {

class Record {
 public:
  // Reads the rows that `file` already has of this study. `study` identifies everything that
  // a score depends on. Rows of other studies stay in the file. Throws std::runtime_error if
  // the file cannot be written.
  Record(const std::filesystem::path& file, const std::string& study);

  const Score* find(int cells, const Trial&) const;
  void add(const Score&,
           double seconds);  // on a full disk: throws std::runtime_error with the file name

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
