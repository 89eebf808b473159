// stability_map [--quick] [--threads N] [--out DIRECTORY]: the verdict on a cloth at every time
// step h and every stiffness k, for every step of the lesson. Prints one map per configuration, one
// letter per cell, and writes stability_map.csv, .gp and, if gnuplot is installed, .png. An
// interrupted study continues: cells that are in the CSV file are not computed again.
#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <map>
#include <mutex>
#include <sstream>
#include <stdexcept>
#include <thread>

#include "extremes/stability.h"
#include "program/option_checks.h"
#include "program/progress.h"
#include "support/gnuplot.h"
#include "text/bad_input.h"

namespace {

using namespace extremes;

constexpr double k_strip = 1e4;  // N/m

struct Study {
  bool quick = false;
  unsigned threads = 2;
  std::filesystem::path out = "out/stability_map";

  Watch watch() const { return quick ? Watch{.most = 300} : Watch{}; }
  double decades_h() const { return quick ? 0.5 : 0.25; }  // between neighbouring cells
  double decades_k() const { return quick ? 2 : 0.5; }
  std::string file() const { return quick ? "stability_map_quick" : "stability_map"; }
  std::string settings() const {
    const Watch w = watch();
    std::ostringstream text;
    text << "# " << w.cells << " x " << w.cells << " cells, " << w.seconds << " s, " << w.fewest
         << " to " << w.most << " steps";
    return text.str();
  }
};

// From 10^low to 10^high.
std::vector<double> powers(double low, double high, double step) {
  std::vector<double> all;
  for (int i = 0; low + i * step < high + 0.5 * step; ++i)
    all.push_back(std::pow(10, low + i * step));
  return all;
}
std::vector<double> all_h(const Study& study) {
  return powers(-5, 0, study.decades_h());
}
std::vector<double> all_k(const Study& study) {
  return powers(0, 8, study.decades_k());
}

// One cell to compute, and its row in the CSV file. The row starts with `key`.
struct Job {
  const MapWay* map;
  MapScene scene;
  double h, k;

