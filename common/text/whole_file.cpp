#include "text/whole_file.h"

#include <cerrno>
#include <cstring>
#include <utility>

CannotWrite::CannotWrite(const std::filesystem::path& path, const std::string& reason)
    : std::runtime_error("cannot write " + path.string() + ": " + reason) {}

WholeFile::WholeFile(const std::filesystem::path& path_)
    : path(path_), part(path_.string() + ".part"), file(std::fopen(part.c_str(), "wb")) {
  if (!file) throw CannotWrite(path, std::strerror(errno));
}

WholeFile::~WholeFile() {
  if (file) abandon();
}

void WholeFile::keep() {
  kept = std::ftell(file);
}

void WholeFile::abandon() {
  if (file) std::fclose(std::exchange(file, nullptr));
  std::error_code error;
  if (kept > 0) std::filesystem::resize_file(part, std::uintmax_t(kept), error);
  if (kept > 0 && !error)
    std::filesystem::rename(part, path, error);
  else
    std::filesystem::remove(part, error);
}

void WholeFile::write(std::string_view bytes) {
  if (std::fwrite(bytes.data(), 1, bytes.size(), file) != bytes.size() || std::fflush(file) != 0)
    fail(std::strerror(errno));
}

// Closing hands the last bytes to the system, so a full disk may show only here.
void WholeFile::finish() {
  if (std::fclose(std::exchange(file, nullptr)) != 0) fail(std::strerror(errno));
  std::error_code error;
  std::filesystem::rename(part, path, error);
  if (error) fail(error.message());
}

void WholeFile::fail(const std::string& reason) {
  abandon();
  throw CannotWrite(path, reason);
}
