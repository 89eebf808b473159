// Refuses the lines of an OBJ file that tinyobjloader accepts silently: it reads nan as 0, turns an
// index of many digits into another vertex, and fills missing coordinates with 0.
#pragma once
#include <filesystem>
#include <string_view>

// Throws BadInput with file, line and reason where a v, vt or f line is incomplete, a number is not
// finite, a face is not a triangle, or an index is out of range. `source` names the file in
// messages.
void check_obj(std::string_view text, const std::filesystem::path& source);
