// The lines of an OBJ file that a cloth needs, exactly as written: v, vt and f.
#pragma once
#include <filesystem>
#include <optional>
#include <vector>

#include "math/types.h"

struct ObjCorner {
  int vertex = 0;         // from 0
  std::optional<int> uv;  // from 0; absent where the corner has no texture coordinate
};

struct ObjFace {
  int line;  // from 1
  std::array<ObjCorner, 3> corners;
};

struct ObjFile {
  std::vector<Vec3> positions;  // v
  std::vector<Vec2> uv;         // vt
  std::vector<ObjFace> faces;   // f; its corners name lines that exist, all three a vt or none
};

// Throws BadInput, naming file and line.
ObjFile read_obj_file(const std::filesystem::path&);
