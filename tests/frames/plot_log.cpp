// plot_log RUN …: draws the curves of log.csv over time, of one or more runs: energy, largest stretch, lowest
// point and iterations per step. Exit code 2: a run cannot be read, or bad usage.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <iostream>

#include "run_directory.h"
#include "support/gnuplot.h"
#include "text/bad_input.h"
#include "text/text.h"

namespace {

// A panel of the picture, a column of log.csv.
struct Panel {
  const char *column, *axis;
};
constexpr Panel panels[] = {{"total", "total energy, J"},
                            {"elastic", "elastic energy, J"},
                            {"max_stretch", "largest stretch"},
                            {"lowest", "lowest point, m"},
                            {"iterations", "iterations so far"}};

// A column that stays the same says nothing; an explicit step has no iterations. The energy is always shown.
bool is_shown(const Panel& panel, const std::vector<RecordedRun>& runs) {
  const std::string column = panel.column;
  if (column == "total") return true;
  for (const RecordedRun& run : runs)
    for (const RunFrame& frame : run.frames)
      if (frame.value(column) && frame.value(column) != run.frames[0].value(column)) return true;
  return false;
}

std::string data_block(const RecordedRun& run, size_t number) {
  std::string block = text("$run%zu << EOD\n", number);
  for (const RunFrame& frame : run.frames) {
    block += shortest(frame.time);
    for (const Panel& panel : panels)
      block += text(",%.9g", frame.value(panel.column).value_or(std::nan("")));
    block += "\n";
  }
  return block + "EOD\n";
}

// In gnuplot's double quotes a backslash and a quote need a backslash, and "_" would lower the next letter.
std::string quoted(const std::string& words) {
  std::string quoted = "\"";
  for (const char c : words) quoted += (c == '"' || c == '\\' ? "\\" : "") + std::string(1, c);
  return quoted + "\" noenhanced";
}

// Panels of the same size, one below the other. The names of the runs stand above the first one.
std::string layout(size_t runs, size_t rows) {
  const double names = 20.0 * double(runs) + 20,
               height = 240.0 * double(rows) + names;  // in pixels
  std::string layout = text("set terminal pngcairo size 900,%g font \"sans,12\"\n", height);
  layout += text("set key at screen .53,%g center top\n", 1 - 5 / height);
  return layout + text("set multiplot layout %zu,1 margins .11,.97,%g,%g spacing %g\n", rows,
                       60 / height, 1 - names / height, 70 / height);
}

std::string script(const std::vector<RecordedRun>& runs, const std::string& picture) {
  std::string script = gnuplot_style;
  script += "unset format\nset output \"" + picture + "\"\n";
  for (size_t i = 0; i < runs.size(); ++i) script += data_block(runs[i], i);
  size_t rows = 0;
  for (const Panel& panel : panels) rows += is_shown(panel, runs);
  script += layout(runs.size(), rows);
  for (size_t p = 0; p < std::size(panels); ++p) {
    if (!is_shown(panels[p], runs)) continue;
    script += text("set ylabel \"%s\"\nset xlabel \"time, s\"\nplot ", panels[p].axis);
    for (size_t i = 0; i < runs.size(); ++i)
      script += text("%s$run%zu using 1:%zu with linespoints lt %zu title ", i ? ", " : "", i,
                     p + 2, i % 7 + 1) +
                quoted(runs[i].name);
    script += "\nset nokey\n";
  }
  return script + "unset multiplot\n";
}

void plot(const std::vector<std::string>& directories, const std::filesystem::path& out) {
  std::vector<RecordedRun> runs;
  for (const std::string& directory : directories) runs.push_back(read_run(directory));
  const std::filesystem::path parent = out.has_parent_path() ? out.parent_path() : ".";
  std::filesystem::create_directories(parent);
  draw(parent, out.stem().string(), script(runs, out.filename().string()));
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::string> directories;
  std::string out = "log.png";
  CLI::App app("Draws the curves of log.csv, of one or more runs");
  app.set_help_flag("--help", "list the options");
  app.add_option("runs", directories, "directories of runs (--out of a step's program)")
      ->required()
      ->option_text("RUN ...");
  app.add_option("--out", out, "the picture; log.png if absent. FILE.gp beside it draws it again")
      ->option_text("FILE.png");
  try {
    app.parse(argc, argv);
    plot(directories, out);
    return 0;
  } catch (const CLI::Success& page) {
    return app.exit(page);
  } catch (const CLI::ParseError& error) {
    std::cerr << "plot_log: " << one_line(error.what()) << " (--help lists the options)\n";
  } catch (const std::exception& error) {
    std::cerr << "plot_log: " << one_line(error.what()) << "\n";
  }
  return 2;
}
