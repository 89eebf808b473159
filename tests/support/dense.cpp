#include "support/dense.h"

#include "step03_implicit/time_step.h"

MatX dense(const BlockMatrix& A) {
  MatX full = MatX::Zero(3 * A.rows(), 3 * A.rows());
  for (int i = 0; i < A.rows(); ++i) {
    full.block<3, 3>(3 * i, 3 * i) = A.diagonal[i];
    for (int s = A.row_start[i]; s < A.row_start[i + 1]; ++s) {
      full.block<3, 3>(3 * i, 3 * A.column[s]) = A.upper[s];
      full.block<3, 3>(3 * A.column[s], 3 * i) = A.upper[s].transpose();
    }
  }
  return full;
}

namespace {

// ∂y_m/∂x_i. The y of a hinge are its vertices. That y is relative to P0 changes no C.
template <class Element>
double weight(const Element& e, int m, int i) {
  return e.weight(m, i);
}
double weight(const Hinge&, int m, int i) {
  return m == i ? 1 : 0;
}

// y = W x, so that g = Wᵀ ∂C/∂y and H = Wᵀ ∂²C/∂y² W.
template <class Family>
void add_dense_conditions(const Family& family, const VecX& x, std::vector<DenseCondition>& all) {
  for (const auto& e : family.elements) {
    MatX W = MatX::Zero(3 * Family::Y, x.size());
    for (int m = 0; m < Family::Y; ++m)
      for (int i = 0; i < Family::N; ++i)
        W.block<3, 3>(3 * m, 3 * e.vertices[i]).diagonal().setConstant(weight(e, m, i));
    const VecX flat = W * x;
    Vecs<Family::Y> y;
    for (int m = 0; m < Family::Y; ++m) y[m] = flat.segment<3>(3 * m);
    family.conditions(e, y, [&](const Term& term, const auto& c) {
      const auto block = c.second();
      VecX gy = VecX::Zero(flat.size());
      MatX Hy = MatX::Zero(flat.size(), flat.size());
      for (int m = 0; m < int(c.dCdy.size()); ++m) {
        gy.segment<3>(3 * (c.first + m)) = c.dCdy[m];
        for (int n = 0; n < int(c.dCdy.size()); ++n)
          Hy.block<3, 3>(3 * (c.first + m), 3 * (c.first + n)) = block[m][n];
      }
      all.push_back({term, c.convex, c.C, W.transpose() * gy, product({W.transpose(), Hy, W})});
    });
  }
}

}  // namespace

std::vector<DenseCondition> dense_conditions(const Cloth& cloth, const VecX& x) {
  std::vector<DenseCondition> all;
  for_each_family(cloth, [&](const auto& family) { add_dense_conditions(family, x, all); });
  return all;
}

Cloth rich_cloth(const Mesh& mesh) {
  Model model;
  model.add(StretchTerm(100, 2));
  model.add(ShearTerm(40, 3));
  Cloth cloth = make_cloth(mesh, model);
  const int last = cloth.vertices() - 1;
  cloth.term<SpringTerm>() = SpringTerm(30, 1);
  cloth.springs.elements = {make_spring(0, last, 1.2), make_spring(last - 1, 1, 0.4, 0.7)};
  return cloth;
}

Mesh small_grid() {
  return make_grid({1, 1}, {2, 2}, Diagonals::alternating);
}

State disturbed(const Mesh& mesh, double size, Random& random) {
  const int n = int(mesh.x.size());
  return {mesh.x + random.vector(n, size), random.vector(n, 2)};
}

Evaluated evaluate(const Cloth& cloth, const State& state, Jacobian jacobian) {
  Method method;
  method.jacobian = jacobian;
  step03::System system(cloth, method);
  step03::forces(cloth, state, system);
  const MatX none = MatX::Zero(state.x.size(), state.x.size());
  return {system.f, dense(system.K), system.D.empty() ? none : dense(system.D)};
}

double relative(const MatX& a, const MatX& b) {
  return (a - b).norm() / b.norm();
}
