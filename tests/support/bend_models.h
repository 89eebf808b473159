// The four models of [bend] as an enum, for tests that run over all of them.
#pragma once
#include <optional>

#include "scene/make_cloth.h"

enum class BendModel { dihedral, bridson, quadratic, springs };

// Calls act with the type of a model's term: act.operator()<DihedralBend>().
template <class Act>
auto with_bend_term(BendModel model, const Act& act) {
  switch (model) {
    case BendModel::dihedral:
      return act.template operator()<DihedralBend>();
    case BendModel::bridson:
      return act.template operator()<BridsonBend>();
    case BendModel::quadratic:
      return act.template operator()<QuadraticBend>();
    case BendModel::springs:
      break;
  }
  return act.template operator()<SpringBend>();
}

inline void add_bend(Families& families, BendModel model, double k, double kd = 0) {
  with_bend_term(model, [&]<class T>() { families.term<T>() = T(k, kd); });
}

// The k of a model that gives a cloth the bending modulus B; springs have none.
inline std::optional<double> stiffness_of_modulus(BendModel model, double B) {
  return with_bend_term(model, [&]<class T>() -> std::optional<double> {
    if constexpr (requires { T::k_of_modulus(B); })
      return T::k_of_modulus(B);
    else
      return std::nullopt;
  });
}
