// What becomes of a cloth at a time step h and a stiffness k, in one word: the cells of stability_map.
#pragma once
#include <array>
#include <string>
#include <vector>

#include "ways/simulator.h"

namespace extremes {

// In this order of gravity, where several hold: of a cloth that exploded nothing else is of interest, and
// what a solver left unsolved may gain energy, or be stiff, for that reason alone.
enum class Verdict {
  exploded,  // not finite, or a thread over 1000 times its length, or over 20 times in the end
  frozen,    // a clamped strip that must buckle and did not
  capped,    // conjugate gradients reached their most iterations, in any step
  gains,     // more energy than at the start, by over 1e-3 of the scale below
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
  const char *title, *finding;  // in pictures: what it is, and what is to be seen
  Configuration configuration;
};
// What the maps compare: every step, and step 3 with the printed matrix, with the definite one, and with
// many Newton iterations instead of one.
const std::vector<MapWay>& map_ways();

// Two scenes. The drop: a square metre of cells × cells, k_shear = k, flat, falls, held by two corners;
// energies are measured by m g L. The strip: a metre of 3 × 12 cells whose ends are held at 70 % of its
// length; without gravity, and its energies are measured by that at the start. It has buckled when a
// vertex has come 1 cm out of its plane: in zigzag, it need come no farther than 6 cm. Step 2 is damped by
// kd = k · 1e-4 s, step 5 has hinges of 0.01 N·m; all else is equal.
enum class MapScene { drop, strip };
inline const char* name(MapScene scene) {
  return scene == MapScene::drop ? "drop" : "strip";
}
inline constexpr double damping_time = 1e-4, bend_stiffness = 0.01;  // s, N·m

// How long a cloth is watched: `seconds`, but at least `fewest` steps and at most `most`, so that short
// steps see less of its fall. A hundred times as many steps of a drop are affordable if they are explicit,
// and of a strip, which is left when it has buckled, all are.
struct Watch {
  int cells = 8;
  double seconds = 1;
  int fewest = 60, most = 1000;
};

struct Cell {
  Verdict verdict = Verdict::stable;
  double gain = 0;               // the largest E − E_0, of the scale
  double stretch = 0, last = 0;  // the largest of all steps, and after the last
  double height = 0;             // m, the largest; of a strip
  int steps = 0;
  long indefinite = 0, capped = 0;
};
Cell watch_cell(const MapWay&, MapScene, double h, double k, const Watch&);

// The h at which h ω_max = 2 in the drop as it begins, its damping and its hinges included: the longest
// step of symplectic Euler.
double explicit_limit(const MapWay&, double k, const Watch&);

}  // namespace extremes
