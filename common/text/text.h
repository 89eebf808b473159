// From numbers and words to text.
#pragma once
#include <string>
#include <vector>

// printf into a string.
[[gnu::format(printf, 1, 2)]] std::string text(const char* format, ...);

std::string joined(const std::vector<std::string>& parts, const std::string& between);
// Words for a terminal: control characters are shown as escapes, \n or \x1b, and of more than 300 bytes only
// the beginning and the end are kept.
std::string one_line(std::string words);

// A word for a shell: in quotes if the shell would not take it as it stands.
std::string shell_word(const std::string& word);

std::string count(long number, const std::string& thing);  // 1 step, 2 steps
std::string shortest(double number);  // the fewest digits that give the same number again
std::string length(double m);         // 0.54 mm, 1.41 m
std::string bytes(size_t number);     // 96 B, 458 kB, 3.2 MB
std::string percent(double part);     // 34 %
std::string per_cent(double part);    // with two digits: 0.038 %

// Columns of UTF-8, where a character is as wide as any other.
std::string padded(const std::string& words, size_t width);  // filled up with spaces
std::string wrapped(const std::string& words,
                    size_t width);  // lines, indented by 4, the later by 6
