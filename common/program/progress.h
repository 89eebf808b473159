// How far a run has come: a bar with the time left on a terminal, plain lines elsewhere.
#pragma once
#include <chrono>
#include <cstdio>
#include <string>

// "25 % done, 9 s left", if the steps to come take as long as those so far, which took `seconds`. Before the
// first step the time left is not known: "0 % done".
std::string progress_text(long step, long steps, double seconds);

class Progress {
 public:
  explicit Progress(long steps, const std::string& what = "", std::FILE* stream = stdout);

  // To be called after every step: draws ten times a second, or writes a line every ten seconds.
  void show(long step);
  void show_frame(int frame, int frames, long step, double time);
  void end();  // clears the bar

 private:
  using Clock = std::chrono::steady_clock;
  double seconds_since(Clock::time_point) const;

  long steps;
  std::string what;  // before every line: "measuring: "
  std::FILE* stream;
  bool terminal;
  Clock::time_point start, shown;
};
