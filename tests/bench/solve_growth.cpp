// How the time of a step grows with the number of vertices, and where conjugate
// gradients beat direct solvers.
#include <Eigen/SparseCholesky>
#include <map>

#include "bench_solve.h"
#include "math/multigrid.h"
#include "solve_cases.h"
#include "step03_implicit/time_step.h"
#include "support/cpu_time.h"
#include "support/gnuplot.h"

namespace {

struct Point {
  std::string name;  // the preconditioner and the error, or the direct solver
  int cells;
  double tolerance = 0;
  size_t iterations = 0, needed = 0;  // to reach the tolerance; to reach the error
  std::function<void()> step = {};
  double stored = 0, read = 0;  // bytes per vertex: of A and its solver; read per iteration
  std::vector<double> seconds = {};
  double vertices() const { return double((cells + 1) * (cells + 1)); }
};

// The bytes of matrices that one iteration reads, per vertex. It reads A once. ic reads its
// factor twice. A V-cycle reads, on every level, the blocks above the diagonal four times and the
// inverse diagonal blocks twice.
double bytes_read(const std::string& preconditioner, const Grid& grid, const BlockMatrix& A) {
  const auto matrix = [](double vertices, double edges) {
    return std::pair{double(sizeof(Mat3)) * vertices, double(sizeof(Mat3) + sizeof(int)) * edges};
  };
  const auto [diagonal, upper] = matrix(A.rows(), double(A.upper.size()));
  double read = diagonal + upper;
  if (preconditioner == "block") read += diagonal;
  if (preconditioner == "ic") read += 2 * (diagonal + upper);
  if (preconditioner == "multigrid")
    for (Grid level = grid; level.cells[0] % 2 == 0 && level.cells[1] % 2 == 0;
         level.cells[0] /= 2, level.cells[1] /= 2) {
      const double x = level.cells[0], y = level.cells[1];
      const auto [d, u] = matrix((x + 1) * (y + 1), x * (y + 1) + (x + 1) * y + x * y);
      read += 2 * d + 4 * u;
    }
  return read / A.rows();
}

double bytes_stored(const std::string& preconditioner, const Case& c, const BlockMatrix& A) {
  double stored = double(bytes(A));
  if (preconditioner == "block") stored += double(sizeof(Mat3)) * A.rows();
  if (preconditioner == "ic") stored += double(bytes(A)) + double(sizeof(Mat3)) * A.rows();
  if (preconditioner == "multigrid")
    stored += double(Multigrid(A, c.cloth.pins, *c.cloth.grid).bytes());
  return stored / A.rows();
}

// The bytes per vertex of A and of the sparse factor L of LDLᵀ.
double bytes_of_factor(const Case& c, const BlockMatrix& A) {
  FreeMatrix free(A, c.cloth.inverse_mass);
  free.copy(A);
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Upper> ldlt(free.values);
  const auto& L = ldlt.matrixL().nestedExpression();
  return (double(bytes(A)) + double(L.nonZeros()) * (sizeof(double) + sizeof(int))) / A.rows();
}

std::string label(const std::string& preconditioner, double error) {
  char text[60];
  std::snprintf(text, sizeof text, "%s %.0e", preconditioner.c_str(), error);
  return text;
}

void add_ours(const Case& c, const std::string& preconditioner, const VecX& truth,
              std::vector<Point>& points) {
  Problem problem(c, preconditioner);
  const BlockMatrix& A = problem.system.A;
  const double smallest = 1e-6;
  const auto looks = watch(c, problem.system, problem.system.dv, truth, {1, smallest / 2});
  for (const double error : {1e-2, 1e-4, smallest}) {
    const double tolerance = loosest(looks, error);
    const Method method{.guard = false, .preconditioner = preconditioner, .tolerance = tolerance};
    auto system = std::make_shared<step04::System>(c.cloth, method);
    points.push_back({label(preconditioner, error), c.setting.cells, tolerance,
                      iterations(looks, tolerance), iterations_to(looks, error),
                      [&c, system] {
                        State state = c.state;
                        step04::time_step(c.cloth, c.setting.h, state, *system);
                      },
                      bytes_stored(preconditioner, c, A),
                      bytes_read(preconditioner, *c.cloth.grid, A)});
  }
}

void add_direct(const Case& c, const std::string& solver, double stored,
                std::vector<Point>& points) {
  Method method{.guard = false};
  method.solver = solver;
  auto system = std::make_shared<step03::System>(c.cloth, method);
  points.push_back({solver, c.setting.cells, 0, 0, 0,
                    [&c, system] {
                      State state = c.state;
                      step03::time_step(c.cloth, c.setting.h, state, *system);
                    },
                    stored, 0});
}

// Measures every way at one size, in interleaved rounds. A way that has taken 2 s is not repeated.
std::vector<Point> measure(int cells) {
  const Case c({.cells = cells});
  std::fprintf(stderr, "  (%d x %d cells)\n", cells, cells);
  const BlockMatrix A = Problem(c, "none").system.A;
  const VecX truth = true_dv(c, Problem(c, "none").system);
  std::vector<Point> points;
  for (const char* name : {"multigrid", "ic", "block"}) add_ours(c, name, truth, points);
  add_direct(c, "ldlt", bytes_of_factor(c, A), points);
  if (best_direct() != "ldlt") add_direct(c, best_direct(), 0, points);
  std::map<std::string, double> spent;
  for (int round = 0; round < 7; ++round)
    for (Point& point : points) {
      if (spent[point.name] > 2) continue;
      point.seconds.push_back(seconds(point.step));
      spent[point.name] += point.seconds.back();
    }
  for (Point& point : points) point.step = {};
  return points;
}

using Series = std::map<std::string, std::vector<Point>>;

// The exponent p of seconds ~ N^p, by least squares over all sizes and from the last two sizes.
std::pair<double, double> exponents(const std::vector<Point>& points) {
  const auto x = [&](size_t i) { return std::log(points[i].vertices()); };
  const auto y = [&](size_t i) { return std::log(median(points[i].seconds)); };
  double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (size_t i = 0; i < points.size(); ++i)
    n += 1, sx += x(i), sy += y(i), sxx += x(i) * x(i), sxy += x(i) * y(i);
  const size_t last = points.size() - 1;
  return {(n * sxy - sx * sy) / (n * sxx - sx * sx),
          (y(last) - y(last - 1)) / (x(last) - x(last - 1))};
}

void print(const Series& series) {
  std::printf(
      "\nGrowth of a whole step; the number behind a preconditioner is the error in dv;\n"
      "needed: iterations to just that error, without the steps between tolerances\n"
      "way              cells  tolerance  iterations  needed         ms  us/vertex  bytes/vertex "
      "read an "
      "iteration  stored\n");
  for (const auto& [name, points] : series) {
    for (const Point& p : points)
      std::printf("%-15s  %5d  %9.0e  %10zu  %6zu  %9.1f  %9.2f  %30.0f  %6.0f\n", name.c_str(),
                  p.cells, p.tolerance, p.iterations, p.needed, 1e3 * median(p.seconds),
                  1e6 * median(p.seconds) / p.vertices(), p.read, p.stored);
    const auto [all, last] = exponents(points);
    std::printf("%-15s  time ~ N^%.2f, between the last two sizes N^%.2f\n\n", name.c_str(), all,
                last);
  }
}

void write_csv(const std::filesystem::path& file, const Series& series) {
  std::ofstream csv(file);
  csv << "way,cells,vertices,tolerance,iterations,needed,seconds,bytes_read,bytes_stored\n";
  for (const auto& [name, points] : series)
    for (const Point& p : points)
      csv << name << ',' << p.cells << ',' << p.vertices() << ',' << p.tolerance << ','
          << p.iterations << ',' << p.needed << ',' << median(p.seconds) << ',' << p.read << ','
          << p.stored << '\n';
}

// One line of a plot: column `y` of the rows of one way.
std::string line(const std::string& way, int y, const std::string& style,
                 const std::string& title) {
  return "\"growth.csv\" using (strcol(1) eq \"" + way + "\" ? $3 : NaN):" + std::to_string(y) +
         " with linespoints " + style + (title.empty() ? " notitle" : " title \"" + title + "\"");
}

const std::string axes = R"(set logscale xy
set xrange [800:9e4]
set xlabel "vertices"
set xtics ("33²" 1089, "65²" 4225, "129²" 16641, "257²" 66049)
set format y "%g"
)";

