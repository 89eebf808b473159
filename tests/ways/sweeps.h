// What the two ways share that sweep over the cloth: XPBD over its conditions, VBD over its vertices. Both
// are ways to solve the step of backward Euler that steps 3 to 5 solve with one matrix. In positions:
//
//   Φ(x) = 1/(2h²) |x − x̃|²_M + E(x) → min,   x̃ = x0 + h v0 + h² g,   v = (x − x0)/h
//
// E is the energy of the conditions alone: gravity stands in x̃.
#pragma once
#include "math/cloth.h"

// ∂y_m/∂x_i, the same for all three coordinates.
template <int N, int Y>
double weight(const Element<N, Y>& element, int m, int i) {
  return element.weight(m, i);
}
template <int N>
double weight(const VertexElement<N>&, int m, int i) {
  return m == i ? 1 : 0;
}

// ∂C/∂x_i = Σ_m weight(m, i) ∂C/∂y_m
template <class Element, class Condition>
Vec3 gradient(const Element& element, const Condition& c, int i) {
  Vec3 dCdx = Vec3::Zero();
  for (int m = 0; m < c.M; ++m) dCdx += weight(element, c.first + m, i) * c.dCdy[m];
  return dCdx;
}

// S of every vertex, which projects on the directions that its pin leaves free.
inline std::vector<Mat3> free_directions(const Cloth& cloth) {
  std::vector<Mat3> S(size_t(cloth.vertices()), Mat3::Identity());
  for (const Pin& pin : cloth.pins) S[size_t(pin.vertex)] = pin.S;
  return S;
}

// x̃: where the cloth flies if no condition acts. A vertex goes where its pin moves.
inline void fly(const Cloth& cloth, double h, const State& start, VecX& x) {
  x = start.x + h * start.v;
  if (cloth.gravity)
    for (int i = 0; i < cloth.vertices(); ++i) x.segment<3>(3 * i) += h * h * *cloth.gravity;
  for (const Pin& pin : cloth.pins) {
    const Vec3 x0 = start.x.segment<3>(3 * pin.vertex), x1 = x.segment<3>(3 * pin.vertex);
    x.segment<3>(3 * pin.vertex) = x0 + h * pin.held((x1 - x0) / h);
  }
}

// f = M g − Σ (k C + kd Ċ) ∂C/∂x, N
inline void forces(const Cloth& cloth, const State& state, VecX& f) {
  f.setZero(cloth.mass.size());
  if (cloth.gravity)
    for (int i = 0; i < cloth.vertices(); ++i)
      f.segment<3>(3 * i) = cloth.mass[3 * i] * *cloth.gravity;
  for_each_family(cloth, [&]<class Family>(const Family& family) {
    for (const auto& element : family.elements) {
      const auto y = gather(element, state.x), ydot = gather(element, state.v);
      auto f_y = zero_vectors<Family::Y>();
      family.conditions(element, y, [&](const Term& term, const auto& c) {
        double Cdot = 0;
        for (int m = 0; m < c.M; ++m) Cdot += c.dCdy[m].dot(ydot[c.first + m]);
        for (int m = 0; m < c.M; ++m)
          f_y[c.first + m] -= (term.k * c.C + term.kd * Cdot) * c.dCdy[m];
      });
      scatter(element, f_y, f);
    }
  });
}

// How often a way has read an element: for its forces, or for its energy alone.
struct Reads {
  long forces = 0, energies = 0;
};
