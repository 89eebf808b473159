// The elastic forces of a family by themselves, without a time step.
#pragma once
#include "math/energy.h"

// f = −k C ∂C/∂x of one family.
template <class Family>
VecX family_forces(const Family& family, const VecX& x) {
  VecX f = VecX::Zero(x.size());
  add_elastic_forces(family, x, f);
  return f;
}
