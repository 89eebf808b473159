// The parts of bench_solve. Each part prints a table and returns whether its counts are as they
// should be. It does not judge times.
#pragma once
#include <cstdio>
#include <functional>

bool bench_product();
bool bench_step();
bool bench_growth();
bool bench_warm();
bool bench_bend();
bool bench_mesh();
bool bench_mode();

inline bool require(bool holds, const char* what) {
  if (!holds) std::printf("NOT as it should be: %s\n", what);
  return holds;
}
