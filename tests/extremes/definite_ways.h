// Steps 3 and 5 with another way to make the matrix definite. The time_step.h of each step does the work,
// unchanged; definite_ways.cpp replaces the tension of an element, and what happens at a matrix that is not
// definite.
#pragma once
#include <array>
#include <memory>

#include "extremes/filtered_tension.h"
#include "math/cloth.h"

namespace extremes {

// `full` is --jacobian bw98, without a guard. `on_demand` takes the printed matrix; where the solver finds
// that it is not definite, it assembles the system again as `tension`, and solves it. It has the guard.
enum class Way { tension, clamp, absolute, sum, kim, full, on_demand };
inline constexpr std::array all_ways = {Way::tension, Way::clamp, Way::absolute, Way::sum,
                                        Way::kim,     Way::full,  Way::on_demand};
inline const char* name(Way way) {
  return std::array{"tension", "clamp", "absolute", "sum", "kim", "full", "on-demand"}[size_t(way)];
}

struct WayCounts {
  long systems = 0;     // assembled and solved
  long indefinite = 0;  // of them, those that were not definite
  long iterations = 0;  // of Newton's method
  long halvings = 0;    // in its line search
  long cg = 0;          // iterations of conjugate gradients
  long redone = 0, unconverged = 0;
};

class WaySimulator {
 public:
  virtual ~WaySimulator() = default;

  virtual void step(double h, State&) = 0;
  virtual WayCounts counts() const = 0;
  // True if the printed matrix of a step from this state is positive definite. Not counted.
  virtual bool full_is_definite(double h, const State&) = 0;
};

// step: 3 or 5, with --newton `newton`. For a cloth without damping, which must outlive the simulator.
std::unique_ptr<WaySimulator> make_way(Way, int step, Cloth&, int newton);

}  // namespace extremes
