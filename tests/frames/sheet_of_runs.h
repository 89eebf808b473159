// Runs as one picture: a row per run, the same times in each column.
#pragma once
#include <vector>

#include "comparison.h"
#include "picture/image.h"

// All comparisons are with the same A, whose row comes first. With `differences` a row for each other run
// shows where it differs from A.
Image sheet_of_runs(const std::vector<Comparison>&, bool differences);
