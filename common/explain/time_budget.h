// How long --explain may take: by a clock on the wall, so that a busy machine ends it no later.
#pragma once
#include <chrono>
#include <functional>
#include <utility>

// s, since an arbitrary moment
inline double wall_clock() {
  const auto since = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double>(since).count();
}

class TimeBudget {
 public:
  using Clock = std::function<double()>;  // s

  explicit TimeBudget(double seconds_, Clock clock_ = wall_clock)
      : seconds(seconds_), clock(std::move(clock_)), start(clock()) {}

  // From the same start, but it ends after this share of the time.
  TimeBudget part(double share) const {
    TimeBudget shorter = *this;
    shorter.seconds *= share;
    return shorter;
  }
  double length() const { return seconds; }         // s
  double spent() const { return clock() - start; }  // s
  bool is_left() const { return spent() < seconds; }

 private:
  double seconds;
  Clock clock;
  double start;
};
