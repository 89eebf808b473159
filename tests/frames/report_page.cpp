#include "report_page.h"

#include <map>

#include "page.h"
#include "report_json.h"
#include "text/bad_input.h"
#include "text/text_file.h"

namespace {

// A picture that is missing or cannot be read is left out: the page shows words in its place.
void copy_picture(const std::filesystem::path& from, const std::filesystem::path& to) {
  std::string bytes;
  try {
    bytes = read_text(from);
  } catch (const BadInput&) {
    std::filesystem::remove(to);  // of an earlier report
    return;
  }
  write_text(to, bytes);
}

void copy_pictures(const RecordedRun& run, const std::filesystem::path& directory) {
  std::filesystem::create_directories(directory);
  for (const RunFrame& frame : run.frames)
    copy_picture(run.directory / frame.picture(), directory / frame.picture());
}

}  // namespace

void write_report_page(const std::filesystem::path& html,
                       const std::vector<Comparison>& comparisons) {
  const std::filesystem::path files = html.stem().string() + "_files";
  PictureAddresses addresses;
  for (const Comparison& comparison : comparisons)
    for (const RecordedRun* const run : {comparison.a, comparison.b}) {
      const std::filesystem::path directory = files / std::to_string(addresses.size());
      if (!addresses.emplace(run->directory, address_of(directory)).second) continue;
      copy_pictures(*run, html.parent_path() / directory);
    }
  write_text(html, page("report", report_json(comparisons, addresses)));
}
