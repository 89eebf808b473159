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

template <class Family>
MatX weights(const Family&, const typename decltype(Family::elements)::value_type& e,
             Eigen::Index n) {
  MatX W = MatX::Zero(3 * Family::Y, n);
  for (int m = 0; m < Family::Y; ++m)
    for (int i = 0; i < Family::N; ++i)
      W.block<3, 3>(3 * m, 3 * e.vertices[i]).diagonal().setConstant(weight(e, m, i));
  return W;
}

// y = W x, so that g = Wᵀ ∂C/∂y and H = Wᵀ ∂²C/∂y² W.
template <class Family>
void add_dense_conditions(const Family& family, const VecX& x, std::vector<DenseCondition>& all) {
  for (const auto& e : family.elements) {
    const MatX W = weights(family, e, x.size());
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
      all.push_back({term, c.C, W.transpose() * gy, product({W.transpose(), Hy, W})});
    });
  }
}

// The positive part of a symmetric matrix.
MatX positive(const MatX& T) {
  const auto [values, vectors] = eigenpairs(T);
  return product({vectors, values.cwiseMax(0).asDiagonal(), vectors.transpose()});
}

template <class Family>
void add_dense_tension(const Family& family, const VecX& x, MatX& K) {
  constexpr int Y = Family::Y;
  if (Y > 2) return;  // the y span space
  for (const auto& e : family.elements) {
    const MatX W = weights(family, e, x.size());
    const MatX y = (W * x).reshaped(3, Y);
    MatX S = MatX::Zero(3 * Y, 3 * Y);
    family.conditions(e, gather(e, x), [&](const Term& term, const auto& c) {
      const auto block = c.second();
      for (int m = 0; m < c.M; ++m)
        for (int n = 0; n < c.M; ++n)
          S.block<3, 3>(3 * (c.first + m), 3 * (c.first + n)) += term.k * c.C * block[m][n];
    });
    const MatX directions = eigenpairs(product({y, y.transpose()})).vectors.leftCols(3 - Y);
    for (int d = 0; d < 3 - Y; ++d) {
      MatX N = MatX::Zero(3 * Y, Y);  // the direction, for each y
      for (int m = 0; m < Y; ++m) N.block(3 * m, m, 3, 1) = directions.col(d);
      const MatX T = product({N.transpose(), S, N});
      K += product({W.transpose(), N, positive(T), N.transpose(), W});
    }
  }
}

}  // namespace

MatX dense_tension(const Cloth& cloth, const VecX& x) {
  MatX K = MatX::Zero(x.size(), x.size());
  for_each_family(cloth, [&](const auto& family) { add_dense_tension(family, x, K); });
  return K;
}

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
