// Φ as one vertex sees it: its own inertia, and the elements that it is a corner of.
#pragma once
#include "ways/sweeps.h"

namespace vbd {

struct VertexPotential {
  explicit VertexPotential(const Cloth& cloth) : damped(::damped(cloth)) {
    for_each_family(cloth, [&](const auto& family) {
      auto& of_vertex = corners.emplace_back(size_t(cloth.vertices()));
      for (size_t e = 0; e < family.elements.size(); ++e)
        for (int i = 0; i < family.N; ++i)
          of_vertex[family.elements[e].vertices[i]].push_back({e, i});
    });
  }

  void begin(const Cloth& cloth, double h_, const State& state) {
    h = h_;
    start = state;
    fly(cloth, h, start, flight);
  }

  double inertia(const Cloth& cloth, int i) const { return cloth.mass[3 * i] / (h * h); }
  Vec3 away(const VecX& x, int i) const { return x.segment<3>(3 * i) - flight.segment<3>(3 * i); }

  // Hands every element that reads vertex i to act(family, element, corner).
  template <class Act>
  void for_each_corner(const Cloth& cloth, int i, const Act& act) const {
    auto of_family = corners.begin();
    for_each_family(cloth, [&](const auto& family) {
      for (const Corner& at : (*of_family)[i]) act(family, family.elements[at.element], at.corner);
      ++of_family;
    });
  }

  // Hands every condition of Φ on an element to act(term, condition). Damping is a condition as well, linear
  // in y: with the stiffness kd/h, on how far the element has moved along the ∂C/∂y of x0.
  template <class Family, class Element, class Act>
  void conditions(const Family& family, const Element& element, const VecX& x,
                  const Act& act) const {
    const auto y = gather(element, x);
    family.conditions(element, y, act);
    if (!damped) return;
    const auto y0 = gather(element, start.x);
    family.conditions(element, y0, [&]<class C>(const Term& term, const C& c) {
      Condition<C::M> moved = {0, c.dCdy, c.first};
      for (int m = 0; m < c.M; ++m) moved.C += c.dCdy[m].dot(y[c.first + m] - y0[c.first + m]);
      act(Term(term.kd / h), moved);
    });
  }

  // J
  double at(const Cloth& cloth, const VecX& x, int i) {
    double Phi = 0.5 * inertia(cloth, i) * away(x, i).squaredNorm();
    for_each_corner(cloth, i, [&](const auto& family, const auto& element, int) {
      ++reads.energies;
      conditions(family, element, x,
                 [&](const Term& term, const auto& c) { Phi += 0.5 * term.k * c.C * c.C; });
    });
    return Phi;
  }

  struct Corner {
    size_t element;
    int corner;
  };
  std::vector<std::vector<std::vector<Corner>>> corners;  // of each family and vertex
  bool damped;

  double h = 0;  // s
  State start;
  VecX flight;  // x̃
  Reads reads;
};

}  // namespace vbd
