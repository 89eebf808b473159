// Compares all ways to resist a change of shape within the plane, for the lesson of step 1:
//
//   models.png     the same cloth, dropped, with each of them
//   pull.png       the force against the stretch
//   rotation.png   the energy of a cloth that is only turned
//
// and two tables on the standard output. The first has the errors where the answer is known. The second has the
// longest stable explicit step, the linear systems that Newton's method solves in a step, and cloths that start
// squeezed, with a vertex pushed through its neighbours, or tangled.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <iostream>

#include "physics/sheet_modes.h"
#include "physics/sheet_statics.h"
#include "picture/film.h"
#include "picture/overlay.h"
#include "picture/png.h"
#include "picture/renderer.h"
#include "program/diagnostics.h"
#include "support/extreme_scenes.h"
#include "support/gnuplot.h"
#include "text/text.h"
#include "ways/simulator.h"

namespace {

namespace fs = std::filesystem;

constexpr double E = 1000, nu = 0.3;  // N/m, 1

std::vector<Sheet> ways() {
  std::vector<Sheet> sheets = {membrane_sheet("threads", moduli_of(E, nu))};
  sheets.push_back(spring_sheet("springs", E, moduli_of(E, nu).mu));
  for (const std::string& name : membrane_names())
    sheets.push_back(membrane_sheet(name, moduli_of(E, name == "arap" ? 0 : nu)));
  return sheets;
}

// Near rest: how far each is from its exact answer -------------------------------------------------

double strip_error(const Sheet& sheet) {
  using namespace sheet_statics;
  const double exact = exact_elongation(sheet);
  const TestScene strip = vertical_strip(sheet, L / 16, {1, 16});
  return elongation(strip, Rows::level, 1 + exact) / exact - 1;
}

// 1e5 N/m is so stiff that the laws of all models agree.
double catenary_error(const Sheet& sheet, double stiffness) {
  const sheet_statics::Catenary exact(0.8, stiffness);
  return sheet_statics::hang(sheet, exact, 32).sag / exact.sag() - 1;
}

// Of the lowest frequency of a strip of 16 rows whose one end is held.
double frequency_error(const Sheet& sheet) {
  using namespace sheet_modes;
  const double exact = std::sqrt(sheet.tangent(1, 1) / density) * pi / (2 * L);
  return frequencies(stretched_strip(sheet, 16, 1), 16, 2)[0] / exact - 1;
}

std::string error_text(double error) {
  return std::abs(error) < 1e-12 ? "exact" : text("%.1e", error);
}

void print_errors() {
  std::printf(
      "| model, ν = 0 | strip that hangs, E = 10 N/m | sag between two ends, E = 10⁵ N/m | lowest "
      "frequency |\n|---|---|---|---|\n");
  const auto at = [](double stiffness) {
    std::vector<Sheet> sheets = {membrane_sheet("threads", moduli_of(stiffness, 0)),
                                 spring_sheet("springs", stiffness, 0)};
    for (Sheet& sheet : membrane_sheets(stiffness, 0)) sheets.push_back(std::move(sheet));
    return sheets;
  };
  const std::vector<Sheet> soft = at(10), stiff = at(1e5);
  for (size_t i = 0; i < soft.size(); ++i) {
    const bool falls = soft[i].name == "linear";  // it has no force across its plane
    std::printf("| %s | %s | %s | %s |\n", soft[i].name.c_str(),
                error_text(strip_error(soft[i])).c_str(),
                falls ? "–" : error_text(catenary_error(stiff[i], 1e5)).c_str(),
                error_text(frequency_error(soft[i])).c_str());
  }
}

// Runs -------------------------------------------------------------------------------------------

// A scene of the threads, with another way to resist.
TestScene with_sheet(TestScene scene, const Sheet& sheet) {
  Model model = sheet.model;
  model.density = density;
  model.pins = scene.cloth.pins;
  model.gravity = scene.cloth.gravity;
  scene.cloth = make_cloth(scene.mesh, model);
  return scene;
}

struct Run {
  bool exploded = false;
  double gain = 0;  // J, the most that the energy rose above that of the start
  State end;
  Counts counts;
};

Run run(TestScene scene, const Configuration& configuration, double h, double seconds) {
  const auto simulator = make_simulator(configuration, scene.cloth);
  Run result;
  result.end = scene.start;
  const double start = energies(scene.cloth, scene.start).total();
  for (long step = 0; step < std::lround(seconds / h) && !result.exploded; ++step) {
    simulator->step(h, result.end);
    result.exploded =
        !result.end.x.allFinite() || has_exploded(max_stretch(scene.mesh, result.end.x));
    if (!result.exploded)
      result.gain = std::max(result.gain, energies(scene.cloth, result.end).total() - start);
  }
  result.counts = simulator->counts();
  return result;
}

double h_crit(TestScene scene) {
  const auto simulator = make_simulator({.step = 1}, scene.cloth);
  return critical_step(*simulator, scene.cloth, scene.start);
}

// The vertex in the middle lies in the plane of the cloth, beyond its neighbours.
TestScene inverted(double k) {
  TestScene scene = extremes::dropped(k);
  scene.start.x.segment<3>(3 * extremes::vertex(6, 6)) += Vec3(1.5, 0, -0.25) / extremes::cells;
  return scene;
}

// Explicit steps at half of h_crit of the flat cloth, for 0.2 s.
std::string explicit_outcome(const Sheet& sheet, extremes::MakeScene make) {
  const double h = 0.5 * h_crit(with_sheet(extremes::dropped(E), sheet));
  const Run outcome = run(with_sheet(make(E), sheet), {.step = 1}, h, 0.2);
  if (outcome.exploded) return "explodes";
  return outcome.gain > 0.01 ? text("gains %.1g J", outcome.gain) : "stable";
}

// Plain implicit steps of 1/60 s, for 0.2 s: how many of the 12 the guard took again.
std::string implicit_outcome(const Sheet& sheet, extremes::MakeScene make) {
  const Run outcome = run(with_sheet(make(E), sheet), {.step = 3}, 1.0 / 60, 0.2);
  if (outcome.exploded) return "explodes";
  return text("%ld", outcome.counts.redone) +
         (outcome.gain > 0.01 ? text(", gains %.1g J", outcome.gain) : "");
}

void print_extremes() {
  std::printf(
      "| model | h_crit (s) | systems a step, Newton | squeezed | a vertex pushed through | "
      "tangled "
      "|\n|---|---|---|---|---|---|\n");
  for (const Sheet& sheet : ways()) {
    const TestScene dropped = with_sheet(extremes::dropped(E), sheet);
    const Run newton = run(dropped, {.step = 3, .method = {.newton = 50}}, 1.0 / 60, 1);
    std::string cells;
    for (const extremes::MakeScene make : {extremes::squeezed, inverted, extremes::tangled})
      cells += explicit_outcome(sheet, make) + " · " + implicit_outcome(sheet, make) + " | ";
    std::printf("| %s | %.5g | %.1f%s | %s\n", sheet.name.c_str(), h_crit(dropped),
                double(newton.counts.assemblies) / 60,
                newton.counts.unconverged > 0
                    ? text(", %ld of 60 steps unconverged", newton.counts.unconverged).c_str()
                    : "",
                cells.c_str());
    std::fflush(stdout);
  }
}

// Pictures ---------------------------------------------------------------------------------------

// A square metre of 24 × 24 cells that falls and swings, after 0.42 s. The linear one has no force across
// its plane, and falls as a stone does.
void draw_models(const fs::path& directory) {
  constexpr int n = 24, width = 640, height = 360;
  const Mesh mesh = make_grid({1, 1}, {n, n}, Diagonals::alternating);
  const Surface surface{
      .faces = mesh.faces, .texture = mesh.rest, .pins = {n * (n + 1), n * (n + 1) + n}};
  Renderer renderer(surface);
  const Stage stage{
      .eye = {1.75, 0.35, 1.05}, .target = {0.5, -0.42, -0.9}, .ground = -1.1, .size = 1};
  std::vector<Image> tiles;
  for (const Sheet& sheet : ways()) {
    TestScene scene = scene_of(mesh, sheet.model, Gravity::on, {n * (n + 1), n * (n + 1) + n});
    const Run fallen = run(scene, {.step = 4}, 1.0 / 600, 0.42);
    tiles.push_back(renderer.draw(stage, fallen.end.x, {.width = width, .height = height}));
    draw_text(tiles.back(), 20, 20, 20, sheet.name, {70, 78, 92});
  }
  write_png(directory / "models.png", film_strip(tiles, 4));
  std::printf("  see %s\n", (directory / "models.png").c_str());
}

void plot_pull(const fs::path& directory) {
  const std::vector<std::string> names = {"threads", "stvk", "neo-hookean", "neo-hookean-barrier"};
  std::ofstream csv(directory / "pull.csv");
  csv << "s";
  for (const std::string& name : names) csv << "," << name;
  csv << "\n";
  std::vector<Sheet> sheets;
  for (const std::string& name : names) sheets.push_back(membrane_sheet(name, moduli_of(1, 0)));
  for (double s = 0.02; s <= 1.6; s += 0.01) {
    csv << s;
    for (const Sheet& sheet : sheets) csv << "," << sheet.pull(s);
    csv << "\n";
  }
  csv.close();
  draw(directory, "pull", gnuplot_style + R"gp(set terminal pngcairo size 900,560 font ",13"
set output "pull.png"
set format "%g"
set xrange [0:1.6]
set yrange [-1.5:1.2]
set xlabel "stretch s"
set ylabel "force per width / E"
set key right bottom
set arrow from 0.57735,-1.5 to 0.57735,1.2 nohead dt 3 lc rgb "#888888"
set label "1/√3" at 0.59,1.0
plot "pull.csv" skip 1 using 1:2 with lines lt 1 title "threads, springs, linear, corotated, arap", \
     "" skip 1 using 1:3 with lines lt 2 title "stvk", \
     "" skip 1 using 1:4 with lines lt 3 title "neo-hookean", \
     "" skip 1 using 1:5 with lines lt 4 title "neo-hookean-barrier"
)gp");
}

// ψ of a membrane whose triangle is turned by an angle about its normal, J/m².
double energy_when_turned(const std::string& name, double angle) {
  Model model = with_membrane(name, moduli_of(1, 0));
  const Triangle t = make_triangle({0, 1, 2}, Vec2(0, 0), Vec2(1, 0), Vec2(0, 1));
  if (auto& linear = model.term<LinearMembrane>()) linear->axes = {{Vec3::UnitX(), Vec3::UnitY()}};
  const Mat3 R = Eigen::AngleAxisd(angle, Vec3::UnitZ()).toRotationMatrix();
  double energy = 0;
  model.triangles.conditions(
      t, {R * Vec3::UnitX(), R * Vec3::UnitY()},
      [&](const Term& term, const auto& c) { energy += 0.5 * term.k * c.C * c.C / t.area; });
  return energy;
}

void plot_rotation(const fs::path& directory) {
  std::ofstream csv(directory / "rotation.csv");
  csv << "angle,linear,corotated\n";
  for (int degrees = 0; degrees <= 180; degrees += 2) {
    const double angle = degrees * pi / 180;
    csv << degrees << "," << energy_when_turned("linear", angle) << ","
        << energy_when_turned("corotated", angle) << "\n";
  }
  csv.close();
  draw(directory, "rotation", gnuplot_style + R"gp(set terminal pngcairo size 900,480 font ",13"
set output "rotation.png"
set format "%g"
set xrange [0:180]
set xtics 30
set xlabel "the cloth is turned by (degrees)"
set ylabel "energy per area / E"
set key left top
plot "rotation.csv" skip 1 using 1:2 with lines lt 2 title "linear", \
     "" skip 1 using 1:3 with lines lt 1 title "all other models"
)gp");
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("All ways to resist a change of shape within the plane: pictures and a table");
  app.set_help_flag("--help", "list the options");
  fs::path directory = "out/compare_models";
  std::string table;
  app.add_option("--out", directory, "directory of the pictures; out/compare_models if absent");
  app.add_option("--table", table, "print one table, and draw nothing: errors, extremes")
      ->check(CLI::IsMember({"errors", "extremes"}));
  CLI11_PARSE(app, argc, argv);
  try {
    if (table != "extremes") print_errors();
    if (table != "errors") print_extremes();
    if (!table.empty()) return 0;
    fs::create_directories(directory);
    plot_pull(directory);
    plot_rotation(directory);
    draw_models(directory);
  } catch (const std::exception& error) {
    std::cerr << "compare_models: " << error.what() << "\n";
    return 1;
  }
}
