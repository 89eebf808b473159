// A comparison of runs as JSON, for other programs and for the report in HTML.
#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "comparison.h"

// Where a page finds the pictures of a run, whose directory is the key: the run has this address as "pictures".
using PictureAddresses = std::map<std::filesystem::path, std::string>;

// { "version": 1, "pairs": [ … ] }, one pair for each comparison. Numbers that do not exist or are not finite
// are null; lengths in mm end in _mm, times are in s, energies in J.
std::string report_json(const std::vector<Comparison>&, const PictureAddresses& = {});