  std::string key() const {
    char text[100];
    std::snprintf(text, sizeof text, "%s,%s,%.5g,%.5g,", map->name, name(scene), h, k);
    return text;
  }
  std::string row(const Cell& c) const {
    char text[200];
    std::snprintf(text, sizeof text, "%s,%.4g,%.5g,%.5g,%.4g,%d,%.4g,%ld,%ld,%ld", name(c.verdict),
                  c.gain, c.stretch, c.last, c.height, c.steps, c.steps * h, c.indefinite, c.capped,
                  c.redone);
    return key() + text;
  }
};
const char* const columns =
    "map,scene,h,k,verdict,gain,stretch,last,height,steps,watched,indefinite,capped,redone";

std::vector<Job> all_jobs(const Study& study) {
  std::vector<Job> jobs;
  for (const MapWay& map : map_ways()) {
    for (const double k : all_k(study))
      for (const double h : all_h(study)) jobs.push_back({&map, MapScene::drop, h, k});
    for (const double h : all_h(study)) jobs.push_back({&map, MapScene::strip, h, k_strip});
  }
  return jobs;
}

// The rows by their keys.
using Rows = std::map<std::string, std::string>;

std::string key_of(const std::string& row) {
  size_t end = 0;
  for (int i = 0; i < 4 && end != std::string::npos; ++i) end = row.find(',', end) + 1;
  return row.substr(0, end);
}
std::string verdict_of(const std::string& row) {
  const size_t begin = key_of(row).size();
  return row.substr(begin, row.find(',', begin) - begin);
}

// The rows of an earlier run of the same study. An incomplete last line does not count.
Rows read_rows(const Study& study) {
  Rows rows;
  std::ifstream file(study.out / (study.file() + ".csv"));
  std::string line;
  if (!std::getline(file, line) || line != study.settings()) return rows;
  const auto commas = [](const std::string& s) { return std::count(s.begin(), s.end(), ','); };
  while (std::getline(file, line) && !file.eof())
    if (line != columns && commas(line) == commas(columns)) rows[key_of(line)] = line;
  return rows;
}

void write_rows(const Study& study, const std::vector<Job>& jobs, const Rows& rows) {
  std::ofstream file(study.out / (study.file() + ".csv"));
  file << study.settings() << '\n' << columns << '\n';
  for (const Job& job : jobs)
    if (const auto found = rows.find(job.key()); found != rows.end()) file << found->second << '\n';
  if (!file.flush())
    throw std::runtime_error((study.out / (study.file() + ".csv")).string() +
                             ": cannot be written");
}

// Computes all missing cells in several threads. A cell does not depend on its thread.
void compute(const Study& study, const std::vector<Job>& jobs, Rows& rows) {
  std::vector<const Job*> open;
  for (const Job& job : jobs)
    if (!rows.contains(job.key())) open.push_back(&job);
  if (open.size() < jobs.size())
    std::printf("%zu of %zu cells are known from %s\n", jobs.size() - open.size(), jobs.size(),
                (study.out / (study.file() + ".csv")).c_str());
  std::ofstream file(study.out / (study.file() + ".csv"), std::ios::app);
  std::atomic<size_t> next = 0;
  std::mutex mutex;
  Progress progress(long(open.size()));
  const auto work = [&] {
    for (size_t i = next++; i < open.size(); i = next++) {
      const Job& job = *open[i];
      const std::string row = job.row(watch_cell(*job.map, job.scene, job.h, job.k, study.watch()));
      const std::lock_guard lock(mutex);
      rows[job.key()] = row;
      file << row << std::endl;
      progress.show(long(i));
    }
  };
  std::vector<std::thread> threads;
  for (unsigned i = 1; i < study.threads; ++i) threads.emplace_back(work);
  work();
  for (std::thread& thread : threads) thread.join();
  progress.end();
}

// The text map -----------------------------------------------------------------------------------

char letter_of(const std::string& row) {
  for (const Verdict verdict : all_verdicts)
    if (verdict_of(row) == name(verdict)) return letter(verdict);
  return '?';
}

void print_map(const Study& study, const MapWay& map, const Rows& rows) {
  std::printf("\n%s\n", map.name);
  const auto line = [&](const char* label, MapScene scene, double k) {
    std::printf("%s ", label);
    for (const double h : all_h(study))
      std::printf("%c", letter_of(rows.at(Job{&map, scene, h, k}.key())));
    std::printf("\n");
  };
  const std::vector<double> k = all_k(study);
  for (auto it = k.rbegin(); it != k.rend(); ++it) {
    char label[20];
    std::snprintf(label, sizeof label, "%8.1e", *it);
    line(label, MapScene::drop, *it);
  }
  line("   strip", MapScene::strip, k_strip);
}

void print_maps(const Study& study, const Rows& rows) {
  std::printf(
      "\nh from 1e-5 s (left) to 1 s, k in N/m.  . stable  + gains energy  X exploded  "
      "C solver capped  F frozen\n");
  for (const MapWay& map : map_ways()) print_map(study, map, rows);
}

// The picture ------------------------------------------------------------------------------------

void write_limits(const Study& study) {
  std::ofstream file(study.out / (study.file() + "_limit.csv"));
  file << "map,k,h\n";
  for (const MapWay& map : map_ways())
    for (const double k : powers(0, 8, 0.5))
      file << map.name << ',' << k << ',' << explicit_limit(map, k, study.watch()) << '\n';
}

// The commands for one map, in its row and column of the picture, which has three of each.
std::string panel(const Study& study, const MapWay& map, int row, int column) {
  const double left = 0.062 + 0.318 * column, top = 0.945 - 0.325 * row;
  std::ostringstream gp;
  gp << "\nset lmargin at screen " << left << "\nset rmargin at screen " << left + 0.290
     << "\nset tmargin at screen " << top << "\nset bmargin at screen " << top - 0.232
     << "\nset title \"{/:Bold " << map.title << "}\\n"
     << map.finding << "\"\nset xlabel \"" << (row == 2 ? "time step h" : "")
     << "\" offset 0,0.3\nset ylabel \"" << (column == 0 ? "stiffness k, N/m" : "")
     << "\" offset 1.5,1.2\n"
     << (column == 0 ? "@labels_k\n" : "@labels_none\n");
  const std::string cells = "\"" + study.file() + ".csv\" using (is(\"" + map.name + "\", ",
                    line = "\"" + study.file() + "_limit.csv\" using (stringcolumn(1) eq \"" +
                           map.name + "\" ? log10($3) : 1/0):(log10($2)) with lines lt 1 ";
  gp << "plot " << cells
     << "\"drop\", log10($3))):(log10($4)):(dx):(dy):(colour(5)) with boxxyerror lc rgb variable, "
        "\\\n"
     << "  " << cells
     << "\"strip\", log10($3))):(-1.4):(dx):(0.4):(colour(5)) with boxxyerror lc rgb variable, \\\n"
     << "  " << line << "lw 7 lc rgb \"#ffffff\", \\\n  " << line << "lw 3.5 lc rgb \"#000000\"\n";
  return gp.str();
}

// The legend, at the top right.
std::string legend(const Study& study) {
  struct Entry {
    const char *colour, *text;
  };
  const std::array entries = {Entry{"#009E73", "stable: gains no energy"},
                              Entry{"#F0E442", "gains energy, but holds together"},
                              Entry{"#D55E00", "exploded"},
                              Entry{"#56B4E9", "solver gave up after 1000 iterations"},
                              Entry{"#0072B2", "frozen: the strip does not buckle"}};
  std::ostringstream gp;
  gp << R"(
unset title
unset xlabel
unset ylabel
unset tics
unset border
set lmargin at screen 0.690
set rmargin at screen 0.998
set tmargin at screen 0.985
set bmargin at screen 0.700
set xrange [0:1]
set yrange [0:1]
set label 10 "Which step survives which cloth?" at 0.02,0.94 font "sans:Bold,12"
)";
  for (size_t i = 0; i < entries.size(); ++i) {
    const double y = 0.81 - 0.105 * double(i);
    gp << "set object " << i + 1 << " rectangle from 0.02," << y - 0.036 << " to 0.08," << y + 0.036
       << " fc rgb \"" << entries[i].colour << "\" fs solid noborder\nset label " << i + 1 << " \""
       << entries[i].text << "\" at 0.11," << y << "\n";
  }
  gp << R"(set arrow 1 from 0.02,0.285 to 0.08,0.285 nohead lw 4 lc rgb "#000000"
set label 11 "h_{crit}, the longest explicit step" at 0.11,0.285
set label 12 "A square metre of cloth, )"
     << study.watch().cells << " × " << study.watch().cells
     << R"( cells, falls," at 0.02,0.175 tc rgb "#555555"
set label 13 "held by two corners. Below each map:" at 0.02,0.105 tc rgb "#555555"
set label 14 "a strip pressed to 70 %, which must buckle." at 0.02,0.035 tc rgb "#555555"
plot 2
)";
  return gp.str();
}

