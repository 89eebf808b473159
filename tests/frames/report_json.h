// A comparison of runs as JSON, for other programs and for the report in HTML.
#pragma once
#include <string>
#include <vector>

#include "comparison.h"

// { "version": 1, "pairs": [ … ] }, one pair for each comparison. Numbers that do not exist or are not finite
// are null; lengths in mm end in _mm, times are in s, energies in J.
std::string report_json(const std::vector<Comparison>&);
