#include "assignments/checks/check.h"
#include "step02_damping/time_step.h"

namespace {

// A condition on the second of the two vectors of a triangle.
struct Lengthens : Condition<1> {
  Lengthens(double C_, const Vec3& gradient) {
    C = C_;
    dCdy = {gradient};
    first = 1;
  }
};

VecX force(const Term& term, double C, const Vec3& gradient, const Vecs<2>& ydot) {
  step02::Sum<Triangles> sum;
  step02::act(term, Lengthens(C, gradient), ydot, sum);
  return joined(sum.f);
}

const Vec3 g(2, 0, 0);
const Vecs<2> at_rest = {Vec3::Zero(), Vec3::Zero()};

TEST(Damping, KeepsTheForceOfStepOne) {
  VecX expected(6);
  expected << 0, 0, 0, -60, 0, 0;  // −k C ∂C/∂y
  AGREES("f on (w_u, w_v) with k = 100, C = 0.3, ∂C/∂w_v = (2, 0, 0), without velocities",
         force(Term(100, 5), 0.3, g, at_rest), expected, 1e-10);
}

TEST(Damping, ResistsTheVelocity) {
  VecX expected(6);
  expected << 0, 0, 0, -60, 0, 0;  // −kd Ċ ∂C/∂y with Ċ = 2 · 3
  AGREES("f with kd = 5, C = 0, ∂C/∂w_v = (2, 0, 0), ẇ_v = (3, 4, 0)",
         force(Term(100, 5), 0, g, {Vec3::Zero(), Vec3(3, 4, 0)}), expected, 1e-10);
}

TEST(Damping, ReadsTheVelocityOfItsOwnVector) {
  AGREES("f with C = 0, where only ẇ_u moves and C reads w_v",
         force(Term(100, 5), 0, g, {Vec3(7, 7, 7), Vec3::Zero()}), VecX::Zero(6), 1e-12);
}

TEST(Damping, TakesTheEnergyThatItShould) {
  Random random(seed());
  for (int i = 0; i < 20; ++i) {
    const Vec3 gradient = random.vector(3, 1);
    const Vecs<2> ydot = {random.vector(3, 1), random.vector(3, 1)};
    const double Cdot = gradient.dot(ydot[1]), kd = random.between(0.1, 3);
    AGREES("the power of the damping, −kd Ċ²",
           force(Term(50, kd), 0, gradient, ydot).dot(joined(ydot)), -kd * Cdot * Cdot, 1e-10);
  }
}

}  // namespace
