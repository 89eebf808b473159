// How the page of --explain is set: at most 100 columns.
#pragma once
#include <string>
#include <vector>

[[gnu::format(printf, 1, 2)]] std::string text(const char* format, ...);

std::string joined(const std::vector<std::string>& parts, const std::string& between);

// Filled up with spaces; UTF-8, a character is a column.
std::string padded(const std::string& words, size_t width);

// Without the spaces at its end.
void print_row(const std::string& columns);

// Indented, on as many lines as it needs.
void print_wrapped(const std::string& words);

std::string length(double m);       // 0.54 mm, 1.41 m
std::string bytes(size_t number);   // 96 B, 458 kB, 3.2 MB
std::string percent(double part);   // 34 %
std::string per_cent(double part);  // with two digits: 0.038 %
