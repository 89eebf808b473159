#include "assignments/checks/invention.h"

namespace {

struct Statement {
  using Term = ShortEdgeTerm;

  static std::vector<double> C(const Spring& s, const Vecs<1>& y) {
    return {s.sqrt_share * (y[0].norm() - (1 - shortening) * s.rest_length)};
  }
  static bool is_smooth(const Vecs<1>&) { return true; }
};
INSTANTIATE_TYPED_TEST_SUITE_P(ShortEdge, Invention, Statement);

}  // namespace
