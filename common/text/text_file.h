// Text files, and the numbers in them.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>

// Whole or not at all: throws CannotWrite (whole_file.h).
void write_text(const std::filesystem::path& path, std::string_view text);

// Why no file can be read at the path; "" where one can.
std::string no_file(const std::filesystem::path& path);

// The whole file. Throws BadInput where it is missing, a directory or unreadable.
std::string read_text(const std::filesystem::path& path);

// Appends 17 significant digits: enough to tell any two doubles apart.
void append_number(std::string& text, double number);

// Takes one number from the front of `text` and the blanks before it. False, and nothing taken,
// where there is none; "nan" and "inf" are none. Exact: reading what append_number wrote gives the
// same bits.
bool take_number(std::string_view& text, double& number);

// Takes one line from the front of `text`, without its end: LF, CR LF or CR. False at the end of the text.
bool take_line(std::string_view& text, std::string_view& line);
