// The cost of one evaluation of all forces per triangle, in the three ways of three_ways.h.
//
// Google Benchmark prints the absolute times. The table after them has the ratios.
#include <benchmark/benchmark.h>

#include <cstdio>
#include <cstdlib>

#include "support/cpu_time.h"
#include "three_ways.h"

namespace {

constexpr std::array<int, 4> sizes = {32, 64, 128, 256};

// Different forces make any comparison of times worthless.
void require_equal_forces() {
  for (const int n : sizes) {
    const Sheet sheet(n);
    const VecX ours = Ours(sheet).forces(sheet.state);
    const double transcribed = difference(ours, Transcribed(sheet).forces(sheet.state));
    const double differentiated = difference(ours, Differentiated(sheet).forces(sheet.state));
    if (!(std::max(transcribed, differentiated) < 1e-11)) {
      std::fprintf(stderr,
                   "bench_forces: at %d x %d cells our forces differ by %.1e from the "
                   "transcription and by %.1e from automatic differentiation\n",
                   n, n, transcribed, differentiated);
      std::exit(1);
    }
  }
}

template <class Way>
void forces(benchmark::State& run) {
  const Sheet sheet(int(run.range(0)));
  Way way(sheet);
  for ([[maybe_unused]] auto _ : run) benchmark::DoNotOptimize(way.forces(sheet.state).data());
  run.counters["per_triangle"] =
      benchmark::Counter(double(sheet.triangles()), benchmark::Counter::kIsIterationInvariantRate |
                                                        benchmark::Counter::kInvert);
}
BENCHMARK_TEMPLATE(forces, Ours)->Arg(32)->Arg(64)->Arg(128)->Arg(256);
BENCHMARK_TEMPLATE(forces, Transcribed)->Arg(32)->Arg(64)->Arg(128)->Arg(256);
BENCHMARK_TEMPLATE(forces, Differentiated)->Arg(32)->Arg(64)->Arg(128)->Arg(256);

template <class Way>
double ns_per_triangle(Way& way, const Sheet& sheet) {
  const size_t evaluations = std::max<size_t>(1, 200000 / sheet.triangles());
  const double start = cpu_seconds();
  for (size_t i = 0; i < evaluations; ++i) benchmark::DoNotOptimize(way.forces(sheet.state).data());
  return 1e9 * (cpu_seconds() - start) / double(evaluations * sheet.triangles());
}

// The three ways at one size, with their times in every round.
struct Measured {
  explicit Measured(int n) : sheet(n), ours(sheet), notes(sheet), autodiff(sheet) {}

  void measure() {
    ours_ns.push_back(ns_per_triangle(ours, sheet));
    notes_ns.push_back(ns_per_triangle(notes, sheet));
    autodiff_ns.push_back(ns_per_triangle(autodiff, sheet));
  }

  Sheet sheet;
  Ours ours;
  Transcribed notes;
  Differentiated autodiff;
  std::vector<double> ours_ns, notes_ns, autodiff_ns;
};

void print_summary() {
  constexpr int rounds = 15;
  std::array<Measured, sizes.size()> measured = {Measured(sizes[0]), Measured(sizes[1]),
                                                 Measured(sizes[2]), Measured(sizes[3])};
  for (int round = 0; round < rounds; ++round)
    for (Measured& m : measured) m.measure();

  std::printf(
      "\nForces of stretch and shear: ns of CPU time per triangle, medians of %d rounds\n\n"
      "%9s %7s %11s %7s %12s %9s %15s\n",
      rounds, "cells", "ours", "vs 64 x 64", "notes", "notes / ours", "autodiff",
      "autodiff / ours");
  for (size_t i = 0; i < sizes.size(); ++i) {
    const Measured& m = measured[i];
    std::printf("%3d x %-3d %7.1f %11.2f %7.1f %12.2f %9.1f %15.2f\n", sizes[i], sizes[i],
                median(m.ours_ns), median_ratio(m.ours_ns, measured[1].ours_ns), median(m.notes_ns),
                median_ratio(m.notes_ns, m.ours_ns), median(m.autodiff_ns),
                median_ratio(m.autodiff_ns, m.ours_ns));
  }
  std::printf(
      "\nAs it should be: notes / ours above 0.77, autodiff / ours above 1, and the cost at "
      "128 and 256\nwithin 30 %% of that at 64.\n");
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  require_equal_forces();
  benchmark::RunSpecifiedBenchmarks();
  print_summary();
}
