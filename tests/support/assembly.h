// Forces and matrices of a cloth as step 5 assembles them. Step 5 has every family of elements.
#pragma once
#include "step05_bend/time_step.h"
#include "support/dense.h"

class Assembly {
 public:
  explicit Assembly(const Cloth& cloth_, Jacobian jacobian = Jacobian::definite)
      : cloth(cloth_), system(cloth, {.jacobian = jacobian}) {}

  VecX f(const VecX& x, const VecX& v) {
    step05::forces(cloth, {x, v}, system);
    return system.f;
  }
  VecX f(const VecX& x) { return f(x, VecX::Zero(x.size())); }
  VecX damping(const VecX& x, const VecX& v) { return f(x, v) - f(x); }
  MatX K(const VecX& x) {
    f(x);
    return dense(system.K);
  }
  MatX D(const VecX& x) {
    f(x);
    return dense(system.D);
  }

 private:
  const Cloth& cloth;
  step05::System system;
};
