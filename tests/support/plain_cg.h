// Conjugate gradients as in the textbooks (Hestenes & Stiefel 1952): no pins, no preconditioner.
#pragma once
#include "math/block_matrix.h"

// Solves A x = b for a symmetric positive definite A, from the x given; returns the iterations.
inline int conjugate_gradients(const BlockMatrix& A, const VecX& b, double tolerance, VecX& x) {
  VecX q;
  A.multiply(x, q);
  VecX r = b - q;  // the residual of x: the direction downhill
  VecX p = r;      // the direction of the step: downhill, but conjugate to those before
  int iterations = 0;
  for (; r.norm() > tolerance * b.norm(); ++iterations) {
    A.multiply(p, q);
    const double rr = r.dot(r);
    const double alpha = rr / p.dot(q);  // the step goes to the lowest point along p
    x += alpha * p;
    r -= alpha * q;
    const double beta = r.dot(r) / rr;
    p = r + beta * p;
  }
  return iterations;
}
