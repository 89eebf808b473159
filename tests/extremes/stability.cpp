#include "extremes/stability.h"

#include <algorithm>
#include <cmath>

#include "program/diagnostics.h"
#include "scene/hinges.h"
#include "support/extreme_scenes.h"

namespace extremes {
namespace {

constexpr double size = 1, buckled = 0.01;  // m

TestScene scene_of(const MapWay& map, MapScene kind, double k, const Watch& watch) {
  TestScene scene = kind == MapScene::strip
                        ? pushed_strip(k)
                        : sheet(watch.cells, Held::by_two_corners, k, k, Gravity::on);
  if (map.configuration.step == 2)
    for_each_term(scene.cloth, [&](auto& term) {
      if (term) term->kd = damping_time * k;
    });
  if (map.configuration.step == 5) {
    scene.cloth.hinges.elements = make_hinges(scene.mesh);
    scene.cloth.term<DihedralBend>() = DihedralBend(bend_stiffness);
  }
  return scene;
}

bool is_explicit(const MapWay& map) {
  return map.configuration.step <= 2;
}

int steps_of(const MapWay& map, MapScene kind, double h, const Watch& watch) {
  const int most = watch.most * (is_explicit(map) || kind == MapScene::strip ? 100 : 1);
  return int(std::clamp(watch.seconds / h, double(watch.fewest), double(most)));
}

double height(const VecX& x) {
  double y = 0;
  for (Eigen::Index i = 1; i < x.size(); i += 3) y = std::max(y, std::abs(x[i]));
  return y;
}

// The negated comparisons record a NaN, too.
void look(const TestScene& scene, const State& state, double E_start, double scale, Cell& cell) {
  const double gain = (energies(scene.cloth, state).total() - E_start) / scale;
  cell.last = max_stretch(scene.mesh, state.x);
  if (!(gain <= cell.gain)) cell.gain = gain;
  if (!(cell.last <= cell.stretch)) cell.stretch = cell.last;
  cell.height = std::max(cell.height, height(state.x));
}

Verdict judge(const Cell& cell, MapScene kind) {
  if (!(cell.stretch <= exploded_stretch && cell.last <= 20)) return Verdict::exploded;
  if (kind == MapScene::strip && cell.height <= buckled) return Verdict::frozen;
  if (cell.capped > 0) return Verdict::capped;
  return cell.gain > 1e-3 ? Verdict::gains : Verdict::stable;
}

}  // namespace

const std::vector<MapWay>& map_ways() {
  const auto cg = [](const char* preconditioner) {
    return Method{.preconditioner = preconditioner, .max_iterations = 1000};
  };
  static const std::vector<MapWay> all = {
      {"step01", "Step 1: explicit", "explodes beyond the line", {1}},
      {"step02", "Step 2: with damping", "explodes earlier where it is strong", {2}},
      {"step03_bw98",
       "Step 3: implicit, the printed matrix",
       "explodes at long steps, and freezes",
       {3, {.jacobian = Jacobian::bw98}}},
      {"step03_bare",
       "Step 3: the definite matrix alone",
       "gains energy, explodes at h = 1 s",
       {3, {.guard = false}}},
      {"step03", "Step 3: the definite matrix, guarded", "stable everywhere", {3}},
      {"step03_newton",
       "Step 3: up to 20 Newton iterations",
       "stable everywhere",
       {3, {.newton = 20}},
       false},
      {"step04_block",
       "Step 4: conjugate gradients, blocks",
       "stable everywhere",
       {4, cg("block")}},
      {"step04_multigrid",
       "Step 4: conjugate gradients, multigrid",
       "stable everywhere",
       {4, cg("multigrid")}},
      {"step05", "Step 5: bending", "stable but for two cells", {5, cg("multigrid")}}};
  return all;
}

Cell watch_cell(const MapWay& map, MapScene kind, double h, double k, const Watch& watch) {
  TestScene scene = scene_of(map, kind, k, watch);
  const auto simulator = make_simulator(map.configuration, scene.cloth);
  State state = scene.start;
  const double E_start = energies(scene.cloth, state).total();
  const double scale = kind == MapScene::strip ? E_start : scene.cloth.mass.sum() / 3 * g * size;

  const int steps = steps_of(map, kind, h, watch), every = is_explicit(map) ? 20 : 1;
  const int after = 60;  // steps for which a buckled strip is still watched
  Cell cell;
  for (int left = steps; left > 0 && cell.stretch <= exploded_stretch; --left) {
    simulator->step(h, state);
    ++cell.steps;
    if (cell.steps % every != 0 && left > 1) continue;
    const bool was_flat = cell.height <= buckled;
    look(scene, state, E_start, scale, cell);
    if (kind == MapScene::strip && was_flat && cell.height > buckled) left = std::min(left, after);
  }
  cell.indefinite = simulator->counts().indefinite;
  cell.capped = simulator->counts().capped;
  cell.redone = simulator->counts().redone;
  cell.verdict = judge(cell, kind);
  return cell;
}

double explicit_limit(const MapWay& map, double k, const Watch& watch) {
  TestScene scene = scene_of(map, MapScene::drop, k, watch);
  const auto simulator = make_simulator(map.configuration, scene.cloth);
  return critical_step(*simulator, scene.cloth, scene.start);
}

}  // namespace extremes
