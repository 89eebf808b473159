// What every check needs: comparisons that explain themselves, and random numbers.
#pragma once
#include <gtest/gtest.h>

#include "support/differences.h"
#include "support/poses.h"

// The seed of the random numbers of a check, from the variable CHECK_SEED. Hidden checks have other seeds.
unsigned seed();

// Empty if `got` agrees with `expected` to `tolerance`. Otherwise a sentence: where they differ most, by how
// much, and whether a factor or a transposition explains the difference.
std::string disagreement(const MatX& got, const MatX& expected, double tolerance);
inline std::string disagreement(double got, double expected, double tolerance) {
  return disagreement(MatX::Constant(1, 1, got), MatX::Constant(1, 1, expected), tolerance);
}

// Fails with "WHAT: expected …, got …". WHAT names the number and the case.
#define AGREES(what, got, expected, tolerance)                                                    \
  if (const std::string difference = disagreement(got, expected, tolerance); !difference.empty()) \
  FAIL() << (what) << ": " << difference

// Fails with "WHAT" unless the condition holds.
#define HOLDS(what, condition) \
  if (!(condition)) FAIL() << (what)

// The slope of f at x by central differences, with the error h² f'''/6 removed: error O(h⁴).
MatX slope_of(const Function& f, const VecX& x, double h);

inline VecX one_number(double value) {
  return VecX::Constant(1, value);
}

// The positions of a vertex list as one vector, and back.
template <size_t N>
VecX joined(const std::array<Vec3, N>& vectors) {
  VecX all(3 * N);
  for (size_t i = 0; i < N; ++i) all.segment<3>(3 * Eigen::Index(i)) = vectors[i];
  return all;
}
template <int N>
Vecs<N> split(const VecX& all) {
  Vecs<N> vectors;
  for (int i = 0; i < N; ++i) vectors[i] = all.segment<3>(3 * i);
  return vectors;
}
