#include "assignments/checks/check.h"
#include "step03_implicit/time_step.h"

namespace {

// The sum of one condition on (w_u, w_v): its force, and K and D as 6 × 6 matrices.
struct Acted {
  Acted(const Triangle& t, const auto& condition, const Term& term, const Vecs<2>& wdot,
        Jacobian jacobian) {
    Slots<3> slots{};
    BlockMatrix none;
    step03::Sum<Triangles> sum{.K = {t, slots, none}, .D = {t, slots, none}};
    step03::act(term, condition, jacobian, wdot, sum);
    f = joined(sum.f);
    K = dense(sum.K.on_y()), D = dense(sum.D.on_y());
    T = sum.T.T;
  }
  static MatX dense(const Mats<2>& A) {  // of which the blocks on and above the diagonal are formed
    MatX all(6, 6);
    all << A[0][0], A[0][1], A[0][1].transpose(), A[1][1];
    return all;
  }
  VecX f;
  MatX K, D, T;
};

// Stretch and shear in a random state.
struct Case {
  explicit Case(Random& random, Pose pose)
      : t(make_triangle(random_rest(random))),
        w(pose_w(pose, random)), wdot{random.vector(3, 1), random.vector(3, 1)},
        term(random.between(2, 8), random.between(0.5, 2)) {}
  Acted stretch(const Vecs<2>& at, const Vecs<2>& velocity, Jacobian jacobian) const {
    return Acted(t, Stretch(t, at, 1), term, velocity, jacobian);
  }
  Acted shear(const Vecs<2>& at, const Vecs<2>& velocity, Jacobian jacobian) const {
    return Acted(t, Shear(t, at), term, velocity, jacobian);
  }
  Triangle t;
  Vecs<2> w, wdot;
  Term term;
};

const Vecs<2> at_rest = zero_vectors<2>();

TEST(ConditionMatrix, KIsTheSlopeOfTheForce) {
  Random random(seed());
  for (const Pose pose : {Pose::random, Pose::compressed, Pose::sheared}) {
    const Case c(random, pose);
    const auto slope = [&](auto act) {
      return slope_of([&](const VecX& y) { return act(split<2>(y)).f; }, joined(c.w), 1e-3);
    };
    const auto shear = [&](const Vecs<2>& w) { return c.shear(w, at_rest, Jacobian::bw98); };
    const auto stretch = [&](const Vecs<2>& w) { return c.stretch(w, at_rest, Jacobian::bw98); };
    AGREES(std::string("K of shear with --jacobian bw98, pose ") + name(pose), shear(c.w).K,
           slope(shear), 1e-6);
    AGREES(std::string("K of stretch with --jacobian bw98, pose ") + name(pose), stretch(c.w).K,
           slope(stretch), 1e-6);
  }
}

// Damping adds −kd Ċ ∂²C; for shear, ∂²C/∂w_u∂w_v is √a times the identity.
TEST(ConditionMatrix, DampingStiffensTheMatrix) {
  Random random(seed() + 5);
  const Case c(random, Pose::random);
  const double Cdot = c.t.sqrt_area * (c.wdot[0].dot(c.w[1]) + c.wdot[1].dot(c.w[0]));
  const MatX more =
      c.shear(c.w, c.wdot, Jacobian::bw98).K - c.shear(c.w, at_rest, Jacobian::bw98).K;
  AGREES("what damping adds to the block (w_u, w_v) of K with --jacobian bw98",
         more.topRightCorner(3, 3), -c.term.kd * Cdot * c.t.sqrt_area * Mat3::Identity(), 1e-9);
}

TEST(ConditionMatrix, DIsTheSlopeInTheVelocity) {
  Random random(seed() + 1);
  const Case c(random, Pose::random);
  const auto f = [&](const VecX& velocity) {
    return c.shear(c.w, split<2>(velocity), Jacobian::definite).f;
  };
  AGREES("D of shear", c.shear(c.w, c.wdot, Jacobian::definite).D,
         slope_of(f, joined(c.wdot), 1e-2), 1e-8);
}

TEST(ConditionMatrix, NothingIsDampedWithoutKd) {
  Random random(seed() + 2);
  Case c(random, Pose::random);
  c.term.kd = 0;
  AGREES("D with kd = 0", c.shear(c.w, c.wdot, Jacobian::definite).D, MatX::Zero(6, 6), 0);
}

// The definite K has rank one: it resists only along the gradient. The rest goes into the tension.
TEST(ConditionMatrix, TheDefiniteMatrixResistsAlongTheGradient) {
  Random random(seed() + 3);
  const Case c(random, Pose::random);
  const Acted got = c.shear(c.w, c.wdot, Jacobian::definite);
  VecX along(6);
  along << c.w[1], c.w[0];
  const double scale = c.term.k * c.t.area * along.squaredNorm();
  AGREES("definite K times the direction of the gradient", got.K * along, -scale * along,
         1e-9 * scale);
  AGREES("the trace of the definite K", got.K.trace(), -scale, 1e-9 * scale);
}

TEST(ConditionMatrix, TheTensionHasTheLoadWithoutDamping) {
  Random random(seed() + 4);
  const Case c(random, Pose::random);
  const double kC = c.term.k * Stretch(c.t, c.w, 1).C;
  MatX expected = MatX::Zero(2, 2);
  expected(1, 1) = kC * c.t.sqrt_area / c.w[1].norm();
  AGREES("T of the stretched thread w_v", c.stretch(c.w, c.wdot, Jacobian::definite).T, expected,
         1e-8);
}

}  // namespace
