// How the page of --explain is set: at most 100 columns.
#pragma once
#include <string>

#include "text/text.h"

// Filled up with spaces; UTF-8, a character is a column.
std::string padded(const std::string& words, size_t width);

// Without the spaces at its end.
void print_row(const std::string& columns);

// Indented, on as many lines as it needs.
void print_wrapped(const std::string& words);
