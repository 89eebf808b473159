#include "assignments/checks/invention.h"

namespace {

struct Statement {
  using Term = CosineShearTerm;

  static std::vector<double> C(const Triangle& t, const Vecs<2>& w) {
    return {std::sqrt(t.area) * (w[0].dot(w[1]) / (w[0].norm() * w[1].norm()) - rest_cosine)};
  }
  static bool is_smooth(const Vecs<2>&) { return true; }
};
INSTANTIATE_TYPED_TEST_SUITE_P(CosineShear, Invention, Statement);

}  // namespace
