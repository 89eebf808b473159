// The machine that the program runs on.
#pragma once
#include <unistd.h>

// All of its memory, in bytes.
inline double physical_memory() {
  return double(sysconf(_SC_PHYS_PAGES)) * double(sysconf(_SC_PAGESIZE));
}
