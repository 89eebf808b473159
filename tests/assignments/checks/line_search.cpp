#include "assignments/checks/check.h"
#include "assignments/checks/cloths.h"
#include "step03_implicit/time_step.h"

namespace {

struct Search {
  explicit Search(const SmallCloth& small, double h_, unsigned seed)
      : cloth(small.cloth), h(h_), random(seed), system(cloth), v(random.vector(27, 1)) {
    for (double& mass : cloth.mass) mass = random.between(1, 2);
    system.start = {small.x + random.vector(27, 0.2), random.vector(27, 1)};
  }
  double step(const VecX& dv) {
    system.dv = dv;
    return step03::line_search(cloth, h, v, system);
  }

  Cloth cloth;
  double h;
  Random random;
  step03::System system;
  VecX v;
};

// A cloth without forces: Φ = ½ |v − v0|²_M. Along Δv = s (v0 − v) a step falls by step · (1 − step · s/2) · fall.
struct FreeSearch : Search {
  FreeSearch() : Search(SmallCloth(2), 0.1, seed()), to_minimum(system.start.v - v) {
    system.b = cloth.mass.cwiseProduct(to_minimum);
  }
  VecX to_minimum;
};

TEST(LineSearch, TakesAllOfAStepToTheMinimum) {
  FreeSearch free;
  AGREES("the step to the minimum of a quadratic Φ", free.step(free.to_minimum), 1, 0);
  AGREES("a step that leads a third of the way there", free.step(free.to_minimum / 3), 1, 0);
}

TEST(LineSearch, HalvesAStepThatIsTooLong) {
  FreeSearch free;
  AGREES("the step if Δv is 3 times as long as the way to the minimum of a quadratic Φ",
         free.step(3 * free.to_minimum), 0.5, 0);
  AGREES("the step if Δv is 100 times as long as that way", free.step(100 * free.to_minimum),
         1.0 / 64, 0);
}

TEST(LineSearch, AsksForAFallThatIsWorthTheStep) {
  FreeSearch free;
  AGREES("the step along a Δv with which Φ falls by 5e-4 · fall",
         free.step(1.999 * free.to_minimum), 1, 0);
  AGREES("the step along a Δv with which Φ falls by 0.5e-4 · fall",
         free.step(1.9999 * free.to_minimum), 0.5, 0);
}

TEST(LineSearch, GoesBackWhereTheStepLeadsUphill) {
  FreeSearch free;
  AGREES("the step along a Δv that leads away from the minimum", free.step(-free.to_minimum), -1,
         0);
  AGREES("the step along one that is 3 times as long", free.step(-3 * free.to_minimum), -0.5, 0);
}

TEST(LineSearch, TakesNoStepAtTheMinimum) {
  FreeSearch free;
  free.v = free.system.start.v;
  free.system.b.setZero();
  AGREES("the step from the minimum of Φ", free.step(free.to_minimum), 0, 0);
}

// A damped cloth of threads, far from rest. b is the slope of Φ, by differences.
TEST(LineSearch, FindsTheLongestStepThatIsGoodEnough) {
  SmallCloth small(2);
  small.cloth.term<StretchTerm>() = StretchTerm(100, 1);
  for (unsigned i = 0; i < 20; ++i) {
    Search search(small, 0.1, seed() + i);
    fill_negative(search.system.D, search.random);
    const auto Phi = [&](const VecX& v) {
      const VecX dv = v - search.system.start.v;
      return 0.5 * dv.dot(search.cloth.mass.cwiseProduct(dv)) +
             potential_energy(search.cloth, search.system.start.x + search.h * v) -
             0.5 * search.h * v.dot(whole(search.system.D) * v);
    };
    const VecX& v = search.v;
    search.system.b =
        -slope_of([&](const VecX& at) { return one_number(Phi(at)); }, v, 1e-3).transpose();
    const VecX dv = search.random.between(0.1, 5) * search.system.b;
    const double fall = search.system.b.dot(dv), step = search.step(dv);
    const auto good = [&](double s) { return Phi(v + s * dv) <= Phi(v) - 1e-4 * s * fall; };
    const std::string taken = "line_search takes the step " + std::to_string(step);
    HOLDS(taken + ", and Φ falls by less than 1e-4 · step · fall", good(step));
    HOLDS(taken + ", and a step twice as long is good enough", step == 1 || !good(2 * step));
  }
}

}  // namespace
