// One reader decides what a line of an OBJ file is. tinyobjloader alone accepts too much without a word: it
// reads nan as 0, turns an index of many digits into another vertex, fills missing coordinates with 0, and
// does not check indices. So it gets only lines that were understood here.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>

// The v and vt lines, and then the faces, of an OBJ file, without whatever else may stand there. Throws
// BadInput with file, line and reason where a v, vt or f line is incomplete, a number is not finite, a face
// is not a triangle, or an index is out of range. `source` names the file in messages.
std::string plain_obj(std::string_view text, const std::filesystem::path& source);
