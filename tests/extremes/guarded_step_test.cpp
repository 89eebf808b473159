// The guarded step at its extremes: dropped and pressed sheets, pins, folds at π, frames of reference, sizes.
#include <gtest/gtest.h>

#include <cmath>

#include "scene/hinges.h"
#include "step03_implicit/time_step.h"
#include "support/outcome.h"
#include "ways/simulator.h"

namespace extremes::guarded_step_test {

struct Motion {
  double gain = 0;   // J, the largest above the energy at the start
  double last = 0;   // the largest stretch at the end
  double total = 0;  // J, at the end
  Counts counts;
  State end;
};

Motion run(TestScene scene, const Configuration& configuration, double h, int steps) {
  const auto simulator = make_simulator(configuration, scene.cloth);
  Motion r;
  r.end = scene.start;
  const double E_start = energies(scene.cloth, r.end).total();
  for (int n = 0; n < steps; ++n) {
    simulator->step(h, r.end);
    r.total = energies(scene.cloth, r.end).total();
    r.gain = std::max(r.gain, std::isfinite(r.total) ? r.total - E_start : 1e300);
  }
  r.last = max_stretch(scene.mesh, r.end.x);
  r.counts = simulator->counts();
  return r;
}

TestScene with_bending(TestScene scene, double k) {
  scene.cloth.hinges.elements = make_hinges(scene.mesh);
  scene.cloth.term<DihedralBend>() = DihedralBend(k);
  start_angles(scene.cloth.hinges.elements, scene.start.x);
  return scene;
}

const Method bare = {.guard = false}, ic = {.preconditioner = "ic"};

// The finer the mesh, the farther one linear system throws a flat cloth that falls past its pins.
TEST(GuardedDrop, GainsNoEnergyOnAnyMesh) {
  for (const int n : {8, 16, 32})
    for (const double h : {0.1, 1.0}) {
      const TestScene scene = sheet(n, Held::by_two_corners, 1e3, 1e3, Gravity::on);
      const Motion guarded = run(scene, {3}, h, 30);
      EXPECT_EQ(guarded.gain, 0) << n << " cells, h = " << h;
      EXPECT_LT(guarded.last, 1.1) << n << " cells, h = " << h;
      EXPECT_GT(guarded.counts.redone, 0);
      if (n < 32) {
        EXPECT_GT(run(scene, {3, bare}, h, 4).gain, 100) << n << " cells, h = " << h;
      }
    }
}

// The cure matters as much as the test. Halving the velocities until the guard is content is safe, too, but
// slows the whole cloth for the sake of a few vertices.
void halved_step(const Cloth& cloth, double h, State& state, step03::System& system) {
  step03::time_step(cloth, h, state, system);
  while (step03::gains_energy(cloth, h, state.v, system)) state.v = (state.v + system.z) / 2;
  state.x = system.start.x + h * state.v;
}

// 15 steps of a frame each, compared with 10 000 explicit steps.
TEST(GuardedDrop, IsNearerToTheTruthThanOneLinearSystemAndHalvingIsFarther) {
  const TestScene scene = sheet(16, Held::by_two_corners, 1e3, 5e2, Gravity::on);
  const double h = 1.0 / 30;
  const int steps = 15;
  const VecX truth = run(scene, {1}, h * steps / 10000, 10000).end.x;
  const auto distance = [&](const VecX& x) {
    return std::sqrt((x - truth).squaredNorm() / scene.cloth.vertices());
  };
  step03::System system(scene.cloth, bare);
  const double halved = distance(watch(scene, h, steps, system, halved_step).end.x),
               alone = distance(run(scene, {3, bare}, h, steps).end.x),
               guarded = distance(run(scene, {3}, h, steps).end.x),
               newton = distance(run(scene, {3, {.newton = 50}}, h, steps).end.x);
  std::printf("distance to the truth, m: one system %.3f, halved %.3f, guarded %.3f, Newton %.3f\n",
              alone, halved, guarded, newton);
  EXPECT_NEAR(alone, 0.196, 0.02);
  EXPECT_NEAR(halved, 0.500, 0.02);
  EXPECT_NEAR(guarded, 0.079, 0.004);
  EXPECT_NEAR(newton, 0.076, 0.004);
}

// A sheet whose two sides are held at 70 % of their distance buckles. A little bending makes the flat sheet
// fold in one step, and one linear system is not enough for that.
TEST(GuardedPress, GainsNoEnergyWithALittleBending) {
  const Mesh mesh = make_grid({1, 1}, {16, 16}, Diagonals::same);
  Model m = model(1e4, 1e4, Gravity::off);
  m.pins = where(mesh, [](double u, double) { return u == 0 || u == 1; });
  TestScene scene = at_rest(mesh, m);
  scene.start.x =
      field(mesh, [](double u, double v) { return Vec3(0.7 * u, 1e-6 * std::sin(pi * u), -v); });
  scene = with_bending(scene, 1e-3);
  const Motion guarded = run(scene, {5}, 0.01, 40), without = run(scene, {5, bare}, 0.01, 10);
  EXPECT_EQ(guarded.gain, 0);
  EXPECT_LT(guarded.last, 1.1);
  EXPECT_GT(without.gain, 100);
}

TEST(GuardedStarts, GainNoEnergy) {
  for (const int step : {3, 4, 5})
    for (const double h : {0.01, 0.1}) {
      EXPECT_EQ(run(shot(1e3), {step, ic}, h, 30).gain, 0) << "shot, h = " << h;
      EXPECT_EQ(run(squeezed(1e3), {step, ic}, h, 30).gain, 0) << "squeezed, h = " << h;
    }
}

// What stands still has only the energy of rounding, and rounding is no gain.
TEST(GuardedPins, ASheetAtRestIsNeverTakenAgain) {
  const TestScene scene = sheet(10, Held::by_two_corners, 1e3, 1e3, Gravity::off);
  for (const int step : {3, 4, 5})
    EXPECT_EQ(run(scene, {step}, 0.01, 50).counts.redone, 0) << "step " << step;
}

// One corner is held, one slides along y. The guard compares with a cloth that stands still. If that cloth
// followed the sliding pin down, it would gain energy, and so could the step.
TEST(GuardedPins, ACornerThatSlidesGainsNoEnergy) {
  TestScene scene = sheet(8, Held::free, 1e3, 1e3, Gravity::on);
  scene.cloth.pins = {Pin(72), Pin(80, Vec3::UnitY().asDiagonal())};
  for (const int step : {4, 5}) {
    const Motion guarded = run(scene, {step}, 0.1, 40);
    EXPECT_EQ(guarded.gain, 0) << "step " << step;
    EXPECT_GT(guarded.counts.redone, 0) << "step " << step;
  }
}

// A sheet that lies folded flat on itself, free and without weight, opens and comes to rest.
TestScene folded_flat(double k_bend) {
  TestScene scene = sheet(8, Held::free, 1e3, 1e3, Gravity::off);
  for (Eigen::Index i = 2; i < scene.start.x.size(); i += 3)
    scene.start.x[i] = -0.5 + std::abs(scene.start.x[i] + 0.5);
  return with_bending(scene, k_bend);
}

TEST(FoldedFlat, Opens) {
  for (const double k_bend : {0.1, 1.0, 10.0, 100.0}) {
    const TestScene scene = folded_flat(k_bend);
    const double E_start = energies(scene.cloth, scene.start).total();
    EXPECT_NEAR(E_start, 8 * k_bend / 2 * pi * pi, 1e-6 * E_start);
    const Motion r = run(scene, {5}, 0.01, 100);
    EXPECT_LT(r.gain, 1e-9 * E_start) << "k_bend = " << k_bend;
    EXPECT_LT(r.total, 0.02 * E_start) << "k_bend = " << k_bend;
    EXPECT_LT(r.last, 1.02) << "k_bend = " << k_bend;
  }
}

// Three vertices are moved over their neighbours, in the plane of the sheet. Hinges at ±π around them: if
// rounding chose the signs, the hinges would push against each other for ever.
TEST(FoldedFlat, VerticesThatWereMovedOverTheirNeighboursComeBack) {
  for (const double k_bend : {0.1, 100.0}) {
    TestScene scene = sheet(16, Held::by_two_corners, 1e3, 1e3, Gravity::on);
    for (const int i : {8 * 17 + 8, 8 * 17 + 9, 9 * 17 + 8})
      scene.start.x.segment<3>(3 * i) += Vec3(2.5, 0, -1.5) / 16;
    const Motion r = run(with_bending(scene, k_bend), {5}, 0.01, 60);
    EXPECT_EQ(r.gain, 0) << "k_bend = " << k_bend;
    EXPECT_LT(r.total, 2) << "k_bend = " << k_bend;
    EXPECT_LT(r.last, 1.1) << "k_bend = " << k_bend;
  }
}

// Frames of reference ----------------------------------------------------------------------------

// A sheet that spins and waves; with `pinned`, two corners of it move with the frame.
TestScene waving(int step, bool pinned, const Vec3& frame) {
  TestScene scene = sheet(8, Held::free, 1000, 500, Gravity::on);
  if (pinned) scene.cloth.pins = {Pin(0, Mat3::Zero(), frame), Pin(8, Mat3::Zero(), frame)};
  for_each_term(scene.cloth, [](auto& term) {
    if (term) term->kd = 1e-5 * term->k;
  });
  if (step == 5) scene = with_bending(scene, 1e-3);
  for (int i = 0; i < scene.mesh.vertices(); ++i) {
    auto x = scene.start.x.segment<3>(3 * i), v = scene.start.v.segment<3>(3 * i);
    x.y() += 0.02 * std::sin(7 * x.x()) * std::cos(5 * x.z());
    v = frame + Vec3(0, 3, 0).cross(Vec3(x) - Vec3(0.5, 0, -0.5)) + Vec3(0, std::sin(6 * x.x()), 0);
  }
  if (pinned)
    for (const int i : {0, 8}) scene.start.v.segment<3>(3 * i) = frame;
  return scene;
}

// Conjugate gradients add an error of their tolerance, and it depends on rounding: so a small one.
TEST(Frames, OfAllSpeedsSeeTheSameMotion) {
  for (const int step : {3, 4, 5})
    for (const int newton : {1, 50})
      for (const bool pinned : {false, true}) {
        if (pinned && step == 3) continue;  // its pins stand still
        for (const double h : {0.01, 0.05}) {
          const Configuration way = {step, {.newton = newton, .tolerance = 1e-10}};
          const Motion at_rest = run(waving(step, pinned, Vec3::Zero()), way, h, 20);
          for (const double speed : {1.0, 10.0, 100.0, 1000.0}) {
            const Vec3 frame = speed * Vec3(0.48, 0.6, 0.64);
            const Motion moving = run(waving(step, pinned, frame), way, h, 20);
            VecX x = moving.end.x;
            for (Eigen::Index i = 0; i < x.size(); i += 3) x.segment<3>(i) -= 20 * h * frame;
            const double distance = (x - at_rest.end.x).lpNorm<Eigen::Infinity>();
            SCOPED_TRACE("step " + std::to_string(step) + ", " + std::to_string(speed) +
                         " m/s, h = " + std::to_string(h) + (pinned ? ", pinned" : ", free"));
            EXPECT_LT(distance, 1e-7);
            EXPECT_EQ(moving.counts.redone, at_rest.counts.redone);
            EXPECT_EQ(moving.counts.assemblies, at_rest.counts.assemblies);
          }
        }
      }
}

// Sizes ------------------------------------------------------------------------------------------

// A cloth of size s: lengths times s, masses times s², times as they are. So forces grow with s³, and k, a
// force for a length, with s²; a stiffness in bending, an energy for an angle, with s⁴.
TestScene of_size(double s, BendModel bend) {
  const Mesh mesh = make_grid({s, s}, {8, 8}, Diagonals::same);
  Model m = model(1000 * s * s, 500 * s * s, Gravity::off);
  m.gravity = Vec3(0, -8 * s, 0);
  m.pins = {0, 8};
  add_bend(m, bend, bend == BendModel::springs ? 10 * s * s : 0.01 * s * s * s * s);
  TestScene scene = at_rest(mesh, m);
  for (int i = 0; i < mesh.vertices(); ++i) {
    auto x = scene.start.x.segment<3>(3 * i);
    x.y() += 0.1 * s * std::sin(5 * x.x() / s) * std::cos(4 * x.z() / s);
  }
  start_angles(scene.cloth.hinges.elements, scene.start.x);
  return scene;
}

// With s a power of two every number is the same but for its exponent.
TEST(Sizes, AMicrometreOfClothMovesAsAMetre) {
  const double s = std::ldexp(1.0, -20);
  for (const BendModel bend :
       {BendModel::dihedral, BendModel::bridson, BendModel::quadratic, BendModel::springs}) {
    const Motion large = run(of_size(1, bend), {5}, 0.01, 40),
                 small = run(of_size(s, bend), {5}, 0.01, 40);
    EXPECT_GT((large.end.x - of_size(1, bend).start.x).norm(), 1);
    EXPECT_LT((small.end.x / s - large.end.x).lpNorm<Eigen::Infinity>(), 1e-9) << int(bend);
  }
}

}  // namespace extremes::guarded_step_test
