#include <Eigen/Cholesky>

#include "assignments/checks/check.h"
#include "assignments/checks/cloths.h"
#include "step04_cg/time_step.h"

namespace {

// A random system on a cloth with a held vertex and a slider.
struct Case {
  explicit Case(Method method) : random(seed()), small(3), system(small.cloth, method) {}
  explicit Case(double tolerance = 1e-12) : Case(Method{.tolerance = tolerance}) { prepare(); }
  void prepare() {
    const Vec3 p = random.direction();
    small.hold(Pin(0));
    small.hold(Pin(5, Mat3::Identity() - p * p.transpose()));
    fill_negative(system.K, random);
    system.A.set_diagonal(small.cloth.mass);
    system.A.add(-30, system.K);
    system.b = random.vector(n, 1);
    // The change of velocity that the pins prescribe, as `prescribe` leaves it.
    system.dv = VecX::Zero(n);
    system.dv.head<3>() = random.vector(3, 0.1);
    system.dv.segment<3>(15) = 0.2 * p;
    z = system.dv;
    S = MatX::Identity(n, n);
    S.topLeftCorner<3, 3>().setZero();
    S.block<3, 3>(15, 15) = small.cloth.pins[1].S;
    system.preconditioner = make_preconditioner("block", system.A, small.cloth.pins, {});
    system.preconditioner->set(system.A);
  }
  void solve() { step04::conjugate_gradients(small.cloth, system); }
  // The exact answer: z, and what S A S + I − S makes of the filtered right-hand side.
  VecX exact() const {
    const MatX A = whole(system.A), I = MatX::Identity(n, n);
    return z + S * MatX(S * A * S + I - S).ldlt().solve(S * (system.b - A * z));
  }
  static constexpr int n = 48;
  Random random;
  SmallCloth small;
  step04::System system;
  VecX z;
  MatX S;
};

TEST(ConjugateGradients, KeepsWhatThePinsPrescribe) {
  Case c;
  c.solve();
  AGREES("Δv in the directions that pins hold", c.system.dv - c.S * c.system.dv, c.z - c.S * c.z,
         1e-10);
}

TEST(ConjugateGradients, SolvesTheSystem) {
  Case c;
  c.solve();
  AGREES("Δv, compared with the solution of the dense system", c.system.dv, c.exact(), 1e-8);
}

TEST(ConjugateGradients, NeedsNoMoreIterationsThanUnknowns) {
  Case c;
  c.solve();
  HOLDS(
      "Expected at least 2 and at most 60 iterations for 48 unknowns, got " +
          std::to_string(c.system.counts.iterations) +
          ". Each direction has to be conjugate to the one before, and each iteration is counted.",
      c.system.counts.iterations >= 2 && c.system.counts.iterations <= 60);
}

TEST(ConjugateGradients, StopsAtTheTolerance) {
  Case loose(1e-2), tight(1e-10);
  loose.solve(), tight.solve();
  HOLDS("Expected fewer iterations for the tolerance 1e-2 than for 1e-10, got " +
            std::to_string(loose.system.counts.iterations) + " and " +
            std::to_string(tight.system.counts.iterations),
        loose.system.counts.iterations < tight.system.counts.iterations);
  const VecX error = loose.system.dv - loose.exact();
  AGREES("the error at the tolerance 1e-2, as a fraction of Δv",
         error.norm() / loose.exact().norm(), 0, 0.2);
}

TEST(ConjugateGradients, SaysThatItWasStopped) {
  Case c(Method{.tolerance = 1e-12, .max_iterations = 2});
  c.prepare();
  c.solve();
  AGREES("`capped` after 2 iterations, which are not enough", double(c.system.counts.capped), 1, 0);
}

TEST(ConjugateGradients, SaysThatAIsNotDefinite) {
  Case c;
  for (Mat3& block : c.system.A.diagonal) block -= 100 * Mat3::Identity();
  c.solve();
  HOLDS("A is not positive definite, and `indefinite` was not counted",
        c.system.counts.indefinite >= 1);
}

}  // namespace
