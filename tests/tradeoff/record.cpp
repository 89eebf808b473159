#include "tradeoff/record.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <functional>
#include <stdexcept>

#include "text/text_file.h"

namespace tradeoff {

namespace {

// One column: its name, and how a value of a score becomes text and text a value.
struct Column {
  const char* name;
  std::function<std::string(const Score&)> write;
  std::function<void(const std::string&, Score&)> read;
};

template <class Get>
Column real(const char* name, const Get& get) {
  return {
      name,
      [get](const Score& s) {
        char text[32];
        std::snprintf(text, sizeof text, "%.9g", get(s));
        return std::string(text);
      },
      [get](const std::string& text, Score& s) { get(s) = std::strtod(text.c_str(), nullptr); }};
}

template <class Get>
Column whole(const char* name, const Get& get) {
  using Whole = std::remove_reference_t<decltype(get(std::declval<Score&>()))>;
  return {name, [get](const Score& s) { return std::to_string(get(s)); },
          [get](const std::string& text, Score& s) {
            get(s) = Whole(std::strtol(text.c_str(), nullptr, 10));
          }};
}

template <class Get>
Column word(const char* name, const Get& get) {
  return {name, [get](const Score& s) { return get(s); },
          [get](const std::string& text, Score& s) { get(s) = text; }};
}

// In the order of Scheme.
constexpr std::array<std::string_view, 3> scheme_names = {"step", "xpbd", "vbd"};

const std::vector<Column>& columns() {
  static const std::vector<Column> all = {
      whole(
          "cells", [](auto& s) -> auto& { return s.cells; }),
      whole(
          "step", [](auto& s) -> auto& { return s.trial.configuration.step; }),
      word(
          "solver", [](auto& s) -> auto& { return s.trial.configuration.method.solver; }),
      word(
          "preconditioner",
          [](auto& s) -> auto& { return s.trial.configuration.method.preconditioner; }),
      real(
          "tolerance", [](auto& s) -> auto& { return s.trial.configuration.method.tolerance; }),
      {"jacobian",
       [](const Score& s) {
         return std::string(s.trial.configuration.method.jacobian == Jacobian::bw98 ? "bw98"
                                                                                    : "definite");
       },
       [](const std::string& text, Score& s) {
         s.trial.configuration.method.jacobian =
             text == "bw98" ? Jacobian::bw98 : Jacobian::definite;
       }},
      whole(
          "newton", [](auto& s) -> auto& { return s.trial.configuration.method.newton; }),
      real(
          "h", [](auto& s) -> auto& { return s.h; }),
      {"scheme",
       [](const Score& s) {
         return std::string(scheme_names[size_t(s.trial.configuration.scheme)]);
       },
       [](const std::string& text, Score& s) {
         const auto found = std::find(scheme_names.begin(), scheme_names.end(), text);
         s.trial.configuration.scheme = Scheme(found - scheme_names.begin());
       }},
      whole(
          "sweeps", [](auto& s) -> auto& { return s.trial.configuration.sweeps; }),
      whole(
          "steps", [](auto& s) -> auto& { return s.trial.steps; }),
      word(
          "outcome", [](auto& s) -> auto& { return s.outcome; }),
      real(
          "error", [](auto& s) -> auto& { return s.error; }),
      real(
          "total_error", [](auto& s) -> auto& { return s.total_error; }),
      real(
          "energy_error", [](auto& s) -> auto& { return s.energy_error; }),
      real(
          "stretch_error", [](auto& s) -> auto& { return s.stretch_error; }),
      real(
          "energy", [](auto& s) -> auto& { return s.energy; }),
      real(
          "lowest", [](auto& s) -> auto& { return s.lowest; }),
      real(
          "stretch", [](auto& s) -> auto& { return s.stretch; }),
      whole(
          "forces", [](auto& s) -> auto& { return s.counts.forces; }),
      whole(
          "energies", [](auto& s) -> auto& { return s.counts.energies; }),
      whole(
          "assemblies", [](auto& s) -> auto& { return s.counts.assemblies; }),
      whole(
          "products", [](auto& s) -> auto& { return s.counts.products; }),
      whole(
          "bytes", [](auto& s) -> auto& { return s.counts.bytes; }),
      whole(
          "iterations", [](auto& s) -> auto& { return s.counts.iterations; }),
      whole(
          "indefinite", [](auto& s) -> auto& { return s.counts.indefinite; }),
      whole(
          "capped", [](auto& s) -> auto& { return s.counts.capped; }),
      whole(
          "unconverged", [](auto& s) -> auto& { return s.counts.unconverged; }),
      whole(
          "repeats", [](auto& s) -> auto& { return s.repeats; }),
      real(
          "baselines", [](auto& s) -> auto& { return s.baselines; }),
  };
  return all;
}

std::string header() {
  std::string line = "study,way";
  for (const Column& column : columns()) line += std::string(",") + column.name;
  return line + ",seconds";
}

std::vector<std::string> split(std::string_view line) {
  std::vector<std::string> cells;
  for (size_t at = 0, end; at <= line.size(); at = end + 1) {
    end = std::min(line.find(',', at), line.size());
    cells.emplace_back(line.substr(at, end - at));
  }
  return cells;
}

std::string row(const std::string& study, const Score& score, double seconds) {
  std::string line = study + "," + name_of(score.trial.configuration);
  for (const Column& column : columns()) line += "," + column.write(score);
  char text[32];
  std::snprintf(text, sizeof text, ",%.6g", seconds);
  return line + text;
}

}  // namespace

Record::Record(const std::filesystem::path& file_, const std::string& study_)
    : file(file_), study(study_) {
  std::string kept_rows;
  if (no_file(file).empty()) {
    const std::string text = read_text(file);
    std::string_view rest = text, line;
    if (!take_line(rest, line) || line != header()) {
      const std::filesystem::path old = file.string() + ".old";
      std::filesystem::rename(file, old);
      std::printf("  %s has other columns; it is now %s\n", file.c_str(), old.c_str());
      rest = {};
    }
    while (take_line(rest, line)) {
      const std::vector<std::string> cells = split(line);
      if (cells.size() != columns().size() + 3) continue;  // an incomplete row
      kept_rows += std::string(line) + "\n";
      if (cells[0] != study) continue;
      Score score;
      for (size_t c = 0; c < columns().size(); ++c) columns()[c].read(cells[c + 2], score);
      all.push_back(score);
    }
  }
  kept = all.size();
  write_text(file, header() + "\n" + kept_rows);
  out.open(file, std::ios::app);
  if (!out) throw std::runtime_error(file.string() + ": " + std::strerror(errno));
}

const Score* Record::find(int cells, const Trial& trial) const {
  const auto found = std::find_if(all.begin(), all.end(), [&](const Score& score) {
    return score.cells == cells && score.trial.steps == trial.steps &&
           name_of(score.trial.configuration) == name_of(trial.configuration);
  });
  return found == all.end() ? nullptr : &*found;
}

void Record::add(const Score& score, double seconds) {
  all.push_back(score);
  if (!(out << row(study, score, seconds) << std::endl))
    throw std::runtime_error(file.string() + ": " + std::strerror(errno) +
                             "; what was measured before is kept");
}

}  // namespace tradeoff
