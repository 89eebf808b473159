// Bending of every stiffness, from 0 to 100 N·m (a board), from starts that must break no step. And
// folds beyond the full fold, θ = π.
#include <gtest/gtest.h>

#include <cstdio>

#include "scene/hinges.h"
#include "step05_bend/time_step.h"
#include "support/outcome.h"

namespace extremes::bend_test {

TestScene bending(TestScene scene, double k) {
  scene.cloth.hinges.elements = make_hinges(scene.mesh);
  scene.cloth.term<DihedralBend>() = DihedralBend(k);
  return scene;
}

double highest_speed(const State& state) {
  double speed = 0;
  for (Eigen::Index i = 0; i < state.v.size(); i += 3)
    speed = std::max(speed, state.v.segment<3>(i).norm());
  return speed;
}

// How many full turns the most folded hinge has made.
double most_turns(const Hinges& hinges) {
  double largest = 0;
  for (const Hinge& hinge : hinges.elements) largest = std::max(largest, std::abs(hinge.theta));
  return largest / (2 * pi);
}

struct Start {
  const char* name;
  MakeScene make;
};
const std::vector<Start> starts = {{"dropped", dropped},     {"squeezed", squeezed},
                                   {"tangled", tangled},     {"coincident", coincident},
                                   {"collapsed", collapsed}, {"shot", shot}};

// A squeezed, collapsed or shot cloth passes through itself in its first steps and winds up its hinges, or
// begins with flaps that are lines. If the threads are much stiffer than the folds, they pull the cloth
// flat again. A board of soft threads stays as it is: where no motion lowers the energy it stands still.
bool unwinds(const Start& start, double k, double k_bend) {
  return (start.make != squeezed && start.make != collapsed && start.make != shot) ||
         k_bend <= 1e-4 * k;
}

// 60 steps. At h = 0.1 s these are 6 s, and such long steps damp all motion in that time.
void expect_survived(const Start& start, double h, double k, double k_bend) {
  const TestScene scene = bending(start.make(k), k_bend);
  Method method;
  method.preconditioner = "multigrid";
  step05::System system(scene.cloth, method);
  double turns = 0;
  const auto step = [&](Cloth& cloth, double dt, State& state, step05::System& its) {
    step05::time_step(cloth, dt, state, its);
    turns = most_turns(cloth.hinges);
  };
  const Outcome o = watch(scene, h, 60, system, step);
  const double speed = highest_speed(o.end);
  std::printf("%-11s %8.4f %6.0e %6.0e  %10ld %9.2e %9.4f %9.3f %6.1f\n", start.name, h, k, k_bend,
              system.counts.iterations, o.gain, o.last, speed, turns);
  EXPECT_TRUE(o.finite);
  EXPECT_EQ(o.indefinite, 0);
  EXPECT_EQ(system.counts.capped, 0);
  if (!unwinds(start, k, k_bend) || h < 0.01) return;
  EXPECT_LT(o.last, h < 0.1 ? 1.5 : 1.3);  // at rest 1.14; measured 1.29 and 1.21
  EXPECT_LT(speed, h < 0.1 ? 6 : 1);       // m/s; measured 3.8 and 0.41
}

// A random tangle starts with its hinges wound up, so tangles run only without bending.
TEST(Bending, OfEveryStiffnessSurvivesTheWorstStarts) {
  std::printf("%-11s %8s %6s %6s  %10s %9s %9s %9s %6s\n", "start", "h/s", "k", "k bend",
              "iterations", "gain/J", "last", "m/s", "turns");
  for (const Start& start : starts)
    for (const double h : {1e-3, 1.0 / 60, 0.1})
      for (const double k : {1e2, 1e5})
        for (const double k_bend : {0.0, 1e-4, 1e-2, 1.0, 1e2}) {
          if (start.make == tangled && k_bend > 0) continue;
          SCOPED_TRACE(std::string(start.name) + ", h = " + std::to_string(h) +
                       ", k = " + std::to_string(k) + ", in bending " + std::to_string(k_bend));
          expect_survived(start, h, k, k_bend);
        }
}

// A strip of 3 × 12 cells whose two long sides are held. The pins of the upper half move on
// circles about the middle of the strip: into the lower half, through it, and on. The vertices
// between the sides are free.
class CarriedFold {
 public:
  explicit CarriedFold(BendModel bend_model) {
    const Mesh mesh = make_grid({0.25, 1}, {3, cells}, Diagonals::same);
    Model m = model(1e3, 1e3, Gravity::off);
    m.pins = where(mesh, [](double u, double) { return u == 0 || u == 0.25; });
    add_bend(m, bend_model, k);
    scene = at_rest(mesh, m);
    system.emplace(scene.cloth);
  }

  // One step, in which the fold goes from phi to phi + dphi.
  void carry(double phi, double dphi, double h) {
    for (Pin& pin : scene.cloth.pins) pin.velocity = (place(pin, phi + dphi) - place(pin, phi)) / h;
    step05::time_step(scene.cloth, h, scene.start, *system);
  }

  double bend_energy() const {
    double joule = 0;
    add_elastic_energy(scene.cloth.hinges, scene.cloth.hinges.elements, scene.start.x, joule);
    return joule;
  }

  // The energy of a sharp fold: three edges bend by the angle phi. Bridson's σ is 1/2 if
  // the flaps are half squares.
  double sharp_energy(double phi) const {
    if (scene.cloth.term<DihedralBend>()) return 3 * k / 2 * phi * phi;
    return 3 * 2 * k * std::pow(std::sin(phi / 4), 2);
  }

 private:
  static constexpr double k = 1e-3;  // N·m

  Vec3 place(const Pin& pin, double phi) const {
    const Vec3 x = scene.mesh.x.segment<3>(3 * pin.vertex);
    const double above = std::max(-x.z() - 0.5, 0.0), below = std::min(-x.z(), 0.5);
    return {x.x(), -above * std::sin(phi), -below - above * std::cos(phi)};
  }

  TestScene scene;
  std::optional<step05::System> system;
};

// The fold moves to 5 rad, at 1 rad/s. The energy grows in every step; it would fall if the angle
// jumped from π to −π. The free vertices round the fold off and so lower its energy by up to 16 %.
TEST(Bending, AFoldThatIsCarriedBeyondAFullOneStoresMoreAndMore) {
  for (const BendModel model : {BendModel::dihedral, BendModel::bridson})
    for (const double direction : {1.0, -1.0}) {
      CarriedFold fold(model);
      double before = 0;
      for (int step = 0; step < 500; ++step) {
        fold.carry(direction * 0.01 * step, direction * 0.01, 0.01);
        const double phi = 0.01 * (step + 1), E = fold.bend_energy();
        if (phi > 0.5) {  // the motion starts with a jerk
          EXPECT_GT(E, before) << phi;
          EXPECT_LT(E, fold.sharp_energy(phi)) << phi;
          EXPECT_GT(E, 0.8 * fold.sharp_energy(phi)) << phi;
        }
        before = E;
      }
    }
}

}  // namespace extremes::bend_test
