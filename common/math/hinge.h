// A hinge in a cloth: the angle θ as a condition, by Baraff & Witkin and by Bridson et al.
//
// k_of_modulus: the k of a model, N·m, for a cloth of bending modulus B, N·m. Bent to a cylinder of
// curvature κ, such a cloth stores the energy B κ²/2 per area. The rule holds for square cells, for
// vertices on the cylinder, and for an axis along the grid. In other directions the cloth is between
// half and three times as stiff. A cloth that can relax is softer, a narrow strip by up to 1/3. On cells
// a × b the dihedral model has B = k a/b where it is bent along a.
#pragma once
#include <numbers>
#include <span>

#include "math/angle.h"
#include "math/family.h"

// Its vectors y are its vertices P0, P1, P2, P3.
struct Hinge : VertexElement<4> {
  static constexpr std::string_view plural = "hinges";
  double rest_angle = 0;  // θ0
  double shape = 1;       // Bridson's σ = l²/(2 A0 + 2 A1), from the rest shape
  double theta = 0;       // θ where the time step starts; may lie beyond ±π
  double lowest = 1e-6;   // m, a flap that is lower is a line: 1e-4 of the lowest one at rest
};

// θ can grow beyond ±π. Angles that differ by a full turn look alike; θ is the one that is nearest to
// the stored theta. So a fold that is swept through π keeps its energy and the sign of its force. A
// degenerate fold, which has no angle, keeps the stored θ.
inline double angle(const Hinge& hinge, const Vecs<4>& p) {
  if (!has_angle(p, hinge.lowest)) return hinge.theta;
  const double turn = angle(p) - hinge.theta;
  if (std::abs(turn) <= std::numbers::pi) return angle(p);
  return hinge.theta + std::remainder(turn, 2 * std::numbers::pi);
}

// Every hinge stores its θ. A time step calls this with the x from which it starts.
inline void follow(std::span<Hinge> hinges, const VecX& x) {
  for (Hinge& hinge : hinges) hinge.theta = angle(hinge, gather(hinge, x));
}

// θ before the first step. Where one flap lies flat on the other, θ is π or −π. The positions do not say
// which, and rounding would choose for every hinge anew. So θ is read as if each vertex were moved a hair
// farther along one direction than the vertex before. All hinges then belong to one folded cloth, which can
// unfold.
inline void start_angles(std::span<Hinge> hinges, const VecX& x) {
  const Vec3 direction(0.48, 0.6, 0.64);  // oblique: in no plane of the coordinates
  for (Hinge& hinge : hinges) {
    Vecs<4> y = gather(hinge, x);
    for (int i = 0; i < 4; ++i) y[i] += 1e-6 * hinge.lowest * hinge.vertices[i] * direction;
    hinge.theta = angle(hinge, y);
  }
}

// θ of a hinge with both derivatives. A degenerate fold has the energy of the stored θ, and no force.
struct Angle {
  Angle(const Hinge& hinge, const Vecs<4>& p)
      : fold(make_fold(p)), exists(has_angle(p, hinge.lowest)), value(angle(hinge, p)),
        gradient(exists ? angle_gradient(fold) : zero_vectors<4>()) {}
  Mats<4> second() const { return exists ? angle_second(fold) : zero_matrices<4>(); }

  Fold fold;
  bool exists;
  double value;
  Vecs<4> gradient;
};

// Bend (Baraff & Witkin):  C = θ − θ0
struct Dihedral : Condition<4> {
  Dihedral(const Hinge& hinge, const Vecs<4>& p) : theta(hinge, p) {
    C = theta.value - hinge.rest_angle;
    dCdy = theta.gradient;
  }

  Mats<4> second() const { return theta.second(); }

  Angle theta;
};

// Bend (Bridson et al.), with φ = (θ − θ0)/4 and s = √(8σ):
//
//   C = s sin φ,   ∂C/∂x = s/4 cos φ ∂θ/∂x,   f = −k σ sin((θ − θ0)/2) ∂θ/∂x
//
// Their force is k σ sin(θ/2) u_i for θ0 = 0, u_i = −∂θ/∂x_i; they write c for σ. For other θ0 they
// take sin(θ/2) − sin(θ0/2), which is zero at θ0 as well but there cos(θ0/2) times as stiff. σ is that
// of the rest shape: with the current σ the force would follow from no energy, and K would not be
// symmetric.
struct Bridson : Condition<4> {
  Bridson(const Hinge& hinge, const Vecs<4>& p)
      : theta(hinge, p), phi((theta.value - hinge.rest_angle) / 4), s(std::sqrt(8 * hinge.shape)) {
    C = s * std::sin(phi);
    for (int i = 0; i < 4; ++i) dCdy[i] = theta.gradient[i] * (s / 4 * std::cos(phi));
  }

  // ∂²C/∂x_i∂x_j = s/4 (cos φ ∂²θ/∂x_i∂x_j − sin φ/4 ∂θ/∂x_i ∂θ/∂x_jᵀ)
  Mats<4> second() const {
    Mats<4> H = theta.second();
    const Vecs<4>& g = theta.gradient;
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j)
        H[i][j] =
            s / 4 * std::cos(phi) * H[i][j] - s / 16 * std::sin(phi) * g[i] * g[j].transpose();
    return H;
  }

  Angle theta;
  double phi, s;
};

// [bend] model = "dihedral"
struct DihedralBend : Term {
  using Term::Term;
  static constexpr TermInfo info = {
      .table = "bend", .model = "dihedral", .first_step = 5, .units = newton_metre};
  static double k_of_modulus(double B) { return B; }

  template <class Act>
  void conditions(const Hinge& hinge, const Vecs<4>& p, const Act& act) const {
    act(*this, Dihedral(hinge, p));
  }
};

// [bend] model = "bridson"
struct BridsonBend : Term {
  using Term::Term;
  static constexpr TermInfo info = {
      .table = "bend", .model = "bridson", .first_step = 5, .units = newton_metre};
  static double k_of_modulus(double B) { return 4 * B; }

  template <class Act>
  void conditions(const Hinge& hinge, const Vecs<4>& p, const Act& act) const {
    act(*this, Bridson(hinge, p));
  }
};
