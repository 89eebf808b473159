#include "run_directory.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "scene/step_names.h"
#include "scene/toml_reader.h"
#include "support/shell.h"
#include "text/bad_input.h"
#include "text/text.h"
#include "text/text_file.h"

namespace {

std::vector<std::string> cells_of(std::string_view line) {
  std::vector<std::string> cells(1);
  for (const char c : line)
    if (c == ',')
      cells.emplace_back();
    else
      cells.back() += c;
  return cells;
}

// Unlike a scene, the log of a run that exploded may have inf and nan.
double number_of(const std::string& cell, const std::string& at) {
  char* end = nullptr;
  const double number = std::strtod(cell.c_str(), &end);
  if (cell.empty() || *end) throw BadInput(at + "wants numbers, not \"" + one_line(cell) + "\"");
  return number;
}

RunFrame frame_of(const std::vector<std::string>& columns, std::string_view line,
                  const std::string& at) {
  const std::vector<std::string> cells = cells_of(line);
  if (cells.size() != columns.size())
    throw BadInput(at + "has " + count(long(cells.size()), "number") + ", but the header names " +
                   count(long(columns.size()), "column"));
  RunFrame frame;
  for (size_t c = 0; c < cells.size(); ++c) frame.values[columns[c]] = number_of(cells[c], at);
  const double number = frame.values["frame"];
  if (!(number >= 0 && number < 1e9)) throw BadInput(at + "has no valid number of a frame");
  frame.number = int(number);
  frame.time = frame.values["time"];
  return frame;
}

std::vector<RunFrame> read_log(const std::filesystem::path& file) {
  const std::string all = read_text(file);
  std::string_view rest = all, line;
  if (!take_line(rest, line)) throw BadInput(file.string() + ": is empty; a run writes a header");
  const std::vector<std::string> columns = cells_of(line);
  for (const char* const needed : {"frame", "time"})
    if (std::find(columns.begin(), columns.end(), needed) == columns.end())
      throw BadInput(file.string() + ":1: has no column " + needed + "; is it the log of a run?");
  std::vector<RunFrame> frames;
  for (int row = 2; take_line(rest, line); ++row) {
    const std::string at = file.string() + ":" + std::to_string(row) + ": ";
    frames.push_back(frame_of(columns, line, at));
    const double before = row == 2 ? -INFINITY : frames[frames.size() - 2].time;
    if (!(frames.back().time > before && std::isfinite(frames.back().time)))
      throw BadInput(at + "its time is not after that of the row before");
  }
  if (frames.empty()) throw BadInput(file.string() + ": has no frame");
  return frames;
}

// --newton=1 → --newton, 1; --wireframe → --wireframe, on.
void flatten_options(const toml::array& options, std::map<std::string, std::string>& flat) {
  for (const toml::node& option : options) {
    const std::string word = option.value_or(as_toml(option));
    const size_t equals = word.find('=');
    flat[word.substr(0, equals)] = equals == word.npos ? "on" : word.substr(equals + 1);
  }
}

void flatten(const std::string& prefix, const toml::table& table,
             std::map<std::string, std::string>& flat) {
  for (const auto& [key, node] : table) {
    const std::string name = prefix + std::string(key.str());
    if (name == "run.options" && node.is_array())
      flatten_options(*node.as_array(), flat);
    else if (node.is_table())
      flatten(name + ".", *node.as_table(), flat);
    else
      flat[name] = node.is_string() ? *node.value<std::string>() : as_toml(node);
  }
}

void read_inputs(const std::filesystem::path& file, RecordedRun& run) try {
  const toml::table tables = read_toml(file);
  flatten("", tables, run.inputs);
  run.program = tables["run"]["program"].value_or(std::string());
  run.h = tables["time"]["h"].value_or(0.0);
} catch (const BadInput& fault) {
  run.faults.push_back(one_line(fault.what()));
}

}  // namespace

std::optional<double> RunFrame::value(const std::string& column) const {
  const auto found = values.find(column);
  return found == values.end() ? std::nullopt : std::optional(found->second);
}

std::filesystem::path RunFrame::picture() const {
  return text("frame_%04d.png", number);
}

std::filesystem::path RunFrame::mesh() const {
  return text("frame_%04d.obj", number);
}

RecordedRun read_run(const std::filesystem::path& directory) {
  RecordedRun run;
  run.name = directory.string();
  std::error_code error;
  if (!std::filesystem::is_directory(directory, error))
    throw BadInput(run.name + ": is no directory; name the --out of a run");
  if (!exists(directory / "log.csv"))
    throw BadInput(run.name + ": has no log.csv; name the --out of a run");
  run.directory = std::filesystem::canonical(directory);
  run.frames = read_log(directory / "log.csv");
  read_inputs(directory / "run.toml", run);
  return run;
}

std::string command_that_makes(const RecordedRun& run, const std::filesystem::path& directory) {
  const Names steps = step_names();
  if (std::find(steps.begin(), steps.end(), run.program) == steps.end()) return "";
  const std::filesystem::path program =
      std::filesystem::path(PROGRAM_DIRECTORY) / run.program / run.program;
  return for_shell(program) + " " + for_shell(run.directory / "run.toml") + " --out " +
         for_shell(directory);
}
