// A spring between two vertices: the smallest condition, and the cloth of mass-spring models.
#pragma once
#include <utility>

#include "math/family.h"

// y = x_0 − x_1, the only vector that a spring reads.
struct Spring : Element<2, 1> {
  static constexpr std::string_view plural = "springs";
  double rest_length;     // m
  double sqrt_share = 1;  // √s, where s k is the stiffness of this spring
};

inline Spring make_spring(int i, int j, double rest_length, double share = 1) {
  Spring s;
  s.vertices = {i, j};
  s.weight << 1, -1;
  s.rest_length = rest_length;
  s.sqrt_share = std::sqrt(share);
  return s;
}

//   C = √s (|y| − L),   ∂C/∂y = √s n,   n = y/|y|,   E = s k/2 (|y| − L)²
//
// The length is smoothed as that of a thread. A spring without length at rest takes 1 m for it.
struct Elongation : Condition<1> {
  Elongation(const Spring& s, const Vec3& y)
      : sqrt_share(s.sqrt_share), length(y, s.rest_length > 0 ? s.rest_length : 1) {
    C = sqrt_share * (length.value - s.rest_length);
    dCdy = {sqrt_share * length.n};
  }

  // ∂²C/∂y² = √s (I − n nᵀ)/|y|
  Mats<1> second() const { return {{{sqrt_share * length.second_derivative()}}}; }
  Square<1> across() const { return Square<1>::Ones(); }

  double sqrt_share;
  Length length;
};

// P = ∂²C/∂y²: all of it acts across the spring (math/tension.h).
inline Mat3 across(const Spring& s, const Vecs<1>& y) {
  return Elongation(s, y[0]).second()[0][0];
}

// [spring]: the springs that are the cloth itself. k acts along the edges of the cells of a grid, or along
// the edges of the triangles of a mesh (scene/spring_net.h).
struct SpringTerm : Term {
  using Term::Term;
  static constexpr TermInfo info = {.table = "spring", .in_plane = InPlane::springs};
  static constexpr std::array<const char*, 5> keys = {"k", "shear", "apart", "net", "diagonals"};

  template <class Table>
  void read(const Table& table) {
    k = table.positive("k");
    if (table.has("shear")) shear = table.not_negative("shear");
    if (table.has("apart")) apart = table.not_negative("apart");
    if (table.has("net")) on_grid = table.one_of("net", {"grid", "mesh"}) == "grid";
    if (table.has("diagonals")) both_diagonals = table.one_of("diagonals", {"one", "two"}) == "two";
    if (on_grid) return;
    for (const char* key : {"shear", "diagonals"})
      if (table.has(key)) table.refuse(key, "only the net of a grid has it; take it out");
  }
  std::vector<std::pair<const char*, double>> stiffnesses() const {
    return {{"k", k}, {"shear", shear}, {"apart", apart}};
  }

  // The key that only a grid can have; null where any mesh will do.
  const char* needs_grid() const { return shear > 0 ? "shear" : nullptr; }

  double shear = 0;  // N/m, of the diagonals of the cells
  double apart = 0;  // N/m, between vertices that are two cells apart, or opposite an edge
  bool on_grid = true, both_diagonals = true;

  template <class Act>
  void conditions(const Spring& s, const Vecs<1>& y, const Act& act) const {
    act(*this, Elongation(s, y[0]));
  }
};

// [bend] model = "springs": between opposite vertices of two triangles, with hardly any resistance to
// small folds. They have no bending modulus: their energy grows with κ⁴.
struct SpringBend : Term {
  using Term::Term;
  static constexpr TermInfo info = {
      .table = "bend", .model = "springs", .first_step = 5, .rests_flat = true};

  template <class Act>
  void conditions(const Spring& s, const Vecs<1>& y, const Act& act) const {
    act(*this, Elongation(s, y[0]));
  }
};
