#include "support/statics.h"

#include <Eigen/SparseCholesky>
#include <stdexcept>

#include "math/energy.h"
#include "step05_bend/time_step.h"

Sparse sparse(const BlockMatrix& A) {
  std::vector<Eigen::Triplet<double>> entries;
  const auto add = [&](int i, int j, const Mat3& B) {
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b) entries.emplace_back(3 * i + a, 3 * j + b, B(a, b));
  };
  for (int i = 0; i < A.rows(); ++i) {
    add(i, i, A.diagonal[i]);
    for (int s = A.row_start[i]; s < A.row_start[i + 1]; ++s) {
      add(i, A.column[s], A.upper[s]);
      add(A.column[s], i, A.upper[s].transpose());
    }
  }
  Sparse all(3 * A.rows(), 3 * A.rows());
  all.setFromTriplets(entries.begin(), entries.end());
  return all;
}

Sparse freedom(Eigen::Index coordinates, const std::vector<std::vector<int>>& unknowns) {
  std::vector<Eigen::Triplet<double>> entries;
  for (size_t q = 0; q < unknowns.size(); ++q)
    for (const int i : unknowns[q]) entries.emplace_back(i, int(q), 1);
  Sparse P(coordinates, Eigen::Index(unknowns.size()));
  P.setFromTriplets(entries.begin(), entries.end());
  return P;
}

Statics::Statics(const Cloth& cloth)
    : cloth_(cloth),
      system_(std::make_unique<step05::System>(cloth, Method{.jacobian = Jacobian::bw98})) {}
Statics::~Statics() = default;

void Statics::evaluate(const VecX& x) {
  step05::forces(cloth_, {x, VecX::Zero(x.size())}, *system_);
  f = system_->f;
  K = -sparse(system_->K);
}

VecX equilibrium(const Cloth& cloth, const Sparse& P, VecX x) {
  Statics statics(cloth);
  Sparse I(P.cols(), P.cols());
  I.setIdentity();
  for (int iteration = 0; iteration < 1000; ++iteration) {
    statics.evaluate(x);
    const Sparse K = P.transpose() * statics.K * P;
    Eigen::SimplicialLLT<Sparse> solver(K);
    const bool definite = solver.info() == Eigen::Success;
    for (double shift = 1e-6; solver.info() != Eigen::Success; shift *= 4)
      solver.compute(K + shift * K.diagonal().maxCoeff() * I);
    VecX dx = P * solver.solve(P.transpose() * statics.f);
    if (definite && dx.cwiseAbs().maxCoeff() < 1e-9) return x + dx;
    const double E = potential_energy(cloth, x);
    while (potential_energy(cloth, x + dx) > E + 1e-13 * std::abs(E)) dx /= 2;
    x += dx;
  }
  throw std::runtime_error("no equilibrium was found");
}
