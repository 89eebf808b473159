#include "program/out_directory.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <vector>

#include "text/bad_input.h"

namespace {

constexpr std::string_view files_of_a_run[] = {
    "log.csv", "film.png", "still.png", "final.obj", "final_velocities.csv", "run.toml"};

// frame_0000.png, frame_0000.obj, …
bool is_frame(std::string_view name) {
  return name.size() == 14 && name.starts_with("frame_") &&
         name.find_first_not_of("0123456789", 6) == 10 &&
         (name.ends_with(".png") || name.ends_with(".obj"));
}

bool is_of_a_run(std::string_view name) {
  if (name.ends_with(".part")) name.remove_suffix(5);
  return is_frame(name) || std::ranges::count(files_of_a_run, name) > 0;
}

std::vector<std::filesystem::directory_entry> entries_of_a_run(const std::filesystem::path& path) {
  std::vector<std::filesystem::directory_entry> found;
  for (const auto& entry : std::filesystem::directory_iterator(path))
    if (is_of_a_run(entry.path().filename().string())) found.push_back(entry);
  return found;
}

}  // namespace

OutDirectory::OutDirectory(const std::filesystem::path& path_) : path(path_) {
  create();
  for (const auto& entry : entries_of_a_run(path))
    if (entry.is_directory())
      refuse(entry.path().filename().string() +
             " is a directory there, and a file is to be written");
  lock();
}

OutDirectory::~OutDirectory() {
  std::error_code ignored;
  if (is_new && std::filesystem::is_empty(path, ignored)) std::filesystem::remove(path, ignored);
  close(descriptor);
}

void OutDirectory::refuse(const std::string& reason) const {
  throw BadInput("--out " + path.string() + ": " + reason +
                 "; name a directory that can be written");
}

void OutDirectory::create() {
  std::error_code error;
  is_new = std::filesystem::create_directories(path, error);
  if (error) refuse(error.message());
  const std::filesystem::path probe = path / ".probe.part";
  const bool written = std::ofstream(probe).put('\n').flush().good();
  const int reason = errno;
  std::filesystem::remove(probe, error);
  if (!written) refuse(std::strerror(reason));
}

// A file system without locks refuses nothing.
void OutDirectory::lock() {
  descriptor = open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (flock(descriptor, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
  close(descriptor);
  throw BadInput("--out " + path.string() +
                 ": another run writes there; wait until it ends, or name another directory");
}

void OutDirectory::remove_earlier_run() const {
  for (const auto& entry : entries_of_a_run(path)) std::filesystem::remove(entry);
}
