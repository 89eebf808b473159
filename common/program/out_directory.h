// The directory of the results of one run.
#pragma once
#include <filesystem>

class OutDirectory {
 public:
  // Creates the directory. Throws BadInput where it cannot be written, where a directory has the name of a
  // file of a run, or while another run writes there. The system frees the lock of every run that ends. Until
  // the program takes the signals itself, Ctrl-C removes a directory that was made for this run.
  explicit OutDirectory(const std::filesystem::path&);
  ~OutDirectory();  // a directory that was made for this run and is empty goes
  OutDirectory(const OutDirectory&) = delete;
  OutDirectory& operator=(const OutDirectory&) = delete;

  // Removes log.csv, pictures and meshes of an earlier run, so that none is taken for one of this run.
  void remove_earlier_run() const;

 private:
  [[noreturn]] void refuse(const std::string& reason) const;
  void create();
  void lock();
  void go_with_a_signal() const;

  std::filesystem::path path;
  bool is_new = false;
  int descriptor = -1;
};