std::string script(const Study& study) {
  std::ostringstream gp;
  gp << gnuplot_style << "\nset terminal pngcairo size 1020,1002 font \"sans,9.6\" background rgb "
     << "\"white\"\nset output \"" << study.file() << ".png\"\n"
     << "dx = " << 0.46 * study.decades_h() << "\ndy = " << 0.46 * study.decades_k() << R"(
is(map, scene, x) = stringcolumn(1) eq map && stringcolumn(2) eq scene ? x : 1/0
of(v) = v eq "stable" ? 0x009E73 : v eq "gains" ? 0xF0E442 : v eq "exploded" ? 0xD55E00 : \
        v eq "capped" ? 0x56B4E9 : v eq "frozen" ? 0x0072B2 : 0x000000
colour(column) = of(stringcolumn(column))
labels_k = 'set ytics ("strip" -1.4, "1" 0, "10^2" 2, "10^4" 4, "10^6" 6, "10^8" 8) scale 0 nomirror'
labels_none = 'set ytics ("" 0) scale 0'
set style fill solid noborder
unset grid
unset key
unset border
set xrange [-5.2:0.2]
set yrange [-1.9:8.4]
set xtics ("10 µs" -5, "0.1 ms" -4, "1 ms" -3, "10 ms" -2, "0.1 s" -1, "1 s" 0) scale 0 nomirror offset 0,0.4
set title offset 0,-0.6
set multiplot
)";
  int place = 0;
  for (const MapWay& map : map_ways()) {
    if (!map.drawn) continue;
    gp << panel(study, map, place / 3, place % 3);
    if (++place == 2) ++place;  // the legend stands there
  }
  gp << legend(study) << "unset multiplot\n";
  return gp.str();
}

// Options ----------------------------------------------------------------------------------------

void run(const Study& study) {
  const std::vector<Job> jobs = all_jobs(study);
  Rows rows = read_rows(study);
  write_rows(study, jobs, rows);
  compute(study, jobs, rows);
  write_rows(study, jobs, rows);
  print_maps(study, rows);
  write_limits(study);
  std::printf("\nfor reading: %s\n", (study.out / (study.file() + ".csv")).c_str());
  draw(study.out, study.file(), script(study));
}

}  // namespace

int main(int argc, char** argv) {
  Study study;
  CLI::App app("What becomes of a cloth at every time step and every stiffness, in every step");
  app.set_help_flag("--help", "list the options");
  app.add_flag("--quick", study.quick, "fewer cells, half a minute");
  app.add_option("--threads", study.threads, "2 if absent")
      ->check(positive_integer)
      ->option_text("N");
  app.add_option("--out", study.out, "where map and picture go; out/stability_map if absent")
      ->option_text("DIR");
  try {
    app.parse(argc, argv);
    std::error_code error;
    std::filesystem::create_directories(study.out, error);
    if (error) throw BadInput("--out " + study.out.string() + ": " + error.message());
    run(study);
    return 0;
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    std::fprintf(stderr, "stability_map: %s (--help lists the options)\n",
                 one_line(error.what()).c_str());
    return 2;
  } catch (const BadInput& error) {
    std::fprintf(stderr, "stability_map: %s\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "stability_map: %s\n", error.what());
    return 1;
  }
}
