#include "program/motion.h"

#include <algorithm>
#include <cmath>

namespace {

constexpr long most_moments = 24;
constexpr double shortest_film = 1, longest_film = 3;  // s
constexpr int last_stays = 1000;                       // ms

}  // namespace

Motion::Motion(const Time& time)
    : steps(time.steps()), moments(std::min(most_moments, steps)),
      between(int(std::lround(1000 * std::clamp(time.end, shortest_film, longest_film) /
                              double(moments)))) {}

bool Motion::is_due(long step) const {
  return step >= std::lround(double(pictures.size()) * double(steps) / double(moments));
}

void Motion::add(Image image) {
  if (!pictures.empty()) pictures.back().milliseconds = between;
  pictures.push_back({std::move(image), between + last_stays});
}
