// The figures in the lesson of step 3.
#include <algorithm>

#include "step01_explicit/time_step.h"
#include "step03_implicit/time_step.h"
#include "support/extreme_scenes.h"
#include "tests/lesson/figures/figures.h"

namespace {

using namespace figures;

const std::string pale_blue = "#e3eff7", pale_orange = "#fae5da", block_grey = "#5c6a84",
                  block_pale = "#c3c9d4";

// A mass of 1 kg, vertex 1, on a spring of 1 N/m that is 1 m long at rest. Vertex 0 is held at the origin.
Cloth mass_on_a_spring() {
  Cloth cloth;
  cloth.mass = VecX::Ones(6);
  cloth.inverse_mass = cloth.mass;
  cloth.inverse_mass.head<3>().setZero();
  cloth.pins = {0};
  cloth.springs.elements = {make_spring(0, 1, 1)};
  cloth.term<SpringTerm>() = SpringTerm(1);
  return cloth;
}

// One step of a spring that is 1 m too long and still moves outwards, for three lengths of the step.
Svg one_step_of_a_spring() {
  Svg svg(720, 300);
  const double scale = 56, top = 46, bottom = 250;
  const auto at = [&](double elongation, double y) { return Point{520 + scale * elongation, y}; };
  const Cloth cloth = mass_on_a_spring();
  const State start{(VecX(6) << 0, 0, 0, 2, 0, 0).finished(),
                    (VecX(6) << 0, 0, 0, 0.5, 0, 0).finished()};

  for (int row = 0; row < 3; ++row) {
    const double h = row + 1, y = 86 + 62 * row;  // ω = √(k/m) = 1/s
    State far = start, near = start;
    step01::System far_system(cloth);
    step03::System near_system(cloth);
    step01::time_step(cloth, h, far, far_system);
    step03::time_step(cloth, h, near, near_system);
    const double coast = start.x[3] + h * start.v[3] - 1;
    svg.path({at(0, y - 13), at(coast, y - 13), at(coast, y + 13), at(0, y + 13)}, {pale_blue, 0},
             pale_blue);
    svg.line(at(-7.3, y), at(3, y), {faint, 2});
    svg.arrow(at(1, y), at(far.x[3] - 1 + 0.12, y), {orange, 2});
    svg.dot(at(far.x[3] - 1, y), 7, orange);
    svg.dot(at(coast, y), 6, pale);
    svg.dot(at(near.x[3] - 1, y), 7, blue);
    svg.label({20, y + 6}, text("h = %.0f/ω", h), ink, "start", 16);
  }
  svg.line(at(0, top), at(0, bottom), {ink, 1.5, "5 5"});
  svg.line(at(1, top), at(1, bottom), {ink, 1.5});
  svg.label(at(0, top - 12), "rest", ink, "middle", 15);
  svg.label(at(1, top - 12), "start", ink, "middle", 15);

  const double legend = 284;
  svg.dot({138, legend - 5}, 7, orange);
  svg.label({152, legend}, "explicit step", ink, "start", 15);
  svg.dot({300, legend - 5}, 7, blue);
  svg.label({314, legend}, "implicit step", ink, "start", 15);
  svg.dot({462, legend - 5}, 6, pale);
  svg.label({476, legend}, "without a force (coasting)", ink, "start", 15);
  return svg;
}

// A grid of 3 × 3 cells and the pattern of its matrix; one triangle and its nine blocks are red.
Svg pattern_of_a_grid() {
  Svg svg(720, 400);
  constexpr int cells = 3, in_the_middle = 8;
  Model model;
  model.add(StretchTerm(1));
  const Mesh mesh = make_grid({1, 1}, {cells, cells}, Diagonals::same);
  const Cloth cloth = make_cloth(mesh, model);
  const BlockMatrix A = make_block_matrix(cloth);
  const auto& red = cloth.triangles.elements[in_the_middle].vertices;
  const auto is_red = [&](int i) { return std::ranges::find(red, i) != red.end(); };

  const auto place = [&](int i) {
    return Point{48 + 230 * mesh.x[3 * i], 322 + 230 * mesh.x[3 * i + 2]};
  };
  for (const Face& face : mesh.faces)
    svg.path({place(face[0]), place(face[1]), place(face[2])}, {block_grey, 1.5}, cloth_cream);
  svg.path({place(red[0]), place(red[1]), place(red[2])}, {block_grey, 1.5}, cloth_red);
  for (int i = 0; i < mesh.vertices(); ++i) {
    svg.dot(place(i), is_red(i) ? 13 : 11, is_red(i) ? cloth_red : block_grey);
    svg.label(place(i) + Point{0, 5}, text("%d", i), "white", "middle", 13);
  }
  svg.label({163, 374}, "the mesh, its vertices numbered", ink, "middle", 15);

  const double side = 19, left = 366, top = 40;
  const auto block = [&](int row, int column, const std::string& colour) {
    const Point a{left + side * column + 1, top + side * row + 1};
    const double s = side - 2;
    svg.path({a, a + Point{s, 0}, a + Point{s, s}, a + Point{0, s}}, {colour, 0}, colour);
  };
  const auto stored = [&](int i, int j) {
    block(i, j, is_red(i) && is_red(j) ? cloth_red : block_grey);
    if (i != j) block(j, i, is_red(i) && is_red(j) ? "#f3b1ac" : block_pale);
  };
  for (int i = 0; i < A.rows(); ++i) {
    const std::string& colour = is_red(i) ? cloth_red : pale;
    svg.label({left - 12, top + side * i + 14}, text("%d", i), colour, "middle", 12);
    svg.label({left + side * (i + 0.5), top - 8}, text("%d", i), colour, "middle", 12);
    stored(i, i);
    for (int s = A.row_start[i]; s < A.row_start[i + 1]; ++s) stored(i, A.column[s]);
  }
  svg.label({left + side * 8, 374}, "the matrix: a square is a block of 3 × 3", ink, "middle", 15);
  return svg;
}

// ½ pᵀ A p of a compressed spring, in the plane of the spring: with the definite matrix and the printed one.
struct Plane {
  Eigen::Matrix2d A;
  Vec2 b, answer;
};

Plane plane_of_a_compressed_spring(Jacobian jacobian) {
  const Cloth cloth = mass_on_a_spring();
  State state{VecX::Zero(6), VecX::Zero(6)};
  const double angle = 25 * pi / 180;
  state.x.segment<3>(3) = Vec3(std::cos(angle), std::sin(angle), 0) / 3;  // a third of its length
  step03::System system(cloth, {jacobian});
  step03::forces(cloth, state, system);
  system.b = VecX::Zero(6);
  const double push = angle + 65 * pi / 180;
  system.b.segment<3>(3) = Vec3(std::cos(push), std::sin(push), 0);
  step03::solve(cloth, 1, system);
  return {system.A.diagonal[1].topLeftCorner<2, 2>(), system.b.segment<2>(3),
          system.dv.segment<2>(3)};
}

// Where pᵀ A p is positive the contours are blue, where it is negative orange.
void draw_contours(Svg& svg, Point centre, const Plane& plane) {
  const double scale = 100, radius = 1.45;
  const int directions = 360;
  const auto at = [&](const Vec2& p) { return centre + scale * Point{p.x(), -p.y()}; };
  const auto direction = [&](double d) {
    return Vec2(std::cos(2 * pi * d / directions), std::sin(2 * pi * d / directions));
  };
  const auto half_form = [&](double d) { return 0.5 * direction(d).dot(plane.A * direction(d)); };
  // A contour has one point in each direction: at the distance √(level / half_form).
  const auto squared_distance = [&](double d, double level) { return level / half_form(d); };
  const auto inside = [&](double d, double level) {
    const double r2 = squared_distance(d, level);
    return r2 > 0 && r2 < radius * radius;
  };
  const auto point = [&](double d, double level) {
    return at(std::sqrt(squared_distance(d, level)) * direction(d));
  };
  const auto end = [&](double in, double out, double level) {  // on the circle, by bisection
    for (int i = 0; i < 20; ++i) (inside((in + out) / 2, level) ? in : out) = (in + out) / 2;
    return point(in, level);
  };
  const auto contour = [&](double level, const std::string& colour) {
    std::vector<Point> run;
    for (int d = 0; d < directions; ++d) {
      if (inside(d, level)) {
        if (run.empty() && d > 0) run.push_back(end(d, d - 1, level));
        run.push_back(point(d, level));
        if (inside(d + 1, level) && d + 1 < directions) continue;
        run.push_back(d + 1 < directions ? end(d, d + 1, level) : point(directions, level));
        svg.path(run, {colour, 1.5});
        run.clear();
      }
    }
  };
  for (int d = 0; d < directions; d += 2) {
    const std::string& colour = half_form(d + 1) > 0 ? pale_blue : pale_orange;
    svg.path({centre, at(radius * direction(d)), at(radius * direction(d + 2))}, {colour, 0.6},
             colour);
  }
  for (int level = 1; level <= 9; ++level) {
    contour(0.2 * level, blue);
    contour(-0.2 * level, orange);
  }
  svg.arrow(centre, at(plane.b), {ink, 4});
  svg.arrow(centre, at(plane.answer), {green, 4});
  svg.dot(centre, 5);
}

Svg bowl_and_saddle() {
  Svg svg(720, 400);
  const Plane bowl = plane_of_a_compressed_spring(Jacobian::definite),
              saddle = plane_of_a_compressed_spring(Jacobian::bw98);
  draw_contours(svg, {180, 200}, bowl);
  draw_contours(svg, {540, 200}, saddle);
  svg.label({180, 30}, "bowl: definite", ink, "middle", 16);
  svg.label({540, 30}, "saddle: as printed", ink, "middle", 16);
  svg.arrow({130, 382}, {170, 382}, {ink, 4});
  svg.label({180, 388}, "push b", ink, "start", 15);
  svg.arrow({300, 382}, {340, 382}, {green, 4});
  svg.label({350, 388}, "answer Δv, the solution of A Δv = b", ink, "start", 15);
  return svg;
}

// A picture of space: z of the view is up, y goes into the depth.
struct View {
  Point origin;
  double scale;

