#include "assignments/checks/invention.h"

namespace {

struct Statement {
  using Term = ObliqueThreadTerm;

  static std::vector<double> C(const Triangle& t, const Vecs<2>& w) {
    const double along_u = std::cos(thread_angle), along_v = std::sin(thread_angle);
    return {std::sqrt(t.area) * ((along_u * w[0] + along_v * w[1]).norm() - 1)};
  }
  static bool is_smooth(const Vecs<2>&) { return true; }
};
INSTANTIATE_TYPED_TEST_SUITE_P(ObliqueThread, Invention, Statement);

}  // namespace
