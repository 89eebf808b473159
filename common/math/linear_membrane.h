// The linear membrane: small strains, along the axes in which the cloth was laid.
//
//   e = (QᵀF + FᵀQ)/2 − I,   Q = (u v)       F as it was laid has the rotation Q
//
// Its forces are linear in the positions. So it takes a rotation for a strain, and has no force across its
// plane: a cloth that is turned by θ stores 2 κ (1 − cos θ)² per area. It is right for small motions only.
#pragma once
#include "math/membrane.h"

using Axes = Vecs<2>;  // u and v

// C = √a (Σ of coefficients times the components of w_u and w_v along u and v) − rest
struct LinearStrain : Condition<2> {
  LinearStrain(const Triangle& t, const Vecs<2>& w, const Vec3& along_wu, const Vec3& along_wv,
               double rest) {
    C = t.sqrt_area * (along_wu.dot(w[0]) + along_wv.dot(w[1]) - rest);
    dCdy = {t.sqrt_area * along_wu, t.sqrt_area * along_wv};
  }
  Mats<2> second() const { return zero_matrices<2>(); }
};

// The rotation of F: F = Q S, so Q = F S⁻¹ = (s F − F S)/J with S = (FᵀF + J I)/s. A triangle that is a line
// keeps what direction it has.
inline Axes axes_of(const Vecs<2>& w) {
  const Metric<double> m = metric(w);
  if (m.J < 1e-6) {
    const Vec3 u = w[0].norm() > 0 ? Vec3(w[0].normalized()) : Vec3::UnitX();
    return {u, u.unitOrthogonal()};
  }
  const double s = m.trace_of_stretch();
  return {(w[0] * (m.D + m.J) - m.B * w[1]) / (s * m.J),
          (w[1] * (m.A + m.J) - m.B * w[0]) / (s * m.J)};
}

struct LinearMembrane : MembraneTerm {
  using MembraneTerm::MembraneTerm;
  static constexpr TermInfo info = {.table = "membrane",
                                    .model = "linear",
                                    .rotation = Rotation::stored,
                                    .in_plane = InPlane::membrane};

  template <class Act>
  void conditions(const Triangle& t, const Vecs<2>& w, const Act& act) const {
    const auto& [u, v] = axes[size_t(t.face)];
    act(area(), LinearStrain(t, w, u, v, 2));
    act(*this, LinearStrain(t, w, u, -v, 0));
    act(*this, LinearStrain(t, w, v, u, 0));
  }

  // The axes are those of the pose at the start.
  void start_at(const std::vector<Triangle>& triangles, const VecX& x) {
    axes.clear();
    axes.reserve(triangles.size());
    for (const Triangle& t : triangles) axes.push_back(axes_of(gather(t, x)));
  }

  std::vector<Axes> axes;  // of every triangle
};
