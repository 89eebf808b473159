#include "text/names.h"

#include <algorithm>
#include <numeric>

namespace {

// How many letters must be inserted, deleted or replaced to make b of a. One row of the usual
// table: row[j] is the distance of the letters of a read so far to the first j of b.
size_t distance(std::string_view a, std::string_view b) {
  std::vector<size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), size_t(0));
  for (size_t i = 0; i < a.size(); ++i) {
    size_t diagonal = row[0];
    row[0] = i + 1;
    for (size_t j = 0; j < b.size(); ++j) {
      const size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

}  // namespace

std::string valid_names(std::string_view given, const Names& valid) {
  const auto nearest = std::min_element(valid.begin(), valid.end(), [&](auto& a, auto& b) {
    return distance(given, a) < distance(given, b);
  });
  std::string text;
  if (distance(given, *nearest) <= std::max<size_t>(1, given.size() / 3))
    text = "did you mean \"" + *nearest + "\"? ";
  text += "Valid are ";
  for (const std::string& name : valid) text += (&name == &valid[0] ? "" : ", ") + name;
  return text;
}

std::string choices(const Names& valid) {
  std::string text = valid[0];
  for (size_t i = 1; i < valid.size(); ++i)
    text += (i + 1 < valid.size() ? ", " : " or ") + valid[i];
  return text;
}
