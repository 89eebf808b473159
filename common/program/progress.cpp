#include "program/progress.h"

#include <unistd.h>

#include <cstdio>
#include <string>

Progress::Progress(long steps_)
    : steps(steps_), terminal(isatty(STDOUT_FILENO)), start(Clock::now()), shown(start) {}

double Progress::seconds_since(Clock::time_point moment) const {
  return std::chrono::duration<double>(Clock::now() - moment).count();
}

double Progress::seconds_left(long step) const {
  return step > 0 ? seconds_since(start) * double(steps - step) / double(step) : 0;
}

void Progress::show(long step) {
  const double patience = terminal ? 0.1 : 10;  // s; a log file needs no more than a sign of life
  if (seconds_since(shown) < patience) return;
  shown = Clock::now();
  const double done = double(step) / double(steps);
  if (terminal) {
    const int width = 40, full = int(done * width);
    std::printf("\r[%s%s] %3.0f %%  %.0f s left \033[K", std::string(size_t(full), '#').c_str(),
                std::string(size_t(width - full), ' ').c_str(), 100 * done, seconds_left(step));
  } else {
    std::printf("  %.0f %% done, %.0f s left\n", 100 * done, seconds_left(step));
  }
  std::fflush(stdout);
}

void Progress::show_frame(int frame, int frames, long step, double time) {
  if (terminal) return show(step);
  std::printf("  frame %d of %d  t = %.4g s\n", frame, frames, time);
  std::fflush(stdout);
  shown = Clock::now();
}

void Progress::end() {
  if (terminal) std::printf("\r\033[K");
  std::fflush(stdout);
}
