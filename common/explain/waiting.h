// How far the runs of --explain have come, said on the standard error.
#pragma once
#include <unistd.h>

#include <chrono>
#include <cstdio>

// On a terminal a line that is drawn over; elsewhere a sign of life every ten seconds.
class Waiting {
 public:
  ~Waiting() {
    if (terminal) std::fprintf(stderr, "\r\033[K");
  }
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }
  void show(double part_done) {
    const double now = seconds(), left = now / part_done - now;
    if (now - shown < (terminal ? 0.1 : 10)) return;
    shown = now;
    const double percent = 100 * part_done;
    if (terminal)
      std::fprintf(stderr, "\rmeasuring: %3.0f %%, %.0f s left\033[K", percent, left);
    else
      std::fprintf(stderr, "measuring: %.0f %%, %.0f s left\n", percent, left);
  }

 private:
  bool terminal = isatty(STDERR_FILENO);
  std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
  double shown = 0;
};
