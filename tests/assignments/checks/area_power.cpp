#include "assignments/checks/invention.h"

namespace {

struct Statement {
  using Term = AreaPowerTerm;

  static std::vector<double> C(const Triangle& t, const Vecs<2>& w) {
    const double J = w[0].cross(w[1]).norm();
    return {std::sqrt(t.area) * (std::pow(J, area_power) - 1) / area_power};
  }
  static bool is_smooth(const Vecs<2>&) { return true; }
};
INSTANTIATE_TYPED_TEST_SUITE_P(AreaPower, Invention, Statement);

}  // namespace
