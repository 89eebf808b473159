// Derivatives against differences, the test on which all forces rest.
//
//   f'(x) = (f(x + h d) − f(x − h d)) / 2h + O(h²)
//
// A small error at one h proves little: a generous tolerance hides a small wrong term. Here the
// error must fall by 100 for each ten times smaller h, until the rounding of f, divided by h,
// covers it. The error of a wrong term does not fall.
#pragma once
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>

#include "math/types.h"

using MatX = Eigen::MatrixXd;
using Function = std::function<VecX(const VecX&)>;
using Slope = std::function<MatX(const VecX&)>;  // slope(i, j) = ∂f_i/∂x_j

// The largest error over all coordinates of central differences of width h, where it occurs and how
// much of it may be rounding.
struct DifferenceError {
  double value = 0;
  Eigen::Index row = 0, column = 0;
  double rounding = 0;
};

inline DifferenceError difference_error(const Function& f, const Slope& slope, const VecX& x,
                                        double h) {
  const VecX y = f(x);
  const MatX exact = slope(x);
  MatX error = exact;
  for (Eigen::Index j = 0; j < x.size(); ++j) {
    VecX ahead = x, behind = x;
    ahead[j] += h;
    behind[j] -= h;
    error.col(j) -= (f(ahead) - f(behind)) / (ahead[j] - behind[j]);
  }
  // The size of the numbers that f rounds to 16 digits: its values, and x times its slope.
  const double size =
      y.cwiseAbs().maxCoeff() + exact.cwiseAbs().maxCoeff() * (x.cwiseAbs().maxCoeff() + h);
  DifferenceError result;
  result.value = error.cwiseAbs().maxCoeff(&result.row, &result.column);
  result.rounding = 16 * std::numeric_limits<double>::epsilon() * size / h;
  return result;
}

// How fast the error falls from width h to h/10: 2 for central differences of a right derivative, 0
// where the derivative is wrong.
inline double order(const Function& f, const Slope& slope, const VecX& x, double h) {
  return std::log10(difference_error(f, slope, x, h).value /
                    difference_error(f, slope, x, h / 10).value);
}

// True if the error of central differences falls with order 2 down to rounding. `length` is the
// scale on which f changes, for instance |w| for w/|w|; the widest step is a hundredth of it. Not
// for an x at a minimum of f: there f is a square and rounds worse than its slope shows.
inline testing::AssertionResult is_slope(const Function& f, const Slope& slope, const VecX& x,
                                         double length) {
  double h = length / 100;
  DifferenceError wide = difference_error(f, slope, x, h);
  for (int i = 0; i < 5; ++i) {
    const DifferenceError narrow = difference_error(f, slope, x, h / 10);
    // Not < but "not ≤", so that NaN fails.
    if (!(narrow.value <= std::max(wide.value / 80, narrow.rounding)))
      return testing::AssertionFailure()
             << "slope(" << narrow.row << ", " << narrow.column << ") is off by " << narrow.value
             << " at width " << h / 10 << ", and was by " << wide.value << " at width " << h
             << "; rounding explains " << narrow.rounding;
    wide = narrow;
    h /= 10;
  }
  return testing::AssertionSuccess();
}
