#include "math/preconditioner.h"

#include <stdexcept>

#include "math/incomplete_cholesky.h"
#include "math/method.h"
#include "math/multigrid.h"
#include "text/names.h"

namespace {

// Divides by one number, the mean of the diagonal of A: s has its unit, and the direction of r.
class NoPreconditioner : public Preconditioner {
 public:
  void set(const BlockMatrix& A) override {
    double trace = 0;
    for (const Mat3& block : A.diagonal) trace += block.trace();
    mean = trace / (3 * A.rows());
  }
  void apply(const VecX& r, VecX& s) override { s = r / mean; }

 private:
  double mean = 1;
};

// Divides by the diagonal of A.
class Jacobi : public Preconditioner {
 public:
  void set(const BlockMatrix& A) override {
    diagonal.resize(3 * A.rows());
    for (int i = 0; i < A.rows(); ++i) diagonal.segment<3>(3 * i) = A.diagonal[i].diagonal();
  }
  void apply(const VecX& r, VecX& s) override { s = r.cwiseQuotient(diagonal); }

 private:
  VecX diagonal;
};

// Divides by the 3 × 3 diagonal blocks of A; at a pin by S A_ii S + I − S.
class BlockJacobi : public Preconditioner {
 public:
  explicit BlockJacobi(const std::vector<Pin>& pins_) : pins(pins_) {}
  void set(const BlockMatrix& A) override {
    inverse.resize(A.diagonal.size());
    for (size_t i = 0; i < inverse.size(); ++i) inverse[i] = inverse_of(A.diagonal[i]);
    for (const Pin& pin : pins)
      inverse[pin.vertex] =
          inverse_of(pin.S * A.diagonal[pin.vertex] * pin.S + Mat3::Identity() - pin.S);
  }
  void apply(const VecX& r, VecX& s) override {
    s.resize(r.size());
    for (int i = 0; i < int(inverse.size()); ++i)
      s.segment<3>(3 * i) = inverse[i] * r.segment<3>(3 * i);
  }

 private:
  std::vector<Pin> pins;
  std::vector<Mat3> inverse;
};

}  // namespace

std::unique_ptr<Preconditioner> make_preconditioner(const std::string& name,
                                                    const BlockMatrix& pattern,
                                                    const std::vector<Pin>& pins,
                                                    const std::optional<Grid>& grid) {
  if (name == "none") return std::make_unique<NoPreconditioner>();
  if (name == "jacobi") return std::make_unique<Jacobi>();
  if (name == "block") return std::make_unique<BlockJacobi>(pins);
  if (name == "ic") return std::make_unique<IncompleteCholesky>(pattern, pins);
  if (name != "multigrid")
    throw std::invalid_argument("--preconditioner " + name + ": must be " +
                                choices(preconditioner_names));
  return std::make_unique<Multigrid>(pattern, pins, grid);
}
