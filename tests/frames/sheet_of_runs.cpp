#include "sheet_of_runs.h"

#include <algorithm>
#include <cmath>

#include "contact_sheet.h"
#include "picture/png.h"
#include "text/text.h"

namespace {

constexpr int most_columns = 6;

// The frame of B at the time of this frame of A; null where there is none.
const RunFrame* partner(const Comparison& comparison, const RunFrame* frame) {
  for (const FramePair& pair : comparison.frames)
    if (pair.a == frame) return pair.b;
  return nullptr;
}

std::vector<const RunFrame*> partners(const Comparison& comparison,
                                      const std::vector<const RunFrame*>& frames) {
  std::vector<const RunFrame*> found;
  for (const RunFrame* frame : frames) found.push_back(partner(comparison, frame));
  return found;
}

// The frames of A that all runs have; where they share none, all frames of A.
std::vector<const RunFrame*> shared_frames(const std::vector<Comparison>& comparisons) {
  std::vector<const RunFrame*> shared, all;
  for (const RunFrame& frame : comparisons.front().a->frames) {
    all.push_back(&frame);
    if (std::all_of(comparisons.begin(), comparisons.end(),
                    [&](const Comparison& c) { return partner(c, &frame); }))
      shared.push_back(&frame);
  }
  return shared.empty() ? all : shared;
}

// Evenly spaced, with the last one. The first is the start of all runs, and is shown only where it is alone.
std::vector<const RunFrame*> chosen(const std::vector<const RunFrame*>& frames) {
  const int last = int(frames.size()) - 1, columns = std::clamp(last, 1, most_columns);
  std::vector<const RunFrame*> few;
  for (int c = 1; c <= columns; ++c)
    few.push_back(frames[size_t(std::lround(double(c) * last / columns))]);
  return few;
}

// Absent where the picture is missing or broken, which the comparison has noted.
std::optional<Image> picture_of(const RecordedRun& run, const RunFrame* frame) {
  if (!frame || !exists(run.directory / frame->picture())) return std::nullopt;
  try {
    return read_png(run.directory / frame->picture());
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

std::vector<std::optional<Image>> pictures_of(const RecordedRun& run,
                                              const std::vector<const RunFrame*>& frames) {
  std::vector<std::optional<Image>> pictures;
  for (const RunFrame* frame : frames) pictures.push_back(picture_of(run, frame));
  return pictures;
}

constexpr size_t longest_label = 120;  // characters, about as many as a row has room for

// The run, and as many of its own inputs as have room.
std::string label_of(const Comparison& comparison) {
  std::string label = comparison.b->name + "   " + comparison.b->program;
  for (const InputDifference& input : comparison.inputs) {
    if (input.key.starts_with("run.")) continue;
    const std::string more = "   " + input.key + " = " + input.b;
    if (label.size() + more.size() > longest_label) return label + "   ...";
    label += more;
  }
  return label;
}

SheetRow difference_row(const SheetRow& a, const SheetRow& b, const std::string& label) {
  SheetRow row{label, {}};
  for (size_t c = 0; c < a.pictures.size(); ++c) {
    const std::optional<Image>&first = a.pictures[c], &second = b.pictures[c];
    const bool both =
        first && second && first->width == second->width && first->height == second->height;
    row.pictures.push_back(
        both ? std::optional(small_difference(*first, *second, int(a.pictures.size())))
             : std::nullopt);
  }
  return row;
}

}  // namespace

Image sheet_of_runs(const std::vector<Comparison>& comparisons, bool differences) {
  const RecordedRun& a = *comparisons.front().a;
  const std::vector<const RunFrame*> frames = chosen(shared_frames(comparisons));
  std::vector<std::string> headings;
  for (const RunFrame* frame : frames) headings.push_back(text("%.4g s", frame->time));

  std::vector<SheetRow> rows = {{a.name + "   " + a.program, pictures_of(a, frames)}};
  for (const Comparison& comparison : comparisons) {
    rows.push_back(
        {label_of(comparison), pictures_of(*comparison.b, partners(comparison, frames))});
    if (differences)
      rows.push_back(difference_row(
          rows.front(), rows.back(),
          comparison.b->name + "   difference to " + a.name + ": " + name_of(comparison.verdict)));
  }
  return contact_sheet(headings, rows);
}
