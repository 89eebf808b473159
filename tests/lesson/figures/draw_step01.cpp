// The figures in the lesson of step 1.
#include "step01_explicit/time_step.h"
#include "tests/lesson/figures/figures.h"
#include "tests/lesson/figures/mass_on_a_spring.h"

namespace {

using namespace figures;

using Corners = std::array<Vec3, 3>;

VecX positions(const Corners& x) {
  VecX all(9);
  all << x[0], x[1], x[2];
  return all;
}

// A triangle -------------------------------------------------------------------------------------

// The part of the line u = c (thread 1, along v) or v = c (thread 0, along u) within a triangle of the flat
// cloth: both ends, or nothing.
std::vector<Vec2> thread_within(const std::array<Vec2, 3>& uv, int thread, double c) {
  std::vector<Vec2> ends;
  const int across = 1 - thread;
  for (int i = 0; i < 3; ++i) {
    const Vec2 &a = uv[i], &b = uv[(i + 1) % 3];
    if ((a[across] - c) * (b[across] - c) < 0)
      ends.push_back(a + (c - a[across]) / (b[across] - a[across]) * (b - a));
  }
  return ends;
}

// Where the view shows a point of space: x to the right, y into the picture, z up.
Point seen(const Vec3& x) {
  return {420 + 135 * x[0] + 70 * x[1], 236 - 62 * x[1] - 135 * x[2]};
}

// A triangle on the flat cloth with its threads, and the same triangle in space.
Svg triangle() {
  Svg svg(720, 330);
  const std::array<Vec2, 3> uv = {{{0.15, 0.3}, {1.45, 0.15}, {0.4, 1.4}}};
  const Corners x = {{{0.1, 0.1, -0.05}, {1.45, 0.2, 0.45}, {0.15, 1.1, 0.75}}};
  const Triangle t = make_triangle({0, 1, 2}, uv[0], uv[1], uv[2]);
  const Vecs<2> w = gather(t, positions(x));

  const Scale flat = {{45, 268}, 150, 150};
  const auto in_space = [&](const Vec2& p) {
    return seen(x[0] + (p - uv[0])[0] * w[0] + (p - uv[0])[1] * w[1]);
  };
  const auto on_flat = [&](const Vec2& p) { return flat(p[0], p[1]); };

  svg.path({on_flat(uv[0]), on_flat(uv[1]), on_flat(uv[2])}, {ink, 2}, cloth_cream);
  svg.path({in_space(uv[0]), in_space(uv[1]), in_space(uv[2])}, {ink, 2}, cloth_cream);
  for (const int thread : {0, 1})
    for (double c = 0.3; c < 1.5; c += 0.2)
      if (const std::vector<Vec2> ends = thread_within(uv, thread, c); ends.size() == 2) {
        const Stroke stroke = {thread == 0 ? blue : orange, 1};
        svg.line(on_flat(ends[0]), on_flat(ends[1]), stroke);
        svg.line(in_space(ends[0]), in_space(ends[1]), stroke);
      }

  const Vec2 from(0.5, 0.5), u = from + Vec2(0.4, 0), v = from + Vec2(0, 0.4);
  svg.arrow(on_flat(from), on_flat(u), {blue, 4});
  svg.arrow(on_flat(from), on_flat(v), {orange, 4});
  svg.arrow(in_space(from), in_space(u), {blue, 4});
  svg.arrow(in_space(from), in_space(v), {orange, 4});

  svg.arrow(flat(0, 0), flat(1.6, 0), {pale, 1.5});
  svg.arrow(flat(0, 0), flat(0, 1.5), {pale, 1.5});
  svg.label(flat(1.68, -0.03), "u", blue);
  svg.label(flat(0, 1.56), "v", orange);
  svg.label(on_flat(uv[0]) + Point{-2, 20}, "uv₀");
  svg.label(on_flat(uv[1]) + Point{8, -12}, "uv₁", ink, "start");
  svg.label(on_flat(uv[2]) + Point{0, -10}, "uv₂");
  svg.label(in_space(uv[0]) + Point{-16, 18}, "x₀");
  svg.label(in_space(uv[1]) + Point{18, 6}, "x₁");
  svg.label(in_space(uv[2]) + Point{0, -10}, "x₂");
  svg.note(in_space(u) + Point{14, 18}, "wᵤ", blue);
  svg.note(in_space(v) + Point{-20, 4}, "wᵥ", orange);

  svg.arrow({318, 140}, {398, 140}, {pale, 2});
  svg.label({356, 128}, "F", ink);
  svg.label({160, 314}, "flat cloth, at rest", ink, "middle", 15);
  svg.label({560, 314}, "in space, now", ink, "middle", 15);
  return svg;
}

// The triangle that the lesson works out by hand, with the forces on its corners.
Svg triangle_by_hand() {
  Svg svg(720, 330);
  const Corners rest = {{{0, 0, 0}, {0.1, 0, 0}, {0, 0.1, 0}}},
                now = {{{0, 0, 0}, {0.11, 0, 0}, {0.01, 0.1, 0}}};
  Cloth cloth;
  cloth.mass = VecX::Ones(9);
  cloth.triangles.elements = {make_triangle({0, 1, 2}, {0, 0}, {0.1, 0}, {0, 0.1})};
  cloth.term<StretchTerm>() = StretchTerm(1000);
  cloth.term<ShearTerm>() = ShearTerm(500);
  step01::System system(cloth);
  step01::forces(cloth, {positions(now), VecX::Zero(9)}, system);

  const Scale at = {{215, 265}, 2000, 2000};
  const auto place = [&](const Vec3& x) { return at(x[0], x[1]); };
  svg.path({place(now[0]), place(now[1]), place(now[2])}, {ink, 2}, cloth_cream);
  svg.path({place(rest[0]), place(rest[1]), place(rest[2]), place(rest[0])}, {pale, 2, "6 5"});
  svg.arrow(place(now[0]), place(now[1]), {blue, 3});
  svg.arrow(place(now[0]), place(now[2]), {orange, 3});
  for (const int i : {0, 1, 2}) {
    const Vec3 f = system.f.segment<3>(3 * i);
    svg.arrow(place(now[i]), place(now[i]) + 13.7 * Point{f[0], -f[1]}, {green, 4});
    svg.dot(place(now[i]), 6);
  }
  svg.label(at(0.055, -0.013), "0.1 m wᵤ", blue, "middle", 15);
  svg.label(at(-0.006, 0.05), "0.1 m wᵥ", orange, "end", 15);
  const auto force = [&](std::size_t i) {
    const auto number = [](double f) { return (f < 0 ? "−" : "") + text("%.3f", std::abs(f)); };
    return text("f%s = (%s, %s, 0) N", std::array{"₀", "₁", "₂"}[i],
                number(system.f[3 * i]).c_str(), number(system.f[3 * i + 1]).c_str());
  };
  svg.label(place(now[0]) + Point{-14, 18}, "0");
  svg.label(place(now[1]) + Point{16, 8}, "1");
  svg.label(place(now[2]) + Point{16, -6}, "2");
  for (const std::size_t i : {0, 1, 2})
    svg.label({480, 110 + 34.0 * double(i)}, force(i), green, "start", 16);
  svg.label({480, 76}, "forces on the corners", ink, "start", 15);
  svg.line({480, 222}, {516, 222}, {pale, 2, "6 5"});
  svg.label({526, 227}, "at rest", ink, "start", 15);
  return svg;
}

// One vibration ----------------------------------------------------------------------------------

// Elongation against time for a short step and for one beyond the limit. The velocity belongs to the middle
// between two steps: v = h ω² x/2 there makes the start as smooth as that of the exact cosine.
std::vector<double> elongations(double h_omega, int steps) {
  const Cloth cloth = mass_on_a_spring();
  step01::System system(cloth);
  State state = moved(1, h_omega / 2);
  std::vector<double> x = {x_of(state)};
  for (int n = 0; n < steps; ++n) {
    step01::time_step(cloth, h_omega, state, system);
    x.push_back(x_of(state));
  }
  return x;
}

Svg overshoot() {
  Svg svg(720, 330);
  const Scale at = {{60, 165}, 72, 41};
  svg.arrow(at(0, 0), at(8.9, 0), {pale, 1.5});
  svg.arrow(at(0, -3.7), at(0, 3.8), {pale, 1.5});
  std::vector<Point> exact;
  for (double t = 0; t < 8.5; t += 0.05) exact.push_back(at(t, std::cos(t)));
  svg.path(exact, {pale, 2, "6 5"});
  const auto draw = [&](double h_omega, int steps, const std::string& colour, Point label_at) {
    std::vector<Point> points;
    for (const double x : elongations(h_omega, steps))
      points.push_back(at(h_omega * double(points.size()), x));
    svg.path(points, {colour, 2});
    for (const Point& p : points) svg.dot(p, 4.5, colour);
    svg.label(label_at, text("h ω = %g", h_omega), colour);
  };
  draw(2.05, 4, orange, at(6.3, 2.75));
  draw(0.5, 16, blue, at(2.9, 1));
  svg.label(at(8.95, -0.12), "t", ink, "start");
  svg.label(at(0, 3.8) + Point{-22, 12}, "x");
  svg.label(at(4.6, -2.6), "too far, and farther every time", orange, "start", 15);
  return svg;
}

// Forward Euler: the old v moves x.
void forward_euler(const Cloth& cloth, double h, State& state, step01::System& system) {
  step01::forces(cloth, state, system);
  state.x += h * state.v;
  state.v += h * cloth.inverse_mass.cwiseProduct(system.f);
}

// The same vibration in the plane of x and v, with both methods and the same h.
Svg phase_plane() {
  Svg svg(720, 380);
  const double h_omega = 0.3;
  const auto draw = [&](double middle, const auto& method, int steps, const std::string& colour) {
    const Scale at = {{middle, 205}, 62, 62};
    svg.arrow(at(-2.6, 0), at(2.6, 0), {pale, 1.5});
    svg.arrow(at(0, -2.6), at(0, 2.6), {pale, 1.5});
    svg.label(at(2.6, 0) + Point{8, 5}, "x");
    svg.label(at(0, 2.6) + Point{24, 10}, "v/ω");
    std::vector<Point> circle;
    for (int degree = 0; degree <= 360; degree += 4)
      circle.push_back(at(std::cos(degree * M_PI / 180), std::sin(degree * M_PI / 180)));
    svg.path(circle, {pale, 2, "6 5"});
    const Cloth cloth = mass_on_a_spring();
    step01::System system(cloth);
    State state = moved(1, 0);
    std::vector<Point> points = {at(x_of(state), v_of(state))};
    for (int n = 0; n < steps; ++n) {
      method(cloth, h_omega, state, system);
      points.push_back(at(x_of(state), v_of(state)));
    }
    svg.path(points, {colour, 1.5});
    for (const Point& p : points) svg.dot(p, 3.5, colour);
  };
  draw(180, forward_euler, 21, orange);
  draw(540, step01::time_step, 21, blue);
  svg.label({360, 366}, text("h ω = %g", h_omega), ink, "middle", 15);
  svg.label({180, 22}, "forward Euler spirals outwards", orange, "middle", 15);
  svg.label({540, 22}, "symplectic Euler stays on an ellipse", blue, "middle", 15);
  return svg;
}

}  // namespace

int main(int argc, char** argv) {
  return figures::run(argc, argv, FIGURES,
                      {{"triangle.svg", triangle},
                       {"triangle_by_hand.svg", triangle_by_hand},
                       {"phase_plane.svg", phase_plane},
                       {"overshoot.svg", overshoot}});
}
