// The figures in the lesson of step 2.
#include "math/stable_step.h"
#include "step02_damping/time_step.h"
#include "tests/lesson/figures/figures.h"
#include "tests/lesson/figures/mass_on_a_spring.h"

namespace {

using namespace figures;

const std::string grey = "#777777";  // of words, which need more contrast than lines

// A damper acts on a change of length alone -------------------------------------------------------

// A spring with a damper beside it, from left to right.
void draw_spring_and_damper(Svg& svg, Point left, Point right) {
  const double width = right.x - left.x;
  const auto at = [&](double part, double up) { return Point{left.x + part * width, left.y - up}; };
  for (const double end : {0.0, 1.0}) {
    const double inside = end == 0 ? 0.18 : 0.82;
    svg.line(at(end, 0), at(inside, 0), {ink, 2});
    svg.line(at(inside, -12), at(inside, 12), {ink, 2});
  }
  std::vector<Point> zigzag = {at(0.18, 12), at(0.28, 12)};
  for (int i = 0; i < 8; ++i) zigzag.push_back(at(0.3 + 0.057 * i, i % 2 == 0 ? 19 : 5));
  zigzag.push_back(at(0.72, 12));
  zigzag.push_back(at(0.82, 12));
  svg.path(zigzag, {ink, 2});
  svg.path({at(0.62, -5), at(0.38, -5), at(0.38, -19), at(0.62, -19)}, {ink, 2});  // the cylinder
  svg.line(at(0.18, -12), at(0.38, -12), {ink, 2});
  svg.line(at(0.52, -7), at(0.52, -17), {ink, 4});  // and its piston
  svg.line(at(0.52, -12), at(0.82, -12), {ink, 2});
}

// Two free masses on a spring of its length at rest, with the velocities v0 and v1: the arrows of these and of
// the forces, which damping alone causes here.
void draw_motion(Svg& svg, double middle, const Vec3& v0, const Vec3& v1, const std::string& motion,
                 const std::string& force) {
  Cloth cloth = mass_on_a_spring(0.4);
  cloth.inverse_mass.setOnes();
  State state = moved(0, 0);
  state.v << v0, v1;
  step02::System system(cloth);
  step02::forces(cloth, state, system);

  const std::array<Point, 2> masses = {{{middle - 55, 100}, {middle + 55, 100}}};
  draw_spring_and_damper(svg, masses[0], masses[1]);
  for (const std::size_t i : {0, 1}) {
    const auto arrow = [&](const VecX& vector, double scale, double below,
                           const std::string& colour) {
      const Vec3 a = scale * vector.segment<3>(3 * Eigen::Index(i));
      if (a.norm() == 0) return;
      const Point from = masses[i] + Point{0, below};
      svg.arrow(from, from + Point{a[0], -a[1]}, {colour, 4});
    };
    arrow(state.v, 42, 0, blue);
    arrow(system.f, 26, 32, orange);
    svg.dot(masses[i], 9);
  }
  svg.label({middle, 196}, motion, ink, "middle", 16);
  svg.label({middle, 220}, force, ink, "middle", 15);
}

Svg motions() {
  Svg svg(720, 240);
  draw_motion(svg, 120, {0, -1, 0}, {0, -1, 0}, "falls", "Ċ = 0, no force");
  draw_motion(svg, 360, {0, -1, 0}, {0, 1, 0}, "turns", "Ċ = 0, no force");
  draw_motion(svg, 590, {-1, 0, 0}, {1, 0, 0}, "grows longer", "Ċ > 0, the damper pulls back");
  svg.label({216, 28}, "v", blue);
  svg.label({232, 28}, "velocity", blue, "start", 15);
  svg.label({356, 28}, "d", orange);
  svg.label({372, 28}, "damping force", orange, "start", 15);
  return svg;
}

// One vibration ----------------------------------------------------------------------------------

// The states at the beginning and after each step, with ω = 1/s.
std::vector<State> motion(double zeta, double h_omega, int steps, State state) {
  const Cloth cloth = mass_on_a_spring(zeta);
  step02::System system(cloth);
  std::vector<State> states = {state};
  for (int n = 0; n < steps; ++n) {
    step02::time_step(cloth, h_omega, state, system);
    states.push_back(state);
  }
  return states;
}

double energy(const State& state) {
  return (x_of(state) * x_of(state) + v_of(state) * v_of(state)) / 2;
}

// Elongation and energy against time, without damping and with a little of it.
Svg vibration() {
  Svg svg(720, 380);
  const double h = 0.005, end = 30;
  const auto draw = [&](const Scale& at, double zeta, const auto& value, const Stroke& stroke) {
    std::vector<Point> points;
    const std::vector<State> states = motion(zeta, h, int(end / h), moved(1, h / 2));
    for (std::size_t n = 0; n < states.size(); n += 20)
      points.push_back(at(h * double(n), value(states[n])));
    svg.path(points, stroke);
  };
  const Scale x = {{60, 110}, 20, 80}, E = {{60, 340}, 20, 220};
  svg.arrow(x(0, 0), x(32, 0), {pale, 1.5});
  svg.arrow(x(0, -1.1), x(0, 1.25), {pale, 1.5});
  svg.arrow(E(0, 0), E(32, 0), {pale, 1.5});
  svg.arrow(E(0, 0), E(0, 0.62), {pale, 1.5});
  for (const auto& [zeta, colour] : {std::pair{0.0, pale}, {0.06, blue}}) {
    draw(x, zeta, x_of, {colour, 2});
    draw(E, zeta, energy, {colour, 2});
  }
  svg.label(x(0, 1.1) + Point{-20, 0}, "x");
  svg.label(E(0, 0.62) + Point{8, 6}, "energy", grey, "start", 15);
  svg.label(x(32.4, 0) + Point{4, 5}, "t");
  svg.label(E(32.4, 0) + Point{4, 5}, "t");
  svg.label(E(16, 0.5) + Point{0, -8}, "without damping: the energy stays", grey, "middle", 15);
  svg.label(E(10.5, 0.2), "with damping: it can only fall", blue, "start", 15);
  return svg;
}

// Left: the velocity in each step, damped so strongly that one step turns it round. Right: the longest stable
// step against the damping ratio.
Svg limit() {
  Svg svg(720, 350);
  const double zeta = 2, stable = 0.25, too_long = 0.55;
  const Scale v = {{50, 175}, 50, 26};
  svg.arrow(v(0, 0), v(6.0, 0), {pale, 1.5});
  svg.arrow(v(0, -5.4), v(0, 5.4), {pale, 1.5});
  const auto draw = [&](double damping, double h_omega, const std::string& colour) {
    std::vector<Point> points;
    for (const State& state : motion(damping, h_omega, 5, moved(0, 1)))
      points.push_back(v(double(points.size()), v_of(state)));
    svg.path(points, {colour, 2});
    for (const Point& p : points) svg.dot(p, 4.5, colour);
  };
  draw(0, too_long, pale);
  draw(zeta, stable, blue);
  draw(zeta, too_long, orange);
  svg.label(v(0, 5.4) + Point{-18, 12}, "v");
  svg.label(v(6.0, 0) + Point{-4, -10}, "step", ink, "middle", 15);
  svg.label({72, 24}, text("ζ = %g, h ω = %g", zeta, too_long), orange, "start", 15);
  svg.label({72, 46}, text("ζ = %g, h ω = %g", zeta, stable), blue, "start", 15);
  svg.label({72, 68}, text("ζ = 0, h ω = %g", too_long), grey, "start", 15);

  const Scale at = {{430, 305}, 120, 130};
  std::vector<Point> border;
  for (double z = 0; z < 2.11; z += 0.02) border.push_back(at(z, 2 * (std::sqrt(1 + z * z) - z)));
  std::vector<Point> area = border;
  area.push_back(at(2.1, 0));
  area.push_back(at(0, 0));
  svg.path(area, {faint, 0}, faint);
  svg.path(border, {ink, 2});
  svg.arrow(at(0, 0), at(2.25, 0), {pale, 1.5});
  svg.arrow(at(0, 0), at(0, 2.25), {pale, 1.5});
  for (const double z : {0.0, 0.25, 0.5, 1.0, 1.5, 2.0}) {
    const Cloth cloth = mass_on_a_spring(z);
    step02::System system(cloth);
    svg.dot(at(z, critical_step(cloth, moved(0, 0), step02::forces, system)), 4.5);
  }
  svg.dot(at(zeta, stable), 5, blue);
  svg.dot(at(zeta, too_long), 5, orange);
  svg.label(at(0, 2.25) + Point{-22, 12}, "h ω");
  svg.label(at(2.25, 0) + Point{4, 22}, "ζ");
  svg.label(at(0, 2) + Point{-14, 6}, "2");
  svg.label(at(2, 0) + Point{0, 22}, "2");
  svg.label(at(0.5, 0.45), "stable", ink, "middle", 16);
  svg.label(at(1.25, 1.3), "explodes", ink, "middle", 16);
  return svg;
}

}  // namespace

int main(int argc, char** argv) {
  return figures::run(
      argc, argv, FIGURES,
      {{"motions.svg", motions}, {"vibration.svg", vibration}, {"limit.svg", limit}});
}
