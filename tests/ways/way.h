// Every way that the five steps offer to move a cloth, behind one interface: for programs that compare
// them. The steps' own time_step.h does the work, compiled once, in ways.cpp.
#pragma once
#include <memory>

#include "math/cloth.h"
#include "math/method.h"
#include "scene/step_names.h"

struct Way {
  int step = 1;        // 1 … 5
  Method method = {};  // of steps 3 to 5; what the step has no concept of is ignored
};

inline const char* program_of(int step) {
  return step_names()[step - 1].c_str();
}

// What a simulation has cost so far. All of it is counted where it happens, the same on every machine.
struct Counts {
  long forces = 0;    // evaluations of all forces; in steps 3 to 5 their derivatives come with them
  long energies = 0;  // evaluations of the potential energy, by Newton's line search
  long assemblies = 0;  // systems A Δv = b set up
  long products = 0;    // of A, K or D and a vector
  // Read and written, every array once in every pass over it: elements, vectors and matrices. Not what goes
  // on inside a preconditioner or a direct solver, nor the vectors of Newton's line search.
  long bytes = 0;

  long iterations = 0;   // of conjugate gradients
  long indefinite = 0;   // systems that were not positive definite
  long capped = 0;       // systems in which conjugate gradients reached their most iterations
  long unconverged = 0;  // steps in which Newton's method did not converge
};

class Simulator {
 public:
  virtual ~Simulator() = default;

  virtual void step(double h, State&) = 0;
  virtual const VecX& forces(const State&) = 0;  // N; not counted
  virtual Counts counts() const = 0;
};

// The cloth must outlive the simulator, and from step 5 on it remembers its folds: a cloth serves one
// simulator. Throws std::invalid_argument for a solver or a preconditioner that this cloth cannot have.
std::unique_ptr<Simulator> make_simulator(const Way&, Cloth&);

// The longest stable step of symplectic Euler about this state, s: math/stable_step.h.
double critical_step(Simulator&, const Cloth&, const State&);
