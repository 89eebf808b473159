// What sets h: the longest stable explicit step, and the term that makes it as short as it is.
#pragma once
#include "explain/explain.h"
#include "explain/parts.h"

struct Limit {
  double h_crit;                // s; infinite where nothing pulls back
  std::vector<double> without;  // the same without each part
};

// As an explicit program says it: forces with damping, at the start.
Limit explicit_limit(const Scene&, const std::vector<Part>&, const Simulate&, const Method&);

// 2/h_crit of the forces without damping at the start, 1/s: the largest angular frequency.
double largest_frequency(const Scene&);
