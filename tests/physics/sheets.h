// Cloths of every model that resists within the plane, with the law of their stress.
//
// A rectangle is stretched by s along one side and by t along the other. P(s, t) is the force along the first
// side, per width at rest, N/m; along the second side it is P(t, s). With ψ as in math/membrane.h, P = ∂ψ/∂s:
//
//   threads, springs along u and v       P = E (s − 1)
//   linear, corotated, arap              P = 2μ (s − 1) + λ (s + t − 2)
//   stvk                                 P = s (μ (s² − 1) + λ/2 (s² + t² − 2))
//   neo-hookean                          P = μ (s − t) + κ t (s t − 1)
//   neo-hookean-barrier                  P = μ (s − 1/s) + λ ln(s t)/s
//   springs with two diagonals           P = k (s − 1) + 2 k_d (1 − √2/d) s,   d = √(s² + t²)
#pragma once
#include <functional>

#include "support/membranes.h"
#include "support/scenes.h"

using Law = std::function<double(double s, double t)>;

// Where a rising function is zero.
inline double zero_of(const std::function<double(double)>& rising, double low, double high) {
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (rising(middle) < 0 ? low : high) = middle;
  }
  return (low + high) / 2;
}

struct Sheet {
  std::string name;
  Model model;
  Law P;

  // The stretch across a sheet whose sides are free.
  double across(double s) const {
    return zero_of([&](double t) { return P(t, s); }, 0, 2);
  }
  // The force on a sheet whose sides are free: the uniaxial law.
  double pull(double s) const { return P(s, across(s)); }
  double stretch_under(double pulling) const {
    return zero_of([&](double s) { return pull(s) - pulling; }, 0.9, 2);
  }
  // ∂P/∂s
  double tangent(double s, double t) const {
    const double d = 1e-4;
    return (8 * (P(s + d, t) - P(s - d, t)) - (P(s + 2 * d, t) - P(s - 2 * d, t))) / (12 * d);
  }
};

inline Law law_of_membrane(const std::string& name, const Moduli& m) {
  const double mu = m.mu, lambda = m.lambda, kappa = m.kappa(), E = m.E();
  if (name == "threads") return [=](double s, double) { return E * (s - 1); };
  if (name == "stvk")
    return [=](double s, double t) {
      return s * (mu * (s * s - 1) + lambda / 2 * (s * s + t * t - 2));
    };
  if (name == "neo-hookean")
    return [=](double s, double t) { return mu * (s - t) + kappa * t * (s * t - 1); };
  if (name == "neo-hookean-barrier")
    return [=](double s, double t) { return mu * (s - 1 / s) + lambda * std::log(s * t) / s; };
  return [=](double s, double t) { return 2 * mu * (s - 1) + lambda * (s + t - 2); };
}

inline Sheet membrane_sheet(const std::string& name, const Moduli& moduli) {
  return {name, with_membrane(name, moduli), law_of_membrane(name, moduli)};
}

// Every model of [membrane] that can have this Poisson's ratio: arap has none, and that of the barrier is not
// negative.
inline std::vector<Sheet> membrane_sheets(double E, double nu) {
  std::vector<Sheet> sheets;
  for (const std::string& name : membrane_names())
    if (nu == 0 || (name != "arap" && (nu > 0 || name != "neo-hookean-barrier")))
      sheets.push_back(membrane_sheet(name, moduli_of(E, nu)));
  return sheets;
}

// A net of springs on a grid of square cells; kd is the stiffness of the two diagonals.
inline SpringTerm springs(double k, double kd = 0, double apart = 0) {
  SpringTerm term(k);
  term.shear = kd;
  term.apart = apart;
  return term;
}
inline Sheet spring_sheet(const std::string& name, double k, double kd) {
  return {name, Model().add(springs(k, kd)), [=](double s, double t) {
            return k * (s - 1) + 2 * kd * (1 - std::sqrt(2) / std::hypot(s, t)) * s;
          }};
}

// Threads, every membrane with two Poisson's ratios, and springs without and with diagonals.
inline std::vector<Sheet> all_sheets(double E) {
  std::vector<Sheet> sheets = {membrane_sheet("threads", moduli_of(E, 0))};
  for (const double nu : {0.0, 0.3})
    for (Sheet& sheet : membrane_sheets(E, nu)) {
      if (nu > 0) sheet.name += ", nu 0.3";
      sheets.push_back(std::move(sheet));
    }
  sheets.push_back(spring_sheet("springs", E, 0));
  sheets.push_back(spring_sheet("springs with diagonals", E, E / 2));
  return sheets;
}

inline TestScene scene_of(const Mesh& mesh, Model model, Gravity gravity,
                          const std::vector<Pin>& pins = {}) {
  model.density = density;
  model.pins = pins;
  if (gravity == Gravity::on) model.gravity = Vec3(0, -g, 0);
  return at_rest(mesh, model);
}

// Lays the cloth of a scene down anew. A membrane that remembers its start takes the pose of `lie` for it.
inline void lay(TestScene& scene, const std::function<Vec3(double u, double v)>& lie) {
  scene.start.x = field(scene.mesh, lie);
  start_terms(scene.cloth, scene.start.x);
}
