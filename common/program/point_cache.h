// points.pc2: the vertices of every frame in one file, as Blender and other programs read it.
#pragma once
#include <filesystem>
#include <optional>

#include "math/types.h"
#include "text/whole_file.h"

// The format PointCache2, all little-endian: "POINTCACHE2" and a zero byte; int32 version (1), int32 number of
// vertices, float32 first frame (0), float32 frames per sample (1), int32 number of samples; then x, y, z of every
// vertex as float32, one sample after the other. A run that breaks off leaves the samples that it wrote, and a run
// without a sample leaves no file. Throws CannotWrite.
class PointCache {
 public:
  explicit PointCache(const std::filesystem::path& path_) : path(path_) {}
  void write(const VecX& x);  // m, the next sample; all have the same number of vertices
  void close();

 private:
  std::filesystem::path path;
  std::optional<WholeFile> file;
  long samples = 0;
};
