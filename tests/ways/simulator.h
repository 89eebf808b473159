// The five steps and their methods behind one interface, for programs that compare them, and two ways
// beside them. The time_step.h of each step, xpbd.h and vbd.h do the work, compiled once, in simulator.cpp.
#pragma once
#include <memory>

#include "math/cloth.h"
#include "math/method.h"
#include "scene/step_names.h"

// Whose time step it is: that of a step, or one that no step's program offers (xpbd.h, vbd.h).
enum class Scheme { of_step, xpbd, vbd };

struct Configuration {
  int step = 1;  // 1 … 5; unless it is of a step, the scheme has none
  Method method =
      {};  // of steps 3 to 5; a step ignores the options whose concept it does not teach
  Scheme scheme = Scheme::of_step;
  int sweeps = 1;  // per time step, of XPBD and VBD
};

inline Configuration xpbd_of(int sweeps) {
  return {.scheme = Scheme::xpbd, .sweeps = sweeps};
}
inline Configuration vbd_of(int sweeps) {
  return {.scheme = Scheme::vbd, .sweeps = sweeps};
}

inline bool is_of_step(const Configuration& c) {
  return c.scheme == Scheme::of_step;
}
inline bool is_explicit(const Configuration& c) {
  return is_of_step(c) && c.step < 3;
}
inline bool is_implicit(const Configuration& c) {
  return is_of_step(c) && c.step >= 3;
}

inline const char* program_of(int step) {
  return step_names()[step - 1].c_str();
}

// The cost of a simulation so far, in counts that are the same on every machine.
struct Counts {
  // Evaluations of all forces; in steps 3 to 5 their derivatives come with them. XPBD and VBD evaluate
  // element by element: so many evaluations, divided by the number of elements.
  long forces = 0;
  // Evaluations of the potential energy, by the guard and Newton's line search; of VBD as above.
  long energies = 0;
  long assemblies = 0;  // systems A Δv = b set up
  long products = 0;    // of A, K or D and a vector
  // Bytes read and written: elements, vectors and matrices, every array once in every pass
  // over it. The inside of preconditioners and direct solvers and the vectors of Newton's
  // line search are not counted.
  long bytes = 0;

  long iterations = 0;   // of conjugate gradients; of XPBD and VBD: sweeps
  long indefinite = 0;   // systems that were not positive definite
  long capped = 0;       // systems in which conjugate gradients reached the iteration limit
  long redone = 0;       // plain steps taken again because they gained energy
  long unconverged = 0;  // steps in which Newton's method did not converge
};

class Simulator {
 public:
  virtual ~Simulator() = default;

  virtual void step(double h, State&) = 0;
  virtual const VecX& forces(const State&) = 0;  // N; not counted
  virtual Counts counts() const = 0;
};

// The cloth must outlive the simulator. Step 5 stores θ in the hinges of the cloth, so every
// simulator needs its own cloth. Throws std::invalid_argument for a solver or a preconditioner
// that this cloth cannot have, and for XPBD and VBD without a sweep.
std::unique_ptr<Simulator> make_simulator(const Configuration&, Cloth&);

// The longest stable step of symplectic Euler about this state, s: math/stable_step.h.
double critical_step(Simulator&, const Cloth&, const State&);
