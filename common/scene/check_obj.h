// What tinyobjloader lets pass without a word: it reads nan as 0, wraps an index of many digits round
// to another vertex, and fills missing coordinates with 0.
#pragma once
#include <filesystem>
#include <string_view>

// Throws BadInput with file, line and reason where a v, vt or f line is not whole, a number not finite,
// a face no triangle, or an index names nothing. `source` names the file in messages.
void check_obj(std::string_view text, const std::filesystem::path& source);
