// The elasticity of note 004: a triangle in the plane, written with matrices as the note writes it. The tests
// compare it with the conditions of the cloth, which know neither ψ nor P.
//
//   F  = D_s Dm⁻¹,   D_s = [x1−x0, x2−x0]
//   ψ  = μ e:e + λ/2 tr²e,    P = ∂ψ/∂F
//   H  = [f1 f2] = −a P Dm⁻ᵀ,    f0 = −f1 − f2
#pragma once
#include "support/energy.h"
#include "support/membranes.h"
#include "support/poses.h"

namespace plane {

using Mat2 = Eigen::Matrix2d;
template <int Dimension>
using Nodal = Eigen::Matrix<double, Dimension, 3>;  // a column for each vertex

inline Mat2 matrix(double a, double b, double c, double d) {
  return (Mat2() << a, b, c, d).finished();
}
inline Mat2 diagonal(double a, double d) {
  return matrix(a, 0, 0, d);
}
inline Mat2 rotation(double angle) {
  return Eigen::Rotation2Dd(angle).toRotationMatrix();
}

inline Mat2 small_strain(const Mat2& F) {
  return (F + F.transpose()) / 2 - Mat2::Identity();
}
template <class Gradient>
Mat2 green_strain(const Gradient& F) {
  return (F.transpose() * F - Mat2::Identity()) / 2;
}

inline double psi(const Moduli& m, const Mat2& e) {
  return m.mu * e.squaredNorm() + m.lambda / 2 * e.trace() * e.trace();
}
inline Mat2 stress(const Moduli& m, const Mat2& e) {
  return 2 * m.mu * e + m.lambda * e.trace() * Mat2::Identity();
}

// P of StVK, and its change with F. F is 2 × 2 in the plane and 3 × 2 in space.
template <class Gradient>
Gradient stvk_P(const Moduli& m, const Gradient& F) {
  return F * stress(m, green_strain(F));
}
template <class Gradient>
Gradient stvk_dP(const Moduli& m, const Gradient& F, const Gradient& dF) {
  const Mat2 dE = (dF.transpose() * F + F.transpose() * dF) / 2;
  return dF * stress(m, green_strain(F)) + F * stress(m, dE);
}

struct Material {
  const char* name;  // in [membrane]
  double (*psi)(const Moduli&, const Mat2& F);
  Mat2 (*P)(const Moduli&, const Mat2& F);
  Mat2 (*dP)(const Moduli&, const Mat2& F, const Mat2& dF);
};

inline const Material linear = {
    "linear", [](const Moduli& m, const Mat2& F) { return psi(m, small_strain(F)); },
    [](const Moduli& m, const Mat2& F) { return stress(m, small_strain(F)); },
    [](const Moduli& m, const Mat2&, const Mat2& dF) {
      return stress(m, (dF + dF.transpose()) / 2);
    }};
inline const Material stvk = {
    "stvk", [](const Moduli& m, const Mat2& F) { return psi(m, green_strain(F)); }, stvk_P<Mat2>,
    stvk_dP<Mat2>};

inline Mat2 rest_edges(const Rest& rest) {
  return (Mat2() << rest[1] - rest[0], rest[2] - rest[0]).finished();
}

// From P, or from dP, to the forces on the three vertices.
template <class Stress>
Nodal<Stress::RowsAtCompileTime> nodal_forces(const Rest& rest, const Stress& P) {
  const Mat2 Dm = rest_edges(rest);
  const Stress H = -std::abs(Dm.determinant()) / 2 * P * Dm.inverse().transpose();
  Nodal<Stress::RowsAtCompileTime> f;
  f << -H.col(0) - H.col(1), H;
  return f;
}

// The same triangle as a cloth with one face that lies in the plane z = 0.
inline VecX positions(const Rest& rest, const Mat2& F) {
  const Vecs<2> w = {Vec3(F(0, 0), F(1, 0), 0), Vec3(F(0, 1), F(1, 1), 0)};
  return ::positions(rest, w, Vec3::Zero());
}
inline Cloth cloth(const Rest& rest, const std::string& membrane, const Moduli& moduli) {
  Mesh mesh;
  mesh.faces = {{0, 1, 2}};
  mesh.rest = {rest};
  mesh.x = positions(rest, Mat2::Identity());
  return make_cloth(mesh, with_membrane(membrane, moduli));
}
inline Nodal<2> cloth_forces(const Rest& rest, const std::string& membrane, const Moduli& moduli,
                             const Mat2& F) {
  const VecX f = forces(cloth(rest, membrane, moduli), positions(rest, F));
  return f.reshaped(3, 3).topRows<2>();
}
// ψ of the cloth: its energy per area at rest.
inline double cloth_psi(const std::string& membrane, const Moduli& moduli, const Mat2& F) {
  const Rest unit = {Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)};
  return energy(cloth(unit, membrane, moduli).triangles, positions(unit, F)) / 0.5;
}

}  // namespace plane
