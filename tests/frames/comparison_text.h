// A comparison of runs for a terminal.
#pragma once
#include <string>

#include "comparison.h"

// What differs in the input, what could not be compared, a row for each pair of frames, and the summary.
std::string comparison_text(const Comparison&);
