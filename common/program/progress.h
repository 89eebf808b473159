// How far a run has come: a bar with the time left on a terminal, plain lines elsewhere.
#pragma once
#include <chrono>

class Progress {
 public:
  explicit Progress(long steps);

  void show(long step);  // often: draws only when there is something new to see
  void show_frame(int frame, int frames, long step, double time);
  void end();  // leaves the line

 private:
  using Clock = std::chrono::steady_clock;
  double seconds_since(Clock::time_point) const;
  double seconds_left(long step) const;

  long steps;
  bool terminal;
  Clock::time_point start, shown;
};
