#include "program/log.h"

#include "text/text.h"

namespace {

std::string line_of(const LogRow& row, const auto& cell) {
  std::vector<std::string> cells;
  for (const auto& column : row) cells.push_back(cell(column));
  return joined(cells, ",") + "\n";
}

}  // namespace

Log::~Log() {
  try {
    close();
  } catch (const CannotWrite&) {
  }
}

void Log::write(const LogRow& row) {
  if (!file) {
    file.emplace(path);
    file->write(line_of(row, [](const auto& column) { return column.first; }));
  }
  file->write(line_of(row, [](const auto& column) { return text("%.12g", column.second); }));
  file->keep();
}

void Log::close() {
  if (file && file->is_open()) file->finish();
}
