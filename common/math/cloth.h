// The cloth as the time steps see it: masses, pins, gravity, and families of elements. A part that
// the scene does not name is empty.
#pragma once
#include <algorithm>
#include <stdexcept>
#include <utility>

#include "math/grid.h"
#include "math/hinge.h"
#include "math/linear_membrane.h"
#include "math/membrane.h"
#include "math/pin.h"
#include "math/quadratic_bend.h"
#include "math/spring.h"
#include "math/triangle.h"

// All terms, by the elements that they act on.
using Triangles =
    Family<Triangle, StretchTerm, ShearTerm, Membrane<Stvk>, LinearMembrane, Membrane<Corotated>,
           Membrane<Arap>, Membrane<NeoHookean>, Membrane<NeoHookeanBarrier>>;
using Springs = Family<Spring, SpringTerm>;
using Hinges = Family<Hinge, DihedralBend, BridsonBend>;
using QuadraticHinges = Family<QuadraticHinge, QuadraticBend>;
using BendSprings = Family<Spring, SpringBend>;

struct Families {
  Triangles triangles;
  Springs springs;
  Hinges hinges;
  QuadraticHinges quadratic_hinges;
  BendSprings bend_springs;

  // The place of a term in its family.
  template <class T>
  std::optional<T>& term();
  template <class T>
  const std::optional<T>& term() const;
};

struct Cloth : Families {
  VecX mass;                    // kg, one entry per coordinate
  VecX inverse_mass;            // 1/kg, zero where a pin holds all of the vertex
  std::vector<Pin> pins;        // at most one to a vertex
  std::optional<Vec3> gravity;  // m/s²
  std::optional<Grid> grid;     // if the cloth is a grid

  int vertices() const { return int(mass.size()) / 3; }
};

struct State {
  VecX x;  // m
  VecX v;  // m/s
};

// Hands every family to act(family). AnyFamilies: a Cloth, const or not, or its Families alone.
template <class AnyFamilies, class Act>
void for_each_family(AnyFamilies& cloth, const Act& act) {
  act(cloth.triangles);
  act(cloth.springs);
  act(cloth.hinges);
  act(cloth.quadratic_hinges);
  act(cloth.bend_springs);
}

// Hands every term, present or not, to act(term).
template <class AnyFamilies, class Act>
void for_each_term(AnyFamilies& cloth, const Act& act) {
  for_each_family(cloth, [&](auto& family) { family.for_each_term(act); });
}

template <class T>
const std::optional<T>& Families::term() const {
  const std::optional<T>* place = nullptr;
  for_each_family(*this, [&]<class Family>(const Family& family) {
    if constexpr (Family::template lists<T>) place = &family.template term<T>();
  });
  if (!place) throw std::logic_error("no family of math/cloth.h lists this term");
  return *place;
}

template <class T>
std::optional<T>& Families::term() {
  return const_cast<std::optional<T>&>(std::as_const(*this).term<T>());
}

// The TermInfo of every term, in the order of the lists.
inline std::vector<TermInfo> term_infos() {
  std::vector<TermInfo> infos;
  const Families none;
  for_each_term(none, [&]<class T>(const std::optional<T>&) { infos.push_back(T::info); });
  return infos;
}

// Tells the terms that remember their start the positions at the start.
inline void start_terms(Cloth& cloth, const VecX& x) {
  for_each_family(cloth, [&](auto& family) {
    family.for_each_term([&](auto& term) {
      if constexpr (requires { term->start_at(family.elements, x); })
        if (term) term->start_at(family.elements, x);
    });
  });
}

// The first step that teaches all terms of a cloth.
inline int first_step_of(const Cloth& cloth) {
  int step = 1;
  for_each_term(cloth, [&]<class T>(const std::optional<T>& term) {
    if (term) step = std::max(step, T::info.first_step);
  });
  return step;
}

// True if the damping of any term takes energy.
inline bool damped(const Cloth& cloth) {
  bool damped = false;
  for_each_term(cloth, [&](const auto& term) { damped = damped || (term && term->kd > 0); });
  return damped;
}