  Point at(const Vec3& p) const {
    return origin + scale * Point{p.x() + 0.34 * p.y(), -p.z() - 0.42 * p.y()};
  }
};

// T, the tension of the first triangle.
Square<2> tension_of_a_triangle(const Cloth& cloth, const VecX& x) {
  const Triangle& triangle = cloth.triangles.elements[0];
  Tension<2> sum;
  cloth.triangles.conditions(triangle, gather(triangle, x),
                             [&](const Term& term, const auto& c) { sum.add(term.k * c.C, c); });
  return sum.T;
}

// A triangle that is held at one edge. The third vertex has `distance` from the edge, 1 m at rest, and lies
// 20° above the plane. Arrows: the force on this vertex, and its part across the plane.
void draw_lifted_triangle(Svg& svg, double left, const std::string& name, double distance) {
  Mesh mesh;
  mesh.faces = {{0, 1, 2}};
  mesh.rest = {{Vec2(0, 0), Vec2(1, 0.5), Vec2(0, 1)}};
  mesh.x.resize(9);
  const double angle = 20 * pi / 180;
  mesh.x << 0, 0, 0, distance * std::cos(angle), 0.5, distance * std::sin(angle), 0, 1, 0;
  const Cloth cloth = make_cloth(mesh, model(1, 1, Gravity::off));
  step03::System system(cloth);
  step03::forces(cloth, {mesh.x, VecX::Zero(9)}, system);
  const Vec3 tip = mesh.x.segment<3>(3), force = system.f.segment<3>(3);
  const Square<2> T = tension_of_a_triangle(cloth, mesh.x), kept = positive_part(T);
  const bool back = force.z() < 0;
  const std::string& colour = back ? blue : orange;

  const View view{{left + 48, 212}, 185};
  const Point held[] = {view.at({0, 0, 0}), view.at({0, 1, 0})};
  svg.path({view.at({-0.15, -0.1, 0}), view.at({1.3, -0.1, 0}), view.at({1.3, 1.1, 0}),
            view.at({-0.15, 1.1, 0})},
           {faint, 1}, faint);
  svg.path({held[0], view.at({distance, 0.5, 0}), held[1], held[0]}, {pale, 1.5, "5 5"});
  svg.path({held[0], view.at(tip), held[1]}, {ink, 2}, cloth_cream);
  svg.line(held[0], held[1], {ink, 5});
  const double arrow = 7.5;  // m per N
  svg.arrow(view.at(tip), view.at(tip + arrow * force), {ink, 3});
  svg.arrow(view.at(tip), view.at(tip + arrow * Vec3(0, 0, force.z())), {colour, 4});
  svg.dot(view.at(tip), 5);

  svg.label({left + 180, 30}, name + ": the force leads " + (back ? "back" : "away"), ink, "middle",
            16);
  svg.label({left + 180, 252},
            kept.norm() < 1e-9 * T.norm()         ? "T₊ = 0: the cloth may buckle"
            : (kept - T).norm() < 1e-9 * T.norm() ? "T₊ = T: the matrix resists"
                                                  : "T₊ is a part of T",
            colour, "middle", 15);
}

Svg pulled_and_pressed() {
  Svg svg(720, 270);
  draw_lifted_triangle(svg, 0, "pulled", 1.15);
  draw_lifted_triangle(svg, 360, "pressed", 0.85);
  return svg;
}

// Each face of a cloth, the farthest first, lighter where it faces up.
void draw_cloth(Svg& svg, const View& view, const Mesh& mesh, const VecX& x) {
  const auto place = [&](int i) { return Vec3(-x[3 * i + 2], x[3 * i], x[3 * i + 1]); };
  std::vector<Face> faces = mesh.faces;
  std::ranges::stable_sort(faces, std::greater{}, [&](const Face& face) {
    return place(face[0]).y() + place(face[1]).y() + place(face[2]).y();
  });
  for (const Face& face : faces) {
    const Vec3 a = place(face[0]), b = place(face[1]), c = place(face[2]);
    const Vec3 n = (b - a).cross(c - a).normalized();
    const double light = 0.62 + 0.38 * std::abs(n.dot(Vec3(-0.45, -0.3, 0.84)));
    const auto shade = [&](int full) { return int(std::lround(light * full)); };
    svg.path({view.at(a), view.at(b), view.at(c)}, {"#8a7a5c", 0.7},
             text("#%02x%02x%02x", shade(253), shade(235), shade(203)));
  }
}

// The strip of the tests, one second after its ends are held at 70 % of its length.
Svg frozen_and_buckled() {
  Svg svg(720, 290);
  const double h = 0.01;
  const int steps = 100;
  for (const Jacobian jacobian : {Jacobian::bw98, Jacobian::definite}) {
    const bool printed = jacobian == Jacobian::bw98;
    const TestScene scene = extremes::pushed_strip(1e4);
    step03::System system(scene.cloth, {jacobian});
    State state = scene.start;
    for (int step = 0; step < steps; ++step) step03::time_step(scene.cloth, h, state, system);

    const View view{{printed ? 36.0 : 396.0, 222}, 365};
    for (const double end : {0.0, 0.7})
      svg.line(view.at({end, -0.05, 0}), view.at({end, 0.3, 0}), {ink, 6});
    draw_cloth(svg, view, scene.mesh, state.x);
    const double middle = printed ? 180 : 540;
    svg.label({middle, 30}, printed ? "as printed: frozen flat" : "definite: buckled", ink,
              "middle", 16);
    svg.label({middle, 272}, text("%ld of %d matrices indefinite", system.counts.indefinite, steps),
              printed ? orange : blue, "middle", 15);
  }
  return svg;
}

}  // namespace

int main(int argc, char** argv) {
  return figures::run(argc, argv, FIGURES,
                      {{"spring.svg", one_step_of_a_spring},
                       {"pattern.svg", pattern_of_a_grid},
                       {"bowl_saddle.svg", bowl_and_saddle},
                       {"tension.svg", pulled_and_pressed},
                       {"strip.svg", frozen_and_buckled}});
}
