#include "program/progress.h"

#include <unistd.h>

#include "text/text.h"

Progress::Progress(long steps_, const std::string& what_, std::FILE* stream_)
    : steps(steps_), what(what_), stream(stream_), terminal(isatty(fileno(stream))),
      start(Clock::now()), shown(start) {}

double Progress::seconds_since(Clock::time_point moment) const {
  return std::chrono::duration<double>(Clock::now() - moment).count();
}

double Progress::seconds_left(long step) const {
  return step > 0 ? seconds_since(start) * double(steps - step) / double(step) : 0;
}

void Progress::show(long step) {
  const double interval = terminal ? 0.1 : 10;  // s
  if (seconds_since(shown) < interval) return;
  shown = Clock::now();
  const double done = double(step) / double(steps);
  if (terminal) {
    const int width = 40, full = int(done * width);
    std::fprintf(stream, "\r%s[%s%s] %3.0f %%  %.0f s left \033[K", what.c_str(),
                 std::string(size_t(full), '#').c_str(),
                 std::string(size_t(width - full), ' ').c_str(), 100 * done, seconds_left(step));
  } else {
    std::fprintf(stream, "  %s%.0f %% done, %.0f s left\n", what.c_str(), 100 * done,
                 seconds_left(step));
  }
  std::fflush(stream);
}

void Progress::show_frame(int frame, int frames, long step, double time) {
  if (terminal) return show(step);
  std::fprintf(stream, "  frame %d of %d  t = %.4g s\n", frame, frames, time);
  std::fflush(stream);
  shown = Clock::now();
}

void Progress::end() {
  if (terminal) std::fprintf(stream, "\r\033[K");
  std::fflush(stream);
}
