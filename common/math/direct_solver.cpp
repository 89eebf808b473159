#include "math/direct_solver.h"

#include <Eigen/SparseCholesky>
#include <stdexcept>

#include "math/method.h"
#include "text/machine.h"
#include "text/names.h"
#include "text/text.h"
#ifdef LARGE_STEPS_CHOLMOD
#include <Eigen/CholmodSupport>
#endif

FreeMatrix::FreeMatrix(const BlockMatrix& pattern, const VecX& inverse_mass) {
  int free = 0;
  for (int i = 0; i < pattern.rows(); ++i) number.push_back(inverse_mass[3 * i] > 0 ? free++ : -1);

  std::vector<Eigen::Triplet<double>> entries;
  const auto add = [&](int i, int j) {
    if (number[i] < 0 || number[j] < 0) return;
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c) entries.emplace_back(3 * number[i] + r, 3 * number[j] + c, 0.0);
  };
  for (int i = 0; i < pattern.rows(); ++i) {
    add(i, i);
    for (int s = pattern.row_start[i]; s < pattern.row_start[i + 1]; ++s) add(i, pattern.column[s]);
  }
  values.resize(3 * free, 3 * free);
  values.setFromTriplets(entries.begin(), entries.end());

  for (int i = 0; i < pattern.rows(); ++i) {
    diagonal.push_back(place(values, i, i));
    for (int s = pattern.row_start[i]; s < pattern.row_start[i + 1]; ++s)
      upper.push_back(place(values, i, pattern.column[s]));
  }
}

FreeMatrix::Run FreeMatrix::place(const Eigen::SparseMatrix<double>& A, int i, int j) const {
  if (number[i] < 0 || number[j] < 0) return {-1, -1, -1};
  Run run;
  for (int c = 0; c < 3; ++c) {
    const int column = 3 * number[j] + c;
    const int* first = A.innerIndexPtr() + A.outerIndexPtr()[column];
    const int* last = A.innerIndexPtr() + A.outerIndexPtr()[column + 1];
    run[c] = int(std::lower_bound(first, last, 3 * number[i]) - A.innerIndexPtr());
  }
  return run;
}

void FreeMatrix::copy(const Mat3& block, const Run& run) {
  if (run[0] < 0) return;
  for (int c = 0; c < 3; ++c) Eigen::Map<Vec3>(values.valuePtr() + run[c]) = block.col(c);
}

void FreeMatrix::copy(const BlockMatrix& A) {
  for (size_t i = 0; i < diagonal.size(); ++i) copy(A.diagonal[i], diagonal[i]);
  for (size_t s = 0; s < upper.size(); ++s) copy(A.upper[s], upper[s]);
}

VecX FreeMatrix::restrict(const VecX& b) const {
  VecX free(values.cols());
  for (size_t i = 0; i < number.size(); ++i)
    if (number[i] >= 0) free.segment<3>(3 * number[i]) = b.segment<3>(3 * Eigen::Index(i));
  return free;
}

void FreeMatrix::extend(const VecX& free, VecX& all) const {
  all.setZero();
  for (size_t i = 0; i < number.size(); ++i)
    if (number[i] >= 0) all.segment<3>(3 * Eigen::Index(i)) = free.segment<3>(3 * number[i]);
}

namespace {

// Where every vertex is pinned there is nothing to solve. CHOLMOD has no factors of a 0 × 0 matrix.
class NothingFree : public DirectSolver {
 public:
  bool factorise_and_solve(const BlockMatrix&, const VecX&, VecX& dv) override {
    dv.setZero();
    return true;
  }
};

class SparseLdlt : public DirectSolver {
 public:
  SparseLdlt(const BlockMatrix& pattern, const VecX& inverse_mass) : free(pattern, inverse_mass) {
    ldlt.analyzePattern(free.values);
  }
  bool factorise_and_solve(const BlockMatrix& A, const VecX& b, VecX& dv) override {
    free.copy(A);
    ldlt.factorize(free.values);
    dv.setZero();
    if (ldlt.info() == Eigen::Success) free.extend(ldlt.solve(free.restrict(b)), dv);
    return ldlt.info() == Eigen::Success && (ldlt.vectorD().array() > 0).all();
  }

