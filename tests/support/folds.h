// Folds of every kind for the tests of bending: flaps of any proportion, folded by any angle.
#pragma once
#include <string>
#include <vector>

#include "math/hinge.h"
#include "math/quadratic_bend.h"
#include "support/bend_models.h"
#include "support/energy.h"
#include "support/family_forces.h"
#include "support/poses.h"

// A hinge in the plane: its edge lies along y and has the length 1, P0 is on the left. Each flap
// has a height, and the foot of the height lies on the edge: 0 at P1, 1 at P2.
struct FlatHinge {
  double height0, foot0, height1, foot1;

  // Folded by θ: P3 moves to the back, −z, as θ grows from 0.
  Vecs<4> folded(double theta) const {
    return {Vec3(-height0, foot0, 0), Vec3(0, 0, 0), Vec3(0, 1, 0),
            Vec3(height1 * std::cos(theta), foot1, -height1 * std::sin(theta))};
  }
  double lowest_height() const {
    double lowest = 1e300;
    for (const Flap& f : make_fold(folded(0)))
      for (const double d : f.d) lowest = std::min(lowest, d);
    return lowest;
  }
};

inline VecX flat(const Vecs<4>& p) {
  VecX x(12);
  x << p[0], p[1], p[2], p[3];
  return x;
}
inline Vecs<4> points(const VecX& x) {
  return {x.segment<3>(0), x.segment<3>(3), x.segment<3>(6), x.segment<3>(9)};
}

// The rest shape of a flat hinge for the models of Bridson and of Bergou.
inline double two_areas(const FlatHinge& hinge) {  // its edge is 1 m long
  return hinge.height0 + hinge.height1;
}
inline double bridson_shape(const FlatHinge& hinge) {
  return 1 / two_areas(hinge);
}
inline QuadraticHinge quadratic(const FlatHinge& hinge) {
  const Vecs<4> p = hinge.folded(0);
  const auto uv = [&](int i) -> Vec2 { return p[i].head<2>(); };
  return make_quadratic_hinge({0, 1, 2, 3}, {uv(0), uv(1), uv(2)}, {uv(3), uv(2), uv(1)});
}

struct FoldCase {
  std::string name;
  FlatHinge flat_hinge;
  double theta;
  VecX x;         // turned and moved at random
  double length;  // m, the lowest height: the scale on which θ changes
};

// Every proportion at every angle.
inline std::vector<FoldCase> all_folds(unsigned seed) {
  Random random(seed);
  const auto some = [&](double low, double high) { return random.between(low, high); };
  struct Proportion {
    const char* name;
    double low, high;  // the heights
    double first_foot, last_foot;
  };
  std::vector<FoldCase> folds;
  for (const Proportion& p : {Proportion{"plain", 0.4, 1, 0.1, 0.9},  // acute and right angles
                              Proportion{"obtuse at the vertex", 0.02, 0.05, 0.3, 0.7},
                              Proportion{"obtuse at the edge", 0.4, 1, 1.5, 3},
                              Proportion{"acute at the vertex", 20, 30, 0.1, 0.9},
                              Proportion{"acute at the edge", 0.02, 0.05, 1.5, 3},
                              Proportion{"hardly a triangle", 1e-4, 2e-4, 0.1, 0.9}})
    for (const double theta : {0.0, 0.1, -0.1, pi / 2, -pi / 2, pi - 1e-3, -pi + 1e-3, 0.5, -2.0}) {
      const FlatHinge hinge{some(p.low, p.high), some(p.first_foot, p.last_foot),
                            some(p.low, p.high), some(p.first_foot, p.last_foot)};
      folds.push_back({std::string(p.name) + ", θ = " + std::to_string(theta), hinge, theta,
                       moved(flat(hinge.folded(theta)), random.rotation(), random.vector(3, 1)),
                       hinge.lowest_height()});
    }
  return folds;
}

// A hinge of the vertices 0 to 3 that stores θ as the angle of the last step.
inline Hinge hinge_near(double theta, double rest_angle = 0, double shape = 1) {
  Hinge hinge{{{0, 1, 2, 3}}};
  hinge.rest_angle = rest_angle;
  hinge.shape = shape;
  hinge.theta = theta;
  return hinge;
}

inline Hinges one_hinge(const Hinge& hinge, double k, BendModel model = BendModel::dihedral) {
  Families families;
  families.hinges.elements = {hinge};
  add_bend(families, model, k);
  return families.hinges;
}
