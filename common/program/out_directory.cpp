#include "program/out_directory.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fstream>
#include <vector>

#include "text/bad_input.h"

namespace {

constexpr std::string_view files_of_a_run[] = {
    "log.csv",    "film.png",  "still.png",  "motion.png",
    "motion.mp4", "final.obj", "points.pc2", "final_velocities.csv",
    "run.toml"};

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

char new_directory[4096];

// rmdir, which removes only an empty directory, signal and raise may stand in a signal handler.
void remove_directory_and_end(int signal) {
  rmdir(new_directory);
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

}  // namespace

OutDirectory::OutDirectory(const std::filesystem::path& path_) : path(path_) {
  create();
  for (const auto& entry : entries_of_a_run(path))
    if (entry.is_directory())
      refuse(entry.path().filename().string() +
             " is a directory there, and a file is to be written");
  lock();
  if (is_new) go_with_a_signal();
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

void OutDirectory::go_with_a_signal() const {
  if (path.native().size() >= sizeof new_directory) return;
  std::strcpy(new_directory, path.c_str());
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE})
    std::signal(signal, remove_directory_and_end);
}

void OutDirectory::remove_earlier_run() const {
  for (const auto& entry : entries_of_a_run(path)) std::filesystem::remove(entry);
}