 private:
  FreeMatrix free;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Upper> ldlt;
};

class DenseInverse : public DirectSolver {
 public:
  DenseInverse(const BlockMatrix& pattern, const VecX& inverse_mass) : free(pattern, inverse_mass) {
    const double n = double(free.values.cols()), needed = 4 * 8 * n * n;  // A, LDLᵀ, LU, A⁻¹
    const double memory = physical_memory();
    if (needed > 0.5 * memory)
      throw std::invalid_argument(text(
          "--solver inverse would need %.3g GB for the dense inverse of %.0f unknowns; half of "
          "this machine's memory is %.3g GB: use --solver ldlt or fewer cells",
          needed / 1e9, n, 0.5 * memory / 1e9));
  }
  bool factorise_and_solve(const BlockMatrix& A, const VecX& b, VecX& dv) override {
    free.copy(A);
    const Eigen::MatrixXd dense = Eigen::MatrixXd(free.values).selfadjointView<Eigen::Upper>();
    const Eigen::LDLT<Eigen::MatrixXd> factors(dense);
    const Eigen::MatrixXd inverse = dense.inverse();
    free.extend(inverse * free.restrict(b), dv);
    return factors.isPositive();
  }

 private:
  FreeMatrix free;
};

#ifdef LARGE_STEPS_CHOLMOD
class Cholmod : public DirectSolver {
 public:
  Cholmod(const BlockMatrix& pattern, const VecX& inverse_mass) : free(pattern, inverse_mass) {
    cholesky.cholmod().print = 0;
    cholesky.analyzePattern(free.values);
    check_memory();
  }
  bool factorise_and_solve(const BlockMatrix& A, const VecX& b, VecX& dv) override {
    free.copy(A);
    cholesky.factorize(free.values);
    check_memory();
    const bool definite = cholesky.info() == Eigen::Success;
    const VecX rest = free.restrict(b);
    free.extend(definite ? VecX(cholesky.solve(rest)) : indefinite(rest), dv);
    return definite;
  }

 private:
  // Eigen takes a lack of memory for an indefinite matrix.
  void check_memory() {
    if (cholesky.cholmod().status == CHOLMOD_OUT_OF_MEMORY) throw std::bad_alloc();
  }

  // Cholesky has no factors of an indefinite matrix; LDLᵀ has.
  VecX indefinite(const VecX& b) const {
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Upper> ldlt(free.values);
    return ldlt.info() == Eigen::Success ? VecX(ldlt.solve(b)) : VecX::Zero(b.size());
  }

  FreeMatrix free;
  Eigen::CholmodSupernodalLLT<Eigen::SparseMatrix<double>, Eigen::Upper> cholesky;
};
#endif

}  // namespace

std::unique_ptr<DirectSolver> make_direct_solver(const std::string& name,
                                                 const BlockMatrix& pattern,
                                                 const VecX& inverse_mass) {
  if (inverse_mass.isZero(0)) return std::make_unique<NothingFree>();
  if (name == "ldlt") return std::make_unique<SparseLdlt>(pattern, inverse_mass);
  if (name == "inverse") return std::make_unique<DenseInverse>(pattern, inverse_mass);
#ifdef LARGE_STEPS_CHOLMOD
  if (name == "cholmod") return std::make_unique<Cholmod>(pattern, inverse_mass);
#else
  if (name == "cholmod")
    throw std::invalid_argument(
        "--solver cholmod: this program was built without it; install libsuitesparse-dev and "
        "configure again, or use --solver ldlt");
#endif
  throw std::invalid_argument("--solver " + name + ": must be " + choices(solver_names));
}
