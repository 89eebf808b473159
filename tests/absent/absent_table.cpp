// Prints the table of the top README: the cost of a part that a scene leaves out, and the cost of
// the part itself. Counts and bytes are those of 12 × 12 cells; the bytes of a part are those of CG
// with blocks. Times are ratios of CPU times on 32 × 32 cells, of step 2 · step 3 with
// LDLᵀ · step 5 with blocks. They are medians over rounds in which the programs take turns, so that
// a busy machine slows all of them alike.
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <stdexcept>

#include "absent/without.h"
#include "support/cpu_time.h"

namespace {

constexpr int rounds = 15;

const std::vector<Part> parts = {{"gravity", "timed/run_without_gravity"},
                                 {"stretch", "timed/run_without_stretch"},
                                 {"shear", "timed/run_without_shear"},
                                 {"membrane", "timed/run_without_sheets"},
                                 {"spring", "timed/run_without_sheets"},
                                 {"bend", "timed/run_without_bend"},
                                 {"stretch.kd", "timed/run_without_stretch_damping"},
                                 {"shear.kd", "timed/run_without_shear_damping"},
                                 {"bend.kd", "timed/run_without_bend_damping"},
                                 {"damping", "timed/run_without_damping"}};

// stretch.kd is the damping of stretch.
std::string title(const Part& part) {
  std::string name = part.name;
  if (const size_t dot = name.find('.'); dot != std::string::npos) name.replace(dot, 3, " damping");
  return name == "damping" ? "all damping" : name;
}

std::string text(const char* format, auto... values) {
  std::array<char, 128> line;
  std::snprintf(line.data(), line.size(), format, values...);
  return line.data();
}

// The largest difference between two outcomes, over several configurations.
class Difference {
 public:
  void add(const Outcome& a, const Outcome& b) {
    same = same && a.moves_like(b);
    farthest = std::max(farthest, distance(a, b));
    ++configurations;
  }
  std::string to_text() const {
    if (configurations == 0) return "–";
    return same ? "the same" : text("%.0e m", farthest);
  }

 private:
  bool same = true;
  double farthest = 0;
  int configurations = 0;
};

struct Motions {
  Difference zero_exact, zero_close, built_without;
  long more_allocations = 0, more_bytes = 0, other_counts = 0;  // than the program without the code
  long bytes = 0, blocks = 0;  // of the part itself, in CG with blocks
};

Motions compare_motions(const Part& part) {
  Motions motions;
  for (const Configuration& configuration : configurations(part)) {
    const auto on_12_cells = [](Scene scene) {
      scene["cells"] = "12";
      return scene;
    };
    const Scene scene = on_12_cells(without(part, configuration));
    const Outcome absent = run("timed/run_full", scene), cut = run(part.program, scene);
    const Outcome zero = run("timed/run_full", on_12_cells(with_zero(part, configuration)));
    (configuration.exact ? motions.zero_exact : motions.zero_close).add(absent, zero);
    motions.built_without.add(absent, cut);
    for (const auto& [name, count] : absent.counts) {
      const long more = count - cut.counts.at(name);
      if (name == "allocations")
        motions.more_allocations = std::max(motions.more_allocations, more);
      else if (name == "bytes")
        motions.more_bytes = std::max(motions.more_bytes, more);
      else if (more != 0)
        ++motions.other_counts;
    }
    if (std::string(configuration.name) != "block") continue;
    const Outcome present = run("timed/run_full", on_12_cells(with(part, configuration)));
    motions.bytes = present.counts.at("bytes") - absent.counts.at("bytes");
    motions.blocks = present.counts.at("blocks") - absent.counts.at("blocks");
  }
  return motions;
}

std::string counts_text(const Motions& m) {
  if (m.other_counts > 0) return text("%ld counts differ", m.other_counts);
  if (m.more_allocations == 0 && m.more_bytes == 0) return "the same";
  return text("%+ld allocation, %+ld bytes", m.more_allocations, m.more_bytes);
}
std::string cost_text(const Motions& m) {
  return text("%+ld bytes", m.bytes) + (m.blocks ? text(", %+ld blocks", m.blocks) : "");
}

// The times of a step, µs: without the part, in the program built without its code, with the part.
struct Times {
  std::vector<double> absent, built_without, present;
};

bool is_timed(const Configuration& configuration) {
  const std::string name = configuration.name;
  return name == "explicit" || name == "ldlt" || name == "block";
}

void add_round(const Part& part, const Configuration& configuration, Times& times) {
  const auto time = [](const std::string& program, Scene scene) {
    scene["cells"] = "32";
    scene["steps"] = scene["step"] == "2" ? "200" : "12";
    return run(program, scene).microseconds;
  };
  times.absent.push_back(time("timed/run_full", without(part, configuration)));
  times.built_without.push_back(time(part.program, without(part, configuration)));
  times.present.push_back(time("timed/run_full", with(part, configuration)));
}

struct Row {
  Part part;
  Motions motions;
  std::map<std::string, Times> times;  // by configuration
};

std::string ratios(const Row& row, std::vector<double> Times::*above,
                   std::vector<double> Times::*below) {
  std::string cells;
  for (const char* configuration : {"explicit", "ldlt", "block"}) {
    const auto found = row.times.find(configuration);
    if (!cells.empty()) cells += " · ";
    cells += found == row.times.end()
                 ? "–"
                 : text("%.2f", median_ratio(found->second.*above, found->second.*below));
  }
  return cells;
}

void print(const std::vector<Row>& rows) {
  std::printf(
      "| left out | moves as with k = 0: explicit, CG | direct, IC, multigrid | moves as built "
      "without it | "
      "allocations, bytes, blocks, iterations | time of a step | where it is there | time of a "
      "step |\n"
      "|---|---|---|---|---|---|---|---|\n");
  for (const Row& row : rows)
    std::printf("| %s | %s | %s | %s | %s | %s | %s | %s |\n", title(row.part).c_str(),
                row.motions.zero_exact.to_text().c_str(), row.motions.zero_close.to_text().c_str(),
                row.motions.built_without.to_text().c_str(), counts_text(row.motions).c_str(),
                ratios(row, &Times::absent, &Times::built_without).c_str(),
                cost_text(row.motions).c_str(),
                ratios(row, &Times::present, &Times::absent).c_str());
}

// Prints how much is done, and an estimate of the time left.
class Progress {
 public:
  explicit Progress(size_t all_) : all(all_) {}
  ~Progress() { std::fprintf(stderr, "\r%30s\r", ""); }
  void next() {
    ++done;
    const double left = since(start) * double(all - done) / double(done);
    std::fprintf(stderr, "\r%3zu %%, %.0f s left  ", 100 * done / all, left);
  }

 private:
  using Clock = std::chrono::steady_clock;
  static double since(Clock::time_point then) {
    return std::chrono::duration<double>(Clock::now() - then).count();
  }

  size_t all, done = 0;
  Clock::time_point start = Clock::now();
};

std::vector<Row> measure() {
  Progress progress(parts.size() * (rounds + 1));
  std::vector<Row> rows;
  for (const Part& part : parts) {
    rows.push_back({part, compare_motions(part), {}});
    progress.next();
  }
  for (int round = 0; round < rounds; ++round)
    for (Row& row : rows) {
      for (const Configuration& configuration : configurations(row.part))
        if (is_timed(configuration))
          add_round(row.part, configuration, row.times[configuration.name]);
      progress.next();
    }
  return rows;
}

}  // namespace

int main() try { print(measure()); } catch (const std::exception& e) {
  std::fprintf(stderr, "absent_table: %s\n", e.what());
  return 1;
}
