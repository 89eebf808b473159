#include "assignments/checks/check.h"
#include "assignments/checks/cloths.h"
#include "step03_implicit/time_step.h"

namespace {

struct Case {
  Case()
      : random(seed()), small(2),
        system((small.cloth.term<StretchTerm>() = StretchTerm(1, 1), small.cloth)) {
    for (double& mass : small.cloth.mass) mass = random.between(1, 2);
    fill_negative(system.K, random), fill_negative(system.D, random);
    system.b = random.vector(27, 1);
    step03::solve(small.cloth, h, system);
  }
  static constexpr double h = 0.1;
  Random random;
  SmallCloth small;
  step03::System system;
};

TEST(Solve, AIsTheMatrixOfBackwardEuler) {
  Case c;
  MatX expected = MatX(c.small.cloth.mass.asDiagonal()) - c.h * whole(c.system.D) -
                  c.h * c.h * whole(c.system.K);
  AGREES("A, with random M, D and K and h = 0.1 s", whole(c.system.A), expected, 1e-12);
}

TEST(Solve, DvSolvesTheSystem) {
  Case c;
  AGREES("A Δv", whole(c.system.A) * c.system.dv, c.system.b, 1e-9);
}

TEST(Solve, NothingIsIndefinite) {
  AGREES("`indefinite`, for a matrix that is definite", double(Case().system.counts.indefinite), 0,
         0);
}

}  // namespace
