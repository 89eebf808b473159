// [short_edge]: a net of springs that shortens, as wet wool does. Each wants to lose a share of its length.
//
//   C = √q (|y| − (1 − shortening) L),        y = x_0 − x_1
//
// L is the length at rest, m. √q, the sqrt_share of a spring, is 1, but on the boundary of the cloth, where a
// spring stands for half as much cloth. Your shortening stands in short_edge_numbers.h.
#pragma once
#include "inventions/short_edge_numbers.h"
#include "math/spring.h"

struct ShortEdge : Condition<1> {
  // C and its dCdy.
  ShortEdge(const Spring& s, const Vec3& y_)
      : sqrt_share(s.sqrt_share), rest_length(s.rest_length), y(y_) {
    not_written("D1.4", "ShortEdge::ShortEdge");
  }

  // ∂²C/∂y²
  Mats<1> second() const { not_written("D1.4", "ShortEdge::second"); }

  // The number c in ∂²C/∂y² = c P, with the matrix P of `across` in math/spring.h: see math/tension.h
  Square<1> across() const { not_written("D1.4", "ShortEdge::across"); }

  double sqrt_share;
  double rest_length;  // m
  Vec3 y;              // m
};

// It acts beside [spring], or in its place: then along the edges of the cells.
struct ShortEdgeTerm : Term {
  using Term::Term;
  static constexpr TermInfo info = {.table = "short_edge", .in_plane = InPlane::springs};

  template <class Act>
  void conditions(const Spring& s, const Vecs<1>& y, const Act& act) const {
    act(*this, ShortEdge(s, y[0]));
  }
};
