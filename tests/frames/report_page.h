// A comparison of runs as a page of HTML: both films in step, and curves over time.
#pragma once
#include <filesystem>
#include <vector>

#include "comparison.h"

// Writes the page, and beside it a directory with copies of the pictures: for report.html it is
// report_files. The page says which pictures cannot be read. Throws CannotWrite (text/whole_file.h).
void write_report_page(const std::filesystem::path& html, const std::vector<Comparison>&);