std::string growth_script(const Series& series) {
  const auto title = [&](const std::string& way, const std::string& name) {
    char text[80];
    std::snprintf(text, sizeof text, "%s: N^{%.2f}", name.c_str(), exponents(series.at(way)).first);
    return std::string(text);
  };
  std::string script = gnuplot_style +
                       "set terminal pngcairo size 900,540 font \"sans,13\"\nset output "
                       "\"growth.png\"\nset title \"A whole implicit step, error in Δv at most 1 "
                       "%\"\n" +
                       axes + "set ylabel \"seconds\"\nset key top left reverse Left\nplot ";
  script += line("block 1e-02", 7, "lt 2", title("block 1e-02", "block Jacobi"));
  script += ", \\\n " + line("ic 1e-02", 7, "lt 3", title("ic 1e-02", "incomplete Cholesky"));
  script += ", \\\n " + line("multigrid 1e-02", 7, "lt 1", title("multigrid 1e-02", "multigrid"));
  script += ", \\\n " + line("ldlt", 7, "lt 5 dt 2", title("ldlt", "direct, LDLᵀ"));
  if (series.count("cholmod"))
    script += ", \\\n " + line("cholmod", 7, "lt 4 dt 2", title("cholmod", "direct, CHOLMOD"));
  return script + ", \\\n 5e-6*x with lines lc rgb \"#999999\" dt 3 title \"slope of N\"\n";
}

