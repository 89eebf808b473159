// Preconditioners for conjugate gradients: s = P⁻¹ r with a symmetric positive definite P that is near
// A and cheap to divide by. In the directions that a pin holds every P but Jacobi's is one, so that P⁻¹
// maps the directions that the pins leave free onto themselves. Jacobi's has no oblique directions.
#pragma once
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

// "none": one number, "jacobi": the diagonal of A, "block": its 3 × 3 diagonal blocks, "ic": incomplete_cholesky.h,
// "multigrid": multigrid.h. Throws std::invalid_argument for another name, and for multigrid on what is
// not a grid that can be halved (with what to use instead).
std::unique_ptr<Preconditioner> make_preconditioner(const std::string& name,
                                                    const BlockMatrix& pattern,
                                                    const std::vector<Pin>& pins,
                                                    const std::optional<Grid>& grid);
