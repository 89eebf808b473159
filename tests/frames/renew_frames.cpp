// renew_frames SHEET.png RUNS SOURCES step01_explicit …
// The golden picture of a step, SOURCES/step/frame.png, becomes that of its run, RUNS/step/still.png, where
// the two are different or say different things about themselves. A picture that is equivalent stays, so that
// another machine renews nothing. SHEET.png shows all before and after. The target update_frames makes the
// runs.
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include "contact_sheet.h"
#include "picture/compare.h"
#include "picture/png.h"

namespace {

struct Golden {
  std::string step;
  std::filesystem::path before_file, after_file;
  std::optional<Image> before;  // absent for a new step
  Image after;

  Golden(const std::string& name, const std::filesystem::path& runs,
         const std::filesystem::path& sources)
      : step(name), before_file(sources / name / "frame.png"),
        after_file(runs / name / "still.png"), after(read_png(after_file)) {
    if (exists(before_file)) before = read_png(before_file);
  }

  bool has_one_size() const {
    return before && before->width == after.width && before->height == after.height;
  }
  bool is_to_be_renewed() const {
    return !has_one_size() || verdict(compare(*before, after)) == Verdict::DIFFERENT ||
           read_png_text(before_file) != read_png_text(after_file);
  }
};

SheetRow row(const std::string& label, const std::vector<Golden>& all, const auto& picture) {
  SheetRow row{label, {}};
  for (const Golden& golden : all) row.pictures.push_back(picture(golden));
  return row;
}

void write_sheet(const std::filesystem::path& file, const std::vector<Golden>& all) {
  using Picture = std::optional<Image>;
  std::vector<std::string> steps;
  for (const Golden& golden : all) steps.push_back(golden.step);
  const auto difference = [&](const Golden& g) {
    return g.has_one_size() ? Picture(small_difference(*g.before, g.after, int(all.size())))
                            : std::nullopt;
  };
  write_png(file, contact_sheet(steps, {row("before", all, [](auto& g) { return g.before; }),
                                        row("after", all, [](auto& g) { return Picture(g.after); }),
                                        row("difference", all, difference)}));
}

void renew(const Golden& golden) {
  const std::string numbers = golden.has_one_size()
                                  ? describe(compare(*golden.before, golden.after))
                                  : std::string("no picture of this size before");
  const bool renewed = golden.is_to_be_renewed();
  if (renewed) write_png(golden.before_file, golden.after, read_png_text(golden.after_file));
  std::printf("%s: %s: %s\n", golden.step.c_str(), renewed ? "renewed" : "kept", numbers.c_str());
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc < 5) {
    std::fprintf(stderr, "usage: renew_frames SHEET.png RUNS SOURCES STEP ...\n");
    return 2;
  }
  std::vector<Golden> all;
  for (int i = 4; i < argc; ++i) all.emplace_back(argv[i], argv[2], argv[3]);
  write_sheet(argv[1], all);
  for (const Golden& golden : all) renew(golden);
  std::printf("before and after: %s\n", argv[1]);
} catch (const std::exception& error) {
  std::fprintf(stderr, "renew_frames: %s\n", error.what());
  return 1;
}