std::string wins_script(const Series& series) {
  std::string script =
      gnuplot_style +
      "set terminal pngcairo size 1100,540 font \"sans,12\"\nset output \"cg_or_direct.png\"\n" +
      axes +
      "set multiplot layout 1,2\nset key top left reverse Left samplen 2\n"
      "set title \"Time of a step, by the error in Δv\"\nset ylabel \"seconds\"\n"
      "set yrange [0.0015:300]\nplot ";
  script += line("block 1e-06", 7, "lt 2", "block Jacobi, 10^{-6}");
  script += ", \\\n " + line("block 1e-02", 7, "lt 2 pt 4 dt 2", "block Jacobi, 10^{-2}");
  script += ", \\\n " + line("ic 1e-06", 7, "lt 3", "incomplete Cholesky, 10^{-6}");
  script += ", \\\n " + line("ic 1e-02", 7, "lt 3 pt 8 dt 2", "incomplete Cholesky, 10^{-2}");
  script += ", \\\n " + line("multigrid 1e-06", 7, "lt 1", "multigrid, 10^{-6}");
  script += ", \\\n " + line("multigrid 1e-02", 7, "lt 1 pt 6 dt 2", "multigrid, 10^{-2}");
  script += ", \\\n " + line("ldlt", 7, "lt 5", "direct, LDLᵀ");
  if (series.count("cholmod")) script += ", \\\n " + line("cholmod", 7, "lt 4", "direct, CHOLMOD");
  script +=
      "\nset title \"Memory of matrix and solver\"\nset ylabel \"bytes per vertex\"\n"
      "set yrange [200:10000]\nplot ";
  script += line("ldlt", 9, "lt 5", "direct, LDLᵀ");
  script += ", \\\n " + line("multigrid 1e-02", 9, "lt 1", "multigrid");
  script += ", \\\n " + line("ic 1e-02", 9, "lt 3", "incomplete Cholesky");
  script += ", \\\n " + line("block 1e-02", 9, "lt 2", "block Jacobi");
  return script + "\nunset multiplot\n";
}

}  // namespace

bool bench_growth() {
  Series series;
  for (const int cells : {32, 64, 128, 256})
    for (const Point& point : measure(cells)) series[point.name].push_back(point);
  print(series);
  const std::filesystem::path out = "out/bench_solve";
  std::filesystem::create_directories(out);
  write_csv(out / "growth.csv", series);
  draw(out, "growth", growth_script(series));
  draw(out, "cg_or_direct", wins_script(series));

  const auto spread = [&](const auto& of) {
    double least = 1e300, most = 0;
    for (const Point& p : series.at("multigrid 1e-02"))
      least = std::min(least, double(of(p))), most = std::max(most, double(of(p)));
    return most / least;
  };
  std::printf(
      "As it should be: multigrid's iterations at an error of 1e-2 within a factor of 4, its bytes "
      "per vertex within 1.1\n");
  const bool flat =
      require(spread([](const Point& p) { return p.needed; }) <= 4, "multigrid's iterations grow");
  return require(spread([](const Point& p) { return p.read; }) <= 1.1,
                 "bytes of an iteration grow faster than the number of vertices") &&
         flat;
}
