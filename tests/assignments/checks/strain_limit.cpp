#include "assignments/checks/invention.h"

namespace {

struct Statement {
  using Term = StrainLimitTerm;

  static std::vector<double> C(const Triangle& t, const Vecs<2>& w) {
    std::vector<double> C;
    for (const Vec3& thread : w)
      C.push_back(std::sqrt(t.area) * std::max(0.0, thread.norm() - strain_limit));
    return C;
  }
  static bool is_smooth(const Vecs<2>& w) {
    return std::abs(w[0].norm() - strain_limit) > 0.01 &&
           std::abs(w[1].norm() - strain_limit) > 0.01;
  }
};
INSTANTIATE_TYPED_TEST_SUITE_P(StrainLimit, Invention, Statement);

TEST(StrainLimitTerm, CostsNothingBelowTheLimit) {
  SmallCloth small(2);
  small.cloth.term<StrainLimitTerm>() = StrainLimitTerm(1000);
  AGREES("the energy of a cloth that is stretched by less than the limit",
         potential_energy(small.cloth, (1 + 0.9 * (strain_limit - 1)) * small.x), 0, 0);
}

}  // namespace
