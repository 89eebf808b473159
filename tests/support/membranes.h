// The ways to resist a change of shape within the plane, by name and with the same moduli.
#pragma once
#include <stdexcept>
#include <string>
#include <vector>

#include "scene/make_cloth.h"

// Of a sheet, N/m. E and ν as in [membrane].
struct Moduli {
  double mu, lambda;

  double kappa() const { return lambda + mu; }
  double E() const { return 4 * mu * kappa() / (mu + kappa()); }
};
inline Moduli moduli_of(double E, double nu) {
  return {E / (2 * (1 + nu)), E * nu / (1 - nu * nu)};
}

// The models of [membrane], in the order of the list.
inline std::vector<std::string> membrane_names() {
  std::vector<std::string> names;
  for (const TermInfo& term : term_infos())
    if (term.in_plane == InPlane::membrane) names.emplace_back(term.model);
  return names;
}

// A model with this membrane, damped by kd. "threads" is [stretch] with k = E and [shear] with k = μ.
inline Model with_membrane(const std::string& name, const Moduli& moduli, double kd = 0) {
  Model model;
  if (name == "threads")
    return model.add(StretchTerm(moduli.E(), kd)).add(ShearTerm(moduli.mu, kd));
  bool found = false;
  for_each_term(model, [&]<class T>(std::optional<T>& term) {
    if constexpr (std::is_base_of_v<MembraneTerm, T>)
      if (T::info.model == name) {
        term.emplace(moduli.mu, kd);
        term->kappa = moduli.kappa();
        found = true;
      }
  });
  if (!found) throw std::logic_error("no membrane is called " + name);
  return model;
}
