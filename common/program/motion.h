// The pictures of motion.png, which moves.
#pragma once
#include <vector>

#include "picture/animation.h"
#include "scene/scene.h"

// Evenly spaced pictures: one of the start, and one at each moment i/24 of the run, i = 1 … 24. If the run has
// fewer than 24 steps, there is one after each step.
class Motion {
 public:
  explicit Motion(const Time&);

  bool is_due(long step) const;  // is the next picture that of this step, or of one before it?
  void add(Image);

  // They play as long as the simulated time, but at least 1 s and at most 3 s. The last picture stays another
  // second.
  const std::vector<AnimationFrame>& frames() const { return pictures; }

 private:
  long steps, moments;
  int between;  // ms, from one picture to the next
  std::vector<AnimationFrame> pictures;
};
