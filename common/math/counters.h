// The counts of an implicit step. No count ends a run; the report names every count above zero.
#pragma once

struct Counters {
  long iterations = 0;   // of conjugate gradients
  long indefinite = 0;   // systems with cᵀA c ≤ 0 or a pivot that is not positive
  long capped = 0;       // systems in which conjugate gradients reached the limit of iterations
  long redone = 0;       // plain steps that gained energy and were taken again by Newton's method
  long unconverged = 0;  // steps in which Newton's method did not converge
};
