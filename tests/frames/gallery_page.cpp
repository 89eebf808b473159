// gallery_page GALLERY OPTIONS STEP…: makes the page GALLERY/index.html of runs that lie there, one
// directory for each step: their films, and each step compared with the step before it. Where the
// step before ran its own, another scene, it has run the scene of the step as well, into
// GALLERY/before/STEP. OPTIONS are those of the runs, for the commands on the page.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "comparison.h"
#include "page.h"
#include "report_page.h"
#include "support/shell.h"
#include "text/text_file.h"

namespace {

using Json = nlohmann::ordered_json;
using std::filesystem::path;

const path source = SOURCE_DIRECTORY, build = BUILD_DIRECTORY;

std::string without_comments(std::string markdown) {
  for (size_t at; (at = markdown.find("<!--")) != markdown.npos;)
    markdown.erase(at, std::min(markdown.find("-->", at), markdown.size() - 3) + 3 - at);
  return markdown;
}

// Without the signs for emphasis and code.
std::string plain(std::string markdown) {
  std::erase_if(markdown, [](char c) { return c == '*' || c == '`'; });
  return markdown;
}

// The title and the first paragraph of a lesson, as plain text.
struct Beginning {
  std::string title, text;
};

Beginning beginning_of(const path& lesson) {
  const std::string all = without_comments(read_text(lesson));
  std::string_view rest = all, line;
  Beginning beginning;
  while (take_line(rest, line)) {
    if (line.starts_with("# "))
      beginning.title = plain(std::string(line.substr(2)));
    else if (!line.empty())
      beginning.text += plain(std::string(line)) + " ";
    else if (!beginning.text.empty())
      break;
  }
  return beginning;
}

// The best picture of a run's motion that is there.
std::string film_of(const path& run) {
  for (const char* const name : {"motion.png", "film.png"})
    if (exists(run / name)) return name;
  return "still.png";
}

RecordedRun run_in(const path& directory) {
  RecordedRun run = read_run(directory);
  run.name = run.program;
  return run;
}

Json compared(const path& gallery, const std::string& step_before, const std::string& step) {
  const path same_scene = gallery / "before" / step;
  const RecordedRun before = run_in(exists(same_scene) ? same_scene : gallery / step_before),
                    run = run_in(gallery / step);
  const std::vector<Comparison> comparisons = {compare_runs(before, run)};
  const path report = path("compared") / (step + ".html");
  create_directories(gallery / "compared");
  write_report_page(gallery / report, comparisons);
  return {{"name", before.name},
          {"verdict", name_of(comparisons[0].verdict)},
          {"summary", summary(comparisons[0])},
          {"report", address_of(report)}};
}

Json step_of(const path& gallery, const std::string& step, const std::string& options) {
  const path lesson = source / step / "README.md";
  const Beginning beginning = beginning_of(lesson);
  return {{"name", step},
          {"title", beginning.title},
          {"text", beginning.text},
          {"lesson", address_of(std::filesystem::proximate(lesson, gallery))},
          {"film", address_of(path(step) / film_of(gallery / step))},
          {"command",
           for_shell(build / step / step) + " --out " + for_shell(gallery / step) + " " + options}};
}

void copy_measured_pictures(const path& gallery) {
  create_directories(gallery / "pictures");
  for (const path& picture :
       {source / "tests/tradeoff/work_precision.png", source / "tests/extremes/stability_map.png"})
    write_text(gallery / "pictures" / picture.filename(), read_text(picture));
}

void make_gallery(const path& gallery, const std::string& options,
                  const std::vector<std::string>& steps) {
  Json entries = Json::array();
  for (size_t i = 0; i < steps.size(); ++i) {
    entries.push_back(step_of(gallery, steps[i], options));
    if (i > 0) entries.back()["before"] = compared(gallery, steps[i - 1], steps[i]);
  }
  copy_measured_pictures(gallery);
  write_text(gallery / "index.html", page("gallery", Json{{"steps", entries}}.dump()));
  std::printf("see %s\n", for_shell(gallery / "index.html").c_str());
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc < 4) {
    std::fprintf(stderr, "usage: gallery_page GALLERY OPTIONS STEP...\n");
    return 2;
  }
  make_gallery(argv[1], argv[2], {argv + 3, argv + argc});
} catch (const std::exception& error) {
  std::fprintf(stderr, "gallery_page: %s\n", error.what());
  return 2;
}
