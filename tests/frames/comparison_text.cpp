#include "comparison_text.h"

#include "text/text.h"

namespace {

// Two lines: the names of the columns, and under those of the log the runs.
constexpr const char* header =
    "                       pixels of the cloth   largest densest   distance/mm          "
    "energy/J               lowest/m\n"
    "   time/s  verdict      that differ      of 255  window     RMS   worst  vertex  "
    "A          B           A          B\n";

std::string value(const RunFrame& frame, const char* column) {
  const std::optional<double> number = frame.value(column);
  return number ? text("%.4g", *number) : "-";
}

std::string picture_cells(const FramePair& pair) {
  if (!pair.picture) return text("  %-19s %4s %7s", "-", "-", "-");
  const PictureComparison& p = *pair.picture;
  return text("  %-19s %4d %7d", text("%ld of %ld", p.pixels, p.of).c_str(), p.difference.largest,
              p.difference.window);
}

std::string position_cells(const FramePair& pair) {
  if (!pair.position) return text(" %7s %7s %7s", "-", "-", "-");
  const PositionComparison& p = *pair.position;
  return text(" %7.3g %7.3g %7d", 1000 * p.rms, 1000 * p.worst, p.worst_vertex);
}

std::string log_cells(const FramePair& pair, const char* column) {
  return text("  %-10s %-10s", value(*pair.a, column).c_str(), value(*pair.b, column).c_str());
}

std::string row(const FramePair& pair) {
  std::string cells = text("%9.6g  %-11s", pair.a->time, name_of(pair.verdict).c_str()) +
                      picture_cells(pair) + position_cells(pair) + log_cells(pair, "total") +
                      log_cells(pair, "lowest");
  cells.erase(cells.find_last_not_of(' ') + 1);
  return cells + "\n";
}

}  // namespace

std::string comparison_text(const Comparison& comparison) {
  std::string all =
      "A: " + one_line(comparison.a->name) + "\nB: " + one_line(comparison.b->name) + "\n";
  for (const InputDifference& input : comparison.inputs)
    all += one_line(input.key + ": " + input.a + " | " + input.b) + "\n";
  for (const std::string& note : comparison.notes) all += one_line(note) + "\n";
  if (!comparison.frames.empty()) all += header;
  for (const FramePair& pair : comparison.frames) all += row(pair);
  return all + summary(comparison) + "\n";
}
