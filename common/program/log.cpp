#include "program/log.h"

#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace {

[[noreturn]] void fail(const std::filesystem::path& path) {
  throw std::runtime_error(path.string() + ": cannot be written: " + std::strerror(errno));
}

}  // namespace

Log::Log(const std::filesystem::path& path_, const std::vector<std::string>& columns)
    : path(path_), part(path_.string() + ".part"), file(std::fopen(part.c_str(), "w")) {
  if (!file) fail(path);
  std::string header;
  for (const std::string& column : columns) header += (header.empty() ? "" : ",") + column;
  write(header + "\n");
}

// A run that ends in an error still leaves the rows that it wrote.
Log::~Log() {
  if (file && std::fclose(file) == 0) {
    std::error_code ignored;
    std::filesystem::rename(part, path, ignored);
  }
}

void Log::row(const std::vector<double>& values) {
  std::string line;
  char number[32];
  for (const double value : values) {
    std::snprintf(number, sizeof number, "%.12g", value);
    line += (line.empty() ? "" : ",") + std::string(number);
  }
  write(line + "\n");
}

void Log::write(const std::string& line) {
  if (std::fputs(line.c_str(), file) >= 0 && std::fflush(file) == 0) return;
  const int reason = errno;
  std::fclose(file);
  file = nullptr;
  std::error_code ignored;
  std::filesystem::remove(part, ignored);
  errno = reason;
  fail(path);
}

void Log::close() {
  std::FILE* open = file;
  file = nullptr;
  if (std::fclose(open) != 0 || std::rename(part.c_str(), path.c_str()) != 0) fail(path);
}
