// Preconditioners for conjugate gradients: s = P⁻¹ r with a symmetric positive definite P that is near
// A and cheap to divide by. P⁻¹ maps the directions that the pins leave free onto themselves: P of
// "block", "ic" and "multigrid" is the identity in the directions that a pin holds, and P of "none" is a
// number. P of "jacobi" is diagonal: it does so only if the directions of the pin are along x, y and z.
#pragma once
#include <Eigen/Cholesky>
#include <memory>
#include <optional>
#include <string>

#include "math/block_matrix.h"
#include "math/grid.h"
#include "math/pin.h"

class Preconditioner {
 public:
  virtual ~Preconditioner() = default;

  virtual void set(const BlockMatrix& A) = 0;      // before the solves with A
  virtual void apply(const VecX& r, VecX& s) = 0;  // s = P⁻¹ r
};

// B⁻¹ of a block of A, by pivots. A flap that is almost a line makes B 1e12 times as stiff in one direction
// as in another. The cofactors of B.inverse() then lose all digits, and their B⁻¹ is not positive definite.
inline Mat3 inverse_of(const Mat3& B) {
  return B.ldlt().solve(Mat3::Identity());
}

// "none": one number. "jacobi": the diagonal of A. "block": its 3 × 3 diagonal blocks.
// "ic": incomplete_cholesky.h. "multigrid": multigrid.h. Throws std::invalid_argument for any other name.
std::unique_ptr<Preconditioner> make_preconditioner(const std::string& name,
                                                    const BlockMatrix& pattern,
                                                    const std::vector<Pin>& pins,
                                                    const std::optional<Grid>& grid);
