#include "tradeoff/small_steps.h"

#include <cstdio>

#include "support/gnuplot.h"
#include "support/text.h"

namespace tradeoff {

const std::vector<Iterated>& iterated_methods() {
  static const std::vector<Iterated> all = {
      {"Newton",
       [](const Study& study, int n) -> Configuration {
         const int step = first_step_of(study.meshes.front().scene.cloth) == 5 ? 5 : 3;
         return {step, {.newton = n, .tolerance = 1e-8}};
       }},
      {"XPBD", [](const Study&, int n) { return xpbd_of(n); }},
      {"VBD", [](const Study&, int n) { return vbd_of(n); }},
  };
  return all;
}

std::array<double, 3> small_step_errors(const Study& study, size_t mesh, const Iterated& method,
                                        long total) {
  std::array<double, 3> errors;
  for (size_t i = 0; i < errors.size(); ++i) {
    const int n = iterations_per_step[i];
    errors[i] =
        error_of(study.meshes[mesh], study.references[mesh], {method.with(study, n), total / n});
  }
  return errors;
}

namespace {

// What the study of one mesh measured: the errors of every method by the number of iterations.
struct SmallSteps {
  long iterations;
  std::vector<std::array<double, 3>> errors;  // one entry per method
};

std::vector<SmallSteps> measure_small_steps(const Study& study, size_t mesh) {
  std::vector<SmallSteps> rows;
  for (long total = 64; total <= 16384; total *= 4) {
    SmallSteps row{total, {}};
    for (const Iterated& method : iterated_methods())
      row.errors.push_back(small_step_errors(study, mesh, method, total));
    rows.push_back(row);
  }
  return rows;
}

void print_table(const std::vector<SmallSteps>& rows, const std::string& mesh) {
  std::printf(
      "\nErrors for the same work%s: few steps of 16 or 4 iterations, or as many steps as "
      "iterations\n\n  %10s",
      mesh.c_str(), "iterations");
  for (const Iterated& method : iterated_methods())
    for (const int n : iterations_per_step)
      std::printf(" %9s", (method.name + format(" %d", n)).c_str());
  std::printf("\n");
  for (const SmallSteps& row : rows) {
    std::printf("  %10ld", row.iterations);
    for (const auto& errors : row.errors)
      for (const double error : errors)
        std::printf(" %9s", error == error ? format("%.1e", error).c_str() : "-");
    std::printf("\n");
  }
}

// A block of gnuplot's data: iterations, then the errors with 16, 4 and 1 of them in a step.
std::string data_block(const std::vector<SmallSteps>& rows, size_t method) {
  std::string block = format("$method%d << EOD\n", int(method));
  for (const SmallSteps& row : rows) {
    block += std::to_string(row.iterations);
    for (const double error : row.errors[method]) block += format(",%.6g", error);
    block += "\n";
  }
  return block + "EOD\n";
}

// The power of ten below all errors: every panel has the same range.
double decade_below(const std::vector<SmallSteps>& rows) {
  double least = 1;
  for (const SmallSteps& row : rows)
    for (const auto& errors : row.errors)
      for (const double error : errors) least = error > 0 && error < least ? error : least;
  return std::pow(10, std::floor(std::log10(least)));
}

// One panel per method, one line per number of iterations in a step.
std::string script(const std::vector<SmallSteps>& rows) {
  const auto& methods = iterated_methods();
  std::string text = gnuplot_style + R"gp(set terminal pngcairo size 1100,440 font "sans,13"
set output "small_steps.png"
set logscale xy
set xlabel "iterations in the whole run"
set ylabel "error at the end: RMS distance / size"
)gp";
  text += format("set yrange [%g:1]\nset multiplot layout 1,%d\n", decade_below(rows),
                 int(methods.size()));
  for (size_t m = 0; m < methods.size(); ++m) {
    text += data_block(rows, m) + format("set title \"%s\"\nplot ", methods[m].name);
    for (size_t i = 0; i < iterations_per_step.size(); ++i)
      text += format("%s$method%d using 1:%d with linespoints lt %d title \"%d in a step\"",
                     i ? ", " : "", int(m), int(i + 2), int(i + 1), iterations_per_step[i]);
    text += "\nset nokey\nset ylabel\n";
  }
  return text + "unset multiplot\n";
}

}  // namespace

void compare_small_steps(const Study& study) {
  for (size_t mesh = 0; mesh < study.meshes.size(); ++mesh) {
    const std::vector<SmallSteps> rows = measure_small_steps(study, mesh);
    print_table(rows, study.meshes.size() > 1 ? format(", %d cells", cells_of(study.meshes[mesh]))
                                              : std::string());
    if (mesh == 0) draw(study.out, "small_steps", script(rows));
  }
  std::printf(
      "\n  Newton 16: one step of at most 16 iterations; it ends when it has converged. Newton 1: "
      "the plain step.\n");
}

}  // namespace tradeoff
