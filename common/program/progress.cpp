#include "program/progress.h"

#include <unistd.h>

#include "text/text.h"

std::string progress_text(long step, long steps, double seconds) {
  const std::string done = text("%.0f %% done", 100 * double(step) / double(steps));
  if (step == 0) return done;
  return done + text(", %.0f s left", seconds * double(steps - step) / double(step));
}

Progress::Progress(long steps_, const std::string& what_, std::FILE* stream_)
    : steps(steps_), what(what_), stream(stream_), terminal(isatty(fileno(stream))),
      start(Clock::now()), shown(start) {}

double Progress::seconds_since(Clock::time_point moment) const {
  return std::chrono::duration<double>(Clock::now() - moment).count();
}

void Progress::show(long step) {
  const double interval = terminal ? 0.1 : 10;  // s
  if (seconds_since(shown) < interval) return;
  shown = Clock::now();
  const std::string said = progress_text(step, steps, seconds_since(start));
  if (terminal) {
    const long width = 40, full = width * step / steps;
    std::fprintf(stream, "\r%s[%s%s] %s \033[K", what.c_str(),
                 std::string(size_t(full), '#').c_str(),
                 std::string(size_t(width - full), ' ').c_str(), said.c_str());
  } else {
    std::fprintf(stream, "  %s%s\n", what.c_str(), said.c_str());
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
