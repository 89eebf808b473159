// compare_runs A B [C …]: compares runs with the first one, frame by frame.
// Exit code 0: all are equivalent; 1: one differs; 2: a run cannot be read, or bad usage.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <iostream>
#include <string>
#include <vector>

#include "comparison.h"
#include "comparison_text.h"
#include "picture/png.h"
#include "report_json.h"
#include "report_page.h"
#include "sheet_of_runs.h"
#include "text/bad_input.h"
#include "text/text.h"
#include "text/text_file.h"

namespace {

struct Arguments {
  std::vector<std::string> runs;
  std::string json, html, sheet;
  bool differences = false;
};

void write(const std::string& file, const std::string& text) {
  if (file == "-")
    std::fwrite(text.data(), 1, text.size(), stdout);
  else
    write_text(file, text);
}

int run(const Arguments& arguments) {
  std::vector<RecordedRun> runs;
  for (const std::string& directory : arguments.runs) runs.push_back(read_run(directory));
  std::vector<Comparison> comparisons;
  for (size_t i = 1; i < runs.size(); ++i) comparisons.push_back(compare_runs(runs[0], runs[i]));

  if (arguments.json != "-")
    for (const Comparison& comparison : comparisons)
      write("-", (&comparison == &comparisons[0] ? "" : "\n") + comparison_text(comparison));
  if (!arguments.sheet.empty())
    write_png(arguments.sheet, sheet_of_runs(comparisons, arguments.differences));
  if (!arguments.json.empty()) write(arguments.json, report_json(comparisons));
  if (!arguments.html.empty()) write_report_page(arguments.html, comparisons);

  for (const Comparison& comparison : comparisons)
    if (comparison.verdict == Verdict::DIFFERENT) return 1;
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  Arguments arguments;
  CLI::App app("Compares runs with the first one, frame by frame: pictures, positions and the log");
  app.set_help_flag("--help", "list the options");
  app.footer("Exit code 0: all are equivalent to A. 1: one is different. 2: a run cannot be read.");
  app.add_option("runs", arguments.runs,
                 "directories of runs (--out of a step's program); A is the reference")
      ->required()
      ->expected(2, -1)
      ->option_text("A B [C ...]");
  app.add_option("--json", arguments.json, "write everything as JSON; - for the standard output")
      ->option_text("FILE");
  app.add_option(
         "--html", arguments.html,
         "write a page for a browser, and the pictures beside it: both films in step, curves")
      ->option_text("FILE.html");
  CLI::Option* const sheet =
      app.add_option("--sheet", arguments.sheet, "draw all runs into one picture, a row per run")
          ->option_text("FILE.png");
  app.add_flag("--diff", arguments.differences, "with --sheet: also where each run differs from A")
      ->needs(sheet);
  try {
    app.parse(argc, argv);
    return run(arguments);
  } catch (const CLI::Success& page) {
    return app.exit(page);
  } catch (const CLI::ParseError& error) {
    std::cerr << "compare_runs: " << one_line(error.what()) << " (--help lists the options)\n";
  } catch (const std::exception& error) {
    std::cerr << "compare_runs: " << one_line(error.what()) << "\n";
  }
  return 2;
}
