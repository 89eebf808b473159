// Files that are there whole or not at all.
#pragma once
#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <string_view>

// "cannot write PATH: REASON".
struct CannotWrite : std::runtime_error {
  CannotWrite(const std::filesystem::path& path, const std::string& reason);
};

// A file that is written as "<path>.part" and gets its name from finish(): a run that breaks off
// leaves no half file. Every function throws CannotWrite with the system's reason, and then no
// .part is left.
class WholeFile {
 public:
  explicit WholeFile(const std::filesystem::path&);
  ~WholeFile();  // without finish(): only what was kept is left
  WholeFile(const WholeFile&) = delete;
  WholeFile& operator=(const WholeFile&) = delete;

  void write(std::string_view bytes);  // up to the disk
  void finish();
  void keep();  // what is written so far stays under its name, even if the rest cannot be written
  bool is_open() const { return file; }
  std::FILE* stream() const { return file; }  // for a library that writes by itself

 private:
  void abandon();
  [[noreturn]] void fail(const std::string& reason);

  std::filesystem::path path, part;
  std::FILE* file;
  long kept = 0;  // bytes
};
