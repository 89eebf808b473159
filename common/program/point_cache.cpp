#include "program/point_cache.h"

#include <bit>
#include <cstdint>
#include <string>

namespace {

constexpr long header_bytes = 32;

void append(std::string& bytes, std::uint32_t number) {
  for (int shift = 0; shift < 32; shift += 8) bytes += char(number >> shift & 255);
}

void append(std::string& bytes, float number) {
  append(bytes, std::bit_cast<std::uint32_t>(number));
}

std::string header(long vertices, long samples) {
  const float first_frame = 0, frames_per_sample = 1;
  std::string bytes("POINTCACHE2\0", 12);
  append(bytes, std::uint32_t(1));
  append(bytes, std::uint32_t(vertices));
  append(bytes, first_frame);
  append(bytes, frames_per_sample);
  append(bytes, std::uint32_t(samples));
  return bytes;
}

std::string sample(const VecX& x) {
  std::string bytes;
  bytes.reserve(sizeof(float) * size_t(x.size()));
  for (const double coordinate : x) append(bytes, float(coordinate));
  return bytes;
}

void write_at(long place, const std::string& bytes, WholeFile& file) {
  std::fseek(file.stream(), place, SEEK_SET);
  file.write(bytes);
}

}  // namespace

// The header counts a sample only after the sample is there.
void PointCache::write(const VecX& x) {
  if (!file) file.emplace(path);
  const std::string bytes = sample(x);
  write_at(header_bytes + samples * long(bytes.size()), bytes, *file);
  write_at(0, header(x.size() / 3, ++samples), *file);
  std::fseek(file->stream(), 0, SEEK_END);
  file->keep();
}

void PointCache::close() {
  if (file && file->is_open()) file->finish();
}
