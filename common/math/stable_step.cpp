#include "math/stable_step.h"

#include <cmath>
#include <limits>

double critical_step(const Cloth& cloth, const State& state,
                     const std::function<const VecX&(const State&)>& forces) {
  const auto difference = [&](const VecX& dx, const VecX& dv) -> VecX {  // −(f(+) − f(−))/2
    const VecX before = forces({state.x - dx, state.v - dv});
    const VecX& after = forces({state.x + dx, state.v + dv});
    return 0.5 * (before - after);
  };
  const VecX zero = VecX::Zero(state.x.size());
  const VecX free = (cloth.inverse_mass.array() > 0).cast<double>();

  // A start that no mode is orthogonal to: irregular, and the same on every machine.
  VecX p(state.x.size());
  for (int i = 0; i < p.size(); ++i) p[i] = free[i] * std::sin(1.0 + 12.9898 * i * (1 + i % 7));

  const double reach = 1e-7;  // m, of a difference
  double h = std::numeric_limits<double>::infinity(), h_before = h;
  for (int iteration = 0; iteration < 2000; ++iteration) {
    const double step = reach / p.cwiseAbs().maxCoeff();
    const VecX Kp = free.cwiseProduct(difference(step * p, zero)) / step;
    const VecX Dp = free.cwiseProduct(difference(zero, step * p)) / step;
    const double pMp = p.cwiseAbs2().dot(cloth.mass);
    const double kappa = std::abs(p.dot(Kp)) / pMp, delta = std::max(0.0, p.dot(Dp) / pMp);
    if (!(kappa + delta > 0)) return std::numeric_limits<double>::infinity();
    h = 4 / (delta + std::sqrt(delta * delta + 4 * kappa));
    p = cloth.inverse_mass.cwiseProduct(h * h * Kp + 2 * h * Dp);
    p /= p.norm();
    if (iteration % 20 == 19) {
      if (std::abs(h - h_before) < 1e-4 * h) return h;
      h_before = h;
    }
  }
  return h;
}
