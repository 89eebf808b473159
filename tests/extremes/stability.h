// The verdict on a cloth at a time step h and a stiffness k: one cell of stability_map.
#pragma once
#include <array>
#include <string>
#include <vector>

#include "ways/simulator.h"

namespace extremes {

// In order of severity: if several verdicts hold, the first one counts. Nothing else matters for a
// cloth that exploded. A system that the solver left unsolved can itself cause a gain of energy, so
// `capped` comes before `gains`.
enum class Verdict {
  exploded,  // not finite, or a stretch over 1000 at any time or over 20 at the end
  frozen,    // the compressed strip did not buckle
  capped,    // conjugate gradients reached the iteration limit in some step
  gains,     // the energy exceeds that of the start by over 1e-3 of the scale below
  stable
};
inline constexpr std::array all_verdicts = {Verdict::exploded, Verdict::frozen, Verdict::capped,
                                            Verdict::gains, Verdict::stable};

inline const char* name(Verdict verdict) {
  return std::array{"exploded", "frozen", "capped", "gains", "stable"}[size_t(verdict)];
}
inline char letter(Verdict verdict) {
  return std::array{'X', 'F', 'C', '+', '.'}[size_t(verdict)];
}

struct MapWay {
  const char* name;             // in files and on the terminal
  const char *title, *finding;  // in pictures: the name of the map, and its result
  Configuration configuration;
  bool drawn = true;  // in the picture
};
// One map for each step. Step 3 has four: with the printed matrix, with the definite matrix alone, with
// the guard, as it is by default, and with up to 20 Newton iterations. Step 4 has two: with block Jacobi
// and with multigrid.
const std::vector<MapWay>& map_ways();

// Two scenes. The drop: a flat square metre of cells × cells with k_shear = k falls, held by two
// corners. Its scale of energy is m g L. The strip: 1 m long, 3 × 12 cells, without gravity, its
// ends held at 70 % of its length. Its scale is its energy at the start. It has buckled when a
// vertex is 1 cm out of its plane; a strip that buckles in a zigzag need not go beyond 6 cm. Step 2
// is damped by kd = k · 1e-4 s, step 5 has hinges of 0.01 N·m. All else is equal.
enum class MapScene { drop, strip };
inline const char* name(MapScene scene) {
  return scene == MapScene::drop ? "drop" : "strip";
}
inline constexpr double damping_time = 1e-4, bend_stiffness = 0.01;  // s, N·m

// How long a cloth is watched: `seconds`, but at least `fewest` and at most `most` steps, so that
// runs with short steps end earlier. An explicit drop may take 100 times `most` steps, because its
// steps are cheap. So may every strip, because its run ends soon after it has buckled.
struct Watch {
  int cells = 8;
  double seconds = 1;
  int fewest = 60, most = 1000;
};

struct Cell {
  Verdict verdict = Verdict::stable;
  double gain = 0;               // the largest E − E_0, divided by the scale
  double stretch = 0, last = 0;  // the largest in all steps, and after the last step
  double height = 0;             // m, the largest; for the strip
  int steps = 0;
  long indefinite = 0, capped = 0, redone = 0;
};
Cell watch_cell(const MapWay&, MapScene, double h, double k, const Watch&);

// The h at which h ω_max = 2 at the start of the drop, with its damping and its hinges: the longest
// step of symplectic Euler.
double explicit_limit(const MapWay&, double k, const Watch&);

}  // namespace extremes
