#include "extremes/definite_ways.h"

#include <functional>
#include <stdexcept>

#include "math/direct_solver.h"
#include "math/energy.h"
#include "math/method.h"
#include "math/pattern.h"
#include "math/preconditioner.h"

namespace extremes {

// What a step does with its matrices. Newton's method adds D v to b once in each iteration, and Φ has one
// vᵀ D v, even where D is empty.
struct Uses {
  long systems = 0, iterations = 0, potentials = 0;

  // Each line search takes Φ at its start and after every attempt; the first attempt is no halving.
  long halvings() const { return potentials - 2 * iterations; }
};
static Uses uses;  // of the step that is running

struct WatchedMatrix : BlockMatrix {
  WatchedMatrix() = default;
  WatchedMatrix(const BlockMatrix& A) : BlockMatrix(A) {}

  void set_diagonal(const VecX& d) {
    ++uses.systems;
    BlockMatrix::set_diagonal(d);
  }
  void add_product(double factor, const VecX& p, VecX& y) const {
    ++uses.iterations;
    BlockMatrix::add_product(factor, p, y);
  }
  double form(const VecX& p) const {
    ++uses.potentials;
    return BlockMatrix::form(p);
  }
};

// A step counts here every system that is not definite, as the last thing that it does about it.
struct Indefinite {
  void operator++() {
    ++count;
    if (then) then();
  }

  long count = 0;
  std::function<void()> then;
};
struct WatchedCounters : Counters {
  Indefinite indefinite;
};

}  // namespace extremes

// The steps unchanged, but with these types, and in namespaces of their own. Step 5 asks the compiler to
// flatten: with every filter inlined it would compile for minutes.
#define flatten hot
#define Tension extremes::FilteredTension
#define BlockMatrix extremes::WatchedMatrix
#define Counters extremes::WatchedCounters
#define step03 filtered_step03
#define step05 filtered_step05
#include "step03_implicit/time_step.h"
#include "step05_bend/time_step.h"
#undef BlockMatrix
#undef flatten

namespace extremes {
namespace {

struct Three {
  using System = step03::System;
  static void forces(const Cloth& cloth, const State& state, System& system) {
    step03::forces(cloth, state, system);
  }
  static void solve(const Cloth& cloth, double h, const State&, System& system) {
    step03::solve(cloth, h, system);
  }
  static void time_step(Cloth& cloth, double h, State& state, System& system) {
    step03::time_step(cloth, h, state, system);
  }
};

struct Five {
  using System = step05::System;
  static void forces(const Cloth& cloth, const State& state, System& system) {
    step05::forces(cloth, state, system);
  }
  static void solve(const Cloth& cloth, double h, const State& state, System& system) {
    step05::solve(cloth, h, state.v, system);
  }
  static void time_step(Cloth& cloth, double h, State& state, System& system) {
    step05::time_step(cloth, h, state, system);
  }
};

// The step itself adds all of the second derivatives for `full`.
Filter filter_of(Way way) {
  if (way == Way::full) return Filter::tension;
  return way == Way::on_demand ? Filter::full : Filter(way);
}
Method method_of(Way way, int newton) {
  return {.jacobian = way == Way::full ? Jacobian::bw98 : Jacobian::definite, .newton = newton};
}

template <class Step>
class Filtered : public WaySimulator {
 public:
  Filtered(Way way_, Cloth& cloth_, int newton)
      : way(way_), cloth(cloth_), system(cloth, method_of(way, newton)), aside(cloth),
        ldlt(make_direct_solver("ldlt", aside.A, cloth.inverse_mass)) {
    if (damped(cloth)) throw std::invalid_argument("no way here has damping");
  }

  void step(double h, State& state) override {
    filter = filter_of(way);
    uses = {};
    redone_before = system.counts.redone;
    if (way == Way::on_demand) system.counts.indefinite.then = [&] { solve_again(h, state); };
    Step::time_step(cloth, h, state, system);
    counted.systems += uses.systems;
    counted.iterations += uses.iterations;
    counted.halvings += uses.halvings();
  }

  WayCounts counts() const override {
    WayCounts all = counted;
    all.indefinite = system.counts.indefinite.count;
    all.cg = system.counts.iterations;
    all.redone = system.counts.redone;
    all.unconverged = system.counts.unconverged;
    return all;
  }

  bool full_is_definite(double h, const State& state) override {
    filter = Filter::full;
    Step::forces(cloth, state, aside);
    aside.A.set_diagonal(cloth.mass);
    aside.A.add(-h * h, aside.K);
    return ldlt->solve(aside.A, aside.f, aside.dv);
  }

 private:
  bool in_newton() const {
    return system.method.newton > 1 || system.counts.redone > redone_before;
  }

  // The same system with the definite matrix. Newton's b has no K.
  void solve_again(double h, const State& state) {
    if (filter == Filter::tension) return;
    filter = Filter::tension;
    Step::forces(cloth, in_newton() ? system.trial : state, system);
    if (!in_newton()) {
      system.K.multiply(state.v, system.b);
      system.b = h * (system.f + h * system.b);
    }
    Step::solve(cloth, h, state, system);
    filter = Filter::full;
  }

  Way way;
  Cloth& cloth;
  typename Step::System system, aside;
  std::unique_ptr<DirectSolver> ldlt;
  long redone_before = 0;
  WayCounts counted;
};

}  // namespace

std::unique_ptr<WaySimulator> make_way(Way way, int step, Cloth& cloth, int newton) {
  if (step == 3) return std::make_unique<Filtered<Three>>(way, cloth, newton);
  if (step == 5) return std::make_unique<Filtered<Five>>(way, cloth, newton);
  throw std::invalid_argument("no way here is of step " + std::to_string(step));
}

}  // namespace extremes
