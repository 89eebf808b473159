// The elastic forces of a family by themselves, without a time step.
#pragma once
#include "math/condition.h"

// f = −k C ∂C/∂x of one family.
template <class Family>
VecX family_forces(const Family& family, const VecX& x) {
  VecX f = VecX::Zero(x.size());
  for (const auto& element : family.elements) {
    Vecs<Family::Y> f_y = zero_vectors<Family::Y>();
    family.conditions(element, gather(element, x),
                      [&](const Term& term, const auto& c, const auto&) {
                        for (int m = 0; m < int(c.dCdy.size()); ++m)
                          f_y[c.first + m] -= term.k * c.C * c.dCdy[m];
                      });
    scatter(element, f_y, f);
  }
  return f;
}
