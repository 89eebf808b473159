// Measures of a state: energies, the largest stretch, the lowest point, distances.
#pragma once
#include <Eigen/Geometry>
#include <string_view>
#include <utility>
#include <vector>

#include "math/cloth.h"
#include "scene/mesh.h"

using TermEnergies = std::vector<std::pair<std::string_view, double>>;  // J, by table

// E = Σ k/2 C² over all elements, one sum for each table of the scene, in the order of the lists.
TermEnergies elastic_energies(const Cloth&, const VecX& x);

struct Energies {
  double kinetic = 0;        // Σ m v²/2
  double gravitational = 0;  // −Σ m g·x, zero at the origin
  TermEnergies by_term;

  double elastic() const;
  double total() const { return kinetic + elastic() + gravitational; }
};
Energies energies(const Cloth&, const State&);

// A cloth with a thread of more than this many times its length has exploded.
constexpr double exploded_stretch = 1000;
inline bool has_exploded(double max_stretch) {
  return !(max_stretch <= exploded_stretch);  // also where it is NaN
}

// The largest |w_u| or |w_v| of all triangles: 1 at rest.
double max_stretch(const Mesh&, const VecX& x);

// max(|w_u|, |w_v|) − 1, at least 0, per vertex: the largest of its triangles. For the strain map.
VecX vertex_strain(const Mesh&, const VecX& x);

double lowest(const VecX& x);                       // m, the smallest y
Eigen::AlignedBox3d box_of(const VecX& x);          // around all vertices
double rms_distance(const VecX& a, const VecX& b);  // m, RMS over the vertices
