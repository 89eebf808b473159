#include "tradeoff/record.h"

#include <algorithm>
#include <cstring>
#include <stdexcept>

#include "scene/text_file.h"

namespace tradeoff {

namespace {

// One column: its name, and the text of a score's value and back.
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
        std::snprintf(text, sizeof text, "%.9g", get(const_cast<Score&>(s)));
        return std::string(text);
      },
      [get](const std::string& text, Score& s) { get(s) = std::strtod(text.c_str(), nullptr); }};
}

template <class Get>
Column whole(const char* name, const Get& get) {
  using Whole = std::remove_reference_t<decltype(get(std::declval<Score&>()))>;
  return {name, [get](const Score& s) { return std::to_string(get(const_cast<Score&>(s))); },
          [get](const std::string& text, Score& s) {
            get(s) = Whole(std::strtol(text.c_str(), nullptr, 10));
          }};
}

template <class Get>
Column word(const char* name, const Get& get) {
  return {name,
          [get](const Score& s) {
            std::string text = get(const_cast<Score&>(s));
            std::replace(text.begin(), text.end(), ',', ';');
            return text;
          },
          [get](const std::string& text, Score& s) { get(s) = text; }};
}

const std::vector<Column>& columns() {
  static const std::vector<Column> all = {
      whole("cells", [](Score& s) -> int& { return s.cells; }),
      whole("step", [](Score& s) -> int& { return s.trial.way.step; }),
      word("solver", [](Score& s) -> std::string& { return s.trial.way.method.solver; }),
      word("preconditioner",
           [](Score& s) -> std::string& { return s.trial.way.method.preconditioner; }),
      real("tolerance", [](Score& s) -> double& { return s.trial.way.method.tolerance; }),
      {"jacobian",
       [](const Score& s) {
         return std::string(s.trial.way.method.jacobian == Jacobian::bw98 ? "bw98" : "definite");
       },
       [](const std::string& text, Score& s) {
         s.trial.way.method.jacobian = text == "bw98" ? Jacobian::bw98 : Jacobian::definite;
       }},
      whole("newton", [](Score& s) -> int& { return s.trial.way.method.newton; }),
      real("h", [](Score& s) -> double& { return s.h; }),
      whole("steps", [](Score& s) -> long& { return s.trial.steps; }),
      word("outcome", [](Score& s) -> std::string& { return s.outcome; }),
      real("error", [](Score& s) -> double& { return s.error; }),
      real("total_error", [](Score& s) -> double& { return s.total_error; }),
      real("energy_error", [](Score& s) -> double& { return s.energy_error; }),
      real("stretch_error", [](Score& s) -> double& { return s.stretch_error; }),
      real("energy", [](Score& s) -> double& { return s.energy; }),
      real("lowest", [](Score& s) -> double& { return s.lowest; }),
      real("stretch", [](Score& s) -> double& { return s.stretch; }),
      whole("forces", [](Score& s) -> long& { return s.counts.forces; }),
      whole("energies", [](Score& s) -> long& { return s.counts.energies; }),
      whole("assemblies", [](Score& s) -> long& { return s.counts.assemblies; }),
      whole("products", [](Score& s) -> long& { return s.counts.products; }),
      whole("bytes", [](Score& s) -> long& { return s.counts.bytes; }),
      whole("iterations", [](Score& s) -> long& { return s.counts.iterations; }),
      whole("indefinite", [](Score& s) -> long& { return s.counts.indefinite; }),
      whole("capped", [](Score& s) -> long& { return s.counts.capped; }),
      whole("unconverged", [](Score& s) -> long& { return s.counts.unconverged; }),
      whole("repeats", [](Score& s) -> int& { return s.repeats; }),
      real("baselines", [](Score& s) -> double& { return s.baselines; }),
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
  std::string line = study + "," + name_of(score.trial.way);
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
    bool same_columns = take_line(rest, line) && line == header();
    while (same_columns && take_line(rest, line)) {
      const std::vector<std::string> cells = split(line);
      if (cells.size() != columns().size() + 3) continue;  // broken off
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
}

const Score* Record::find(int cells, const Trial& trial) const {
  const auto found = std::find_if(all.begin(), all.end(), [&](const Score& score) {
    return score.cells == cells && score.trial.steps == trial.steps &&
           name_of(score.trial.way) == name_of(trial.way);
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
