// The figures in the lesson of step 5.
#include <algorithm>
#include <set>

#include "physics/cantilever.h"
#include "scene/hinges.h"
#include "scene/mesh_edges.h"
#include "support/folds.h"
#include "support/straight_fold.h"
#include "tests/lesson/figures/figures.h"

namespace {

using namespace figures;

// Points of space on paper: x to the right, and the coordinate `up` upwards.
struct Paper {
  Point origin;
  double scale;  // pixels per metre
  int up;        // 1 for y, 2 for z

  Point operator()(const Vec3& p) const { return origin + scale * Point{p.x(), -p[up]}; }
  Point along(const Vec3& v) const { return scale * Point{v.x(), -v[up]}; }
};

// A part of a circle, as points. Angles in radians, counter-clockwise from the right.
std::vector<Point> arc(Point centre, double radius, double from, double to) {
  constexpr int pieces = 24;
  std::vector<Point> points;
  for (int i = 0; i <= pieces; ++i) {
    const double a = from + (to - from) * i / pieces;
    points.push_back(centre + radius * Point{std::cos(a), -std::sin(a)});
  }
  return points;
}

double direction(Point v) {
  return std::atan2(-v.y, v.x);
}

// The hinge from the side ------------------------------------------------------------------------

// With one digit and a minus sign.
std::string number(double value) {
  const std::string digits = text("%.1f", std::abs(value));
  return digits == "0.0" ? "0" : (value < 0 ? "−" : "") + digits;
}

// Seen along the edge, from P1 to P2. Both flaps are 1 m high and slope by θ/2.
void draw_hinge(Svg& svg, Point edge, double folded_by, const std::string& name) {
  const Mat3 upright = Eigen::AngleAxisd(-folded_by / 2, Vec3::UnitY()).toRotationMatrix();
  Vecs<4> p = FlatHinge{1, 0.5, 1, 0.5}.folded(folded_by);
  for (Vec3& x : p) x = upright * x;
  const Fold fold = make_fold(p);
  const double theta = angle(p);
  const Paper paper{edge, 100, 2};
  const Point n0 = paper.along(0.8 * fold[0].n), n1 = paper.along(0.8 * fold[1].n),
              m0 = paper.along(0.8 * fold[0].m[0]);

  svg.line(paper(p[0]), edge, {blue, 5});
  svg.line(edge, paper(p[3]), {orange, 5});
  svg.arrow(edge, edge + n0, {blue, 2.5});
  if (theta != 0) {
    svg.arrow(edge, edge + m0, {blue, 1.5, "5 4"});
    svg.path(arc(edge, 52, direction(n0), direction(n1)), {ink, 1.5});
    svg.arrow(edge, edge + n1, {orange, 2.5});
    svg.label(edge + 1.2 * m0 + Point{0, 6}, "m₀", blue);
    svg.label(edge + Point{0, -62}, "θ");
    svg.label(edge + 1.17 * n0 + Point{0, 6}, "n₀", blue);
    svg.label(edge + 1.17 * n1 + Point{0, 6}, "n₁", orange);
  } else {
    svg.arrow(edge, edge + 0.75 * n1, {orange, 2.5});
    svg.label(edge + Point{-12, -72}, "n₀", blue, "end");
    svg.label(edge + Point{12, -72}, "n₁", orange, "start");
    svg.label(edge + Point{0, 26}, "P₁, P₂");
  }
  svg.dot(edge, 6);
  const Point beside = {0, theta < 0 ? -12.0 : 26.0};
  svg.label(paper(p[0]) + beside, "P₀", blue);
  svg.label(paper(p[3]) + beside, "P₃", orange);
  svg.label({edge.x, 268}, name + ", θ = " + number(theta), ink, "middle", 16);
}

Svg hinge_from_the_side() {
  Svg svg(800, 285);
  svg.arrow({24, 75}, {24, 25}, {pale, 2});
  svg.label({34, 40}, "front", pale, "start", 14);
  draw_hinge(svg, {140, 145}, 0.9, "a ridge");
  draw_hinge(svg, {400, 170}, 0, "flat");
  draw_hinge(svg, {660, 195}, -0.9, "a valley");
  return svg;
}

// The hinge from above ---------------------------------------------------------------------------

// A flat hinge, whose edge is 1 m long, and the parts of flap 0.
struct FlatView {
  FlatHinge shape{0.95, 0.36, 0.75, 0.62};
  Vecs<4> p = shape.folded(0);
  Flap flap = make_fold(p)[0];
  Paper paper{{330, 350}, 290, 1};
  Vec3 foot0 = p[0] + flap.d[0] * flap.m[0], foot1 = p[1] + flap.d[1] * flap.m[1];

  Point corner(int i) const { return paper(p[i]); }
};

// The angle at a corner of flap 0, with the name of its cosine.
void mark_angle(Svg& svg, const FlatView& view, int corner, const std::string& name) {
  const Point at = view.corner(corner);
  const double from = direction(view.corner((corner + 1) % 3) - at),
               to = direction(view.corner((corner + 2) % 3) - at),
               turn = std::remainder(to - from, 2 * pi);
  svg.path(arc(at, 40, from, from + turn), {green, 2});
  const double towards_P0 = corner == 1 ? from + 0.72 * turn : from + 0.4 * turn;
  svg.label(at + 58 * Point{std::cos(towards_P0), -std::sin(towards_P0)} + Point{0, 6}, name,
            green);
}

// The part of the edge from the foot of the height to one end.
void mark_part(Svg& svg, const FlatView& view, int end, const std::string& name) {
  const Point foot = view.paper(view.foot0) + Point{12, end == 1 ? 3.0 : -3.0},
              to = view.corner(end) + Point{12, 0};
  svg.line(foot, to, {green, 2});
  svg.label(foot + 0.3 * (to - foot) + Point{12, 6}, name, green, "start", 16);
}

void draw_flaps(Svg& svg, const FlatView& view) {
  const auto at = [&](int i) { return view.corner(i); };
  const Point foot0 = view.paper(view.foot0), foot1 = view.paper(view.foot1),
              m0 = view.paper.along(0.27 * view.flap.m[0]);
  svg.path({at(3), at(2), at(1)}, {pale, 2}, "#f6f6f8");
  svg.path({at(0), at(1), at(2)}, {ink, 2}, cloth_cream);
  svg.line(at(0), foot0, {blue, 2, "7 5"});
  svg.line(at(1), foot1, {orange, 2, "7 5"});
  svg.line(at(1), at(2), {ink, 4});
  svg.arrow(at(0), at(0) + m0, {blue, 3});
  svg.dot(foot0, 5, blue);
  mark_angle(svg, view, 1, "c₁");
  mark_angle(svg, view, 2, "c₂");
  mark_part(svg, view, 1, "c₁ |v₁₀|");
  mark_part(svg, view, 2, "c₂ |v₂₀|");
  svg.label(at(0) + m0 + Point{-14, -12}, "m₀", blue);
  svg.label(at(0) + 0.83 * (foot0 - at(0)) + Point{0, 24}, "d₀", blue);
  svg.label(at(1) + 0.72 * (foot1 - at(1)) + Point{22, 0}, "d₁", orange);
  svg.label(at(0) + Point{-18, 6}, "P₀");
  svg.label(at(1) + Point{0, 27}, "P₁");
  svg.label(at(2) + Point{0, -14}, "P₂");
  svg.label(at(3) + Point{18, 6}, "P₃");
  svg.label(at(0) + Point{120, -48}, "flap 0", ink, "middle", 15);
  svg.label(at(3) + Point{-60, -6}, "flap 1", ink, "middle", 15);
}

// The edge from the side, as a plank that P0 loads at the foot of its height. Arrows are the levers.
void draw_plank(Svg& svg, const FlatView& view) {
  const Corners a = levers(view.flap);
  const auto at = [](double s) { return Point{615 + 140 * s, 220}; };
  const auto lever = [](double value) { return Point{0, 75 * value}; };
  const double foot = view.foot0.y();
  svg.line(at(0), at(1), {ink, 5});
  svg.arrow(at(foot) + Point{0, -5} + lever(a[0]), at(foot) + Point{0, -5}, {blue, 3});
  svg.arrow(at(0) + Point{0, 5} + lever(a[1]), at(0) + Point{0, 5}, {orange, 3});
  svg.arrow(at(1) + Point{0, 5} + lever(a[2]), at(1) + Point{0, 5}, {orange, 3});
  svg.label(at(foot) + Point{12, -50}, text("1/d₀ = %.2f", -a[0]), blue, "start", 15);
  svg.label(at(0) + lever(a[1]) + Point{0, 26}, text("a₁ = %.2f", a[1]), orange, "middle", 15);
  svg.label(at(1) + lever(a[2]) + Point{0, 26}, text("a₂ = %.2f", a[2]), orange, "middle", 15);
  svg.label(at(0) + Point{-18, 6}, "P₁");
  svg.label(at(1) + Point{18, 6}, "P₂");
  svg.label(at(0.5) + Point{0, -125}, "the edge as a plank", ink, "middle", 15);
}

Svg hinge_from_above() {
  Svg svg(800, 400);
  const FlatView view;
  draw_flaps(svg, view);
  draw_plank(svg, view);
  return svg;
}

// The models: a fold -----------------------------------------------------------------------------

struct Named {
  BendModel model;
  std::string name, colour;
};
const std::vector<Named> models = {{BendModel::dihedral, "dihedral", blue},
                                   {BendModel::bridson, "bridson", green},
                                   {BendModel::quadratic, "quadratic", pink},
                                   {BendModel::springs, "springs", orange}};

// Two triangles of a grid of square cells of 1 m, with a side of a cell as their common edge.
constexpr FlatHinge square = {1, 0, 1, 1};

// ∂E/∂θ, N·m, with P3 on its circle.
template <class Family>
double slope(const Family& family, double theta) {
  const Vec3 path(-std::sin(theta), 0, -std::cos(theta));
  return -family_forces(family, flat(square.folded(theta))).template tail<3>().dot(path);
}

double hinge_slope(BendModel model, double k, double theta) {
  return slope(one_hinge(hinge_near(theta, 0, bridson_shape(square)), k, model), theta);
}

double quadratic_slope(double k, double theta) {
  QuadraticHinges family;
  family.elements = {quadratic(square)};
  family.term<QuadraticBend>() = QuadraticBend(k);
  return slope(family, theta);
}

double spring_slope(double k, double theta) {
  const Vecs<4> p = square.folded(0);
  BendSprings family;
  family.elements = {make_spring(0, 3, (p[0] - p[3]).norm())};
  family.term<SpringBend>() = SpringBend(k);
  return slope(family, theta);
}

// At B = 1 N·m. Springs have no modulus: theirs is the k with which they push like the dihedral at 90°.
double push_back(BendModel model, double theta) {
  constexpr double B = 1;
  if (model == BendModel::springs)
    return spring_slope(hinge_slope(BendModel::dihedral, B, pi / 2) / spring_slope(1, pi / 2),
                        theta);
  const double k = *stiffness_of_modulus(model, B);
  return model == BendModel::quadratic ? quadratic_slope(k, theta) : hinge_slope(model, k, theta);
}

Svg push_against_fold() {
  Svg svg(620, 350);
  const auto at = [&](double theta, double push) {
    return Point{70, 300} + Point{440 / pi * theta, -80 * push};
  };
  for (int turn = 0; turn <= 4; ++turn) {
    const double theta = turn * pi / 4;
    svg.line(at(theta, 0), at(theta, pi), {faint, 1});
    svg.label(at(theta, 0) + Point{0, 22}, text("%d°", 45 * turn), ink, "middle", 14);
  }
  svg.arrow(at(0, 0), at(pi, 0) + Point{30, 0}, {ink, 1.5});
  svg.arrow(at(0, 0), at(0, pi) + Point{0, -20}, {ink, 1.5});
  svg.label(at(pi / 2, 0) + Point{0, 43}, "fold θ", ink, "middle", 15);
  svg.label(at(0, pi) + Point{12, -10}, "how hard the hinge pushes back", ink, "start", 15);
  for (const Named& m : models) {
    std::vector<Point> curve;
    for (int i = 0; i <= 90; ++i) curve.push_back(at(pi * i / 90, push_back(m.model, pi * i / 90)));
    svg.path(curve, {m.colour, 3});
    const auto beside = [&](double theta, Point aside) {
      svg.label(at(theta, push_back(m.model, theta)) + aside, m.name, m.colour, "start", 15);
    };
    if (m.model == BendModel::springs)
      beside(0.75 * pi, {-30, -12});
    else if (m.model == BendModel::quadratic)
      beside(0.55 * pi, {0, -10});
    else
      beside(pi, {12, 6});
  }
  return svg;
}

// The models: a strip ----------------------------------------------------------------------------

constexpr int cells = 10;

Cantilever strip_of(BendModel model, double spring_k = 0) {
  Cantilever c;
  c.N = cells;
  c.bend_model = model;
  c.spring_k = spring_k;
  return c;
}

// The rows of the strip at rest under each weight Γ of a growing list.
std::vector<std::vector<Vec3>> shapes(const Cantilever& c, const std::vector<double>& Gammas) {
  HeldStrip strip(c);
  const Sparse P = strip.freedom();
  VecX x = strip.mesh.x;
  std::vector<std::vector<Vec3>> all;
  for (const double Gamma : Gammas) {
    strip.weigh(Gamma);
    x = equilibrium(strip.cloth, P, x);
    std::vector<Vec3> rows;
    for (int row = 0; row <= c.N + 1; ++row)
      rows.push_back(x.segment<3>(3 * strip.mesh.grid->vertex(row, 0)));
    all.push_back(rows);
  }
  return all;
}

// The k of springs, N/m, with which the strip droops at this weight as far as with hinges.
double spring_k_of_droop(double Gamma) {
  const double aim = tips(strip_of(BendModel::dihedral), {Gamma})[0].droop();
  double low = 1, high = 1e6;
  for (int i = 0; i < 30; ++i) {
    const double middle = std::sqrt(low * high);
    const bool too_soft = tips(strip_of(BendModel::springs, middle), {Gamma})[0].droop() > aim;
    (too_soft ? low : high) = middle;
  }
  return std::sqrt(low * high);
}

// The three models with a modulus lie on each other: from wide below to narrow above, all can be seen.
double width(BendModel model) {
  switch (model) {
    case BendModel::dihedral:
      return 11;
    case BendModel::bridson:
      return 6;
    case BendModel::quadratic:
      return 2.5;
    case BendModel::springs:
      break;
  }
  return 3;
}

Svg droop() {
  Svg svg(800, 350);
  const std::vector<double> Gammas = {1, 10, 100};
  const double k = spring_k_of_droop(Gammas[1]);
  const auto paper = [](size_t panel) { return Paper{{50 + 258 * double(panel), 75}, 205, 1}; };
  for (const Named& m : models) {
    const std::vector<std::vector<Vec3>> all = shapes(strip_of(m.model, k), Gammas);
    for (size_t i = 0; i < Gammas.size(); ++i) {
      std::vector<Point> curve;
      for (const Vec3& row : all[i]) curve.push_back(paper(i)(row));
      svg.path(curve, {m.colour, width(m.model)});
    }
  }
  const std::vector<std::string> weights = {"light", "ten times as heavy", "a hundred times"};
  for (size_t i = 0; i < Gammas.size(); ++i) {
    const Point clamp = paper(i)({0, 0, 0});
    svg.path({clamp + Point{-10, -14}, clamp + Point{22, -14}, clamp + Point{22, 14},
              clamp + Point{-10, 14}},
             {pale, 1}, pale);
    svg.label(clamp + Point{100, -45}, text("%s, Γ = %g", weights[i].c_str(), Gammas[i]), ink,
              "middle", 15);
  }
  for (size_t i = 0; i < models.size(); ++i) {
    const Point at = {110 + 165 * double(i), 325};
    svg.line(at, at + Point{36, 0}, {models[i].colour, width(models[i].model)});
    svg.label(at + Point{46, 6}, models[i].name, models[i].colour, "start", 15);
  }
  return svg;
}

// The mesh ---------------------------------------------------------------------------------------

// A mesh on paper, as it lies flat.
class Sheet {
 public:
  Sheet(Svg& svg, const Mesh& mesh, Point origin, double scale)
      : svg_(svg), mesh_(mesh), origin_(origin), scale_(scale) {
    draw(edges(mesh), {pale, 1});
  }
  Point uv(const Vec2& p) const { return origin_ + scale_ * Point{p.x(), -p.y()}; }
  Point vertex(int i) const { return uv({mesh_.x[3 * i], -mesh_.x[3 * i + 2]}); }
  void draw(const std::vector<Edge>& edges, const Stroke& stroke) {
    std::vector<std::array<Point, 2>> lines;
    for (const auto& [i, j] : edges) lines.push_back({vertex(i), vertex(j)});
    svg_.lines(lines, stroke);
  }

 private:
  Svg& svg_;
  const Mesh& mesh_;
  Point origin_;
  double scale_;
};

Svg folds_of_a_mesh() {
  Svg svg(800, 290);
  const Mesh mesh = make_grid({8, 8}, {8, 8}, Diagonals::same);
  struct Case {
    const char* name;
    FoldLine line;
    double before, after;  // m, how far the line is drawn from the point that it goes through
  };
  const std::vector<Case> cases = {{"along the diagonals", {{4, 4}, 3 * pi / 4}, 6.3, 6.3},
                                   {"across the diagonals", {{4, 4}, pi / 4}, 6.3, 6.3},
                                   {"at 20° to u", {{0, 2.5}, pi / 9}, 0.7, 9.2}};
  for (size_t i = 0; i < cases.size(); ++i) {
    const Case& c = cases[i];
    Sheet sheet(svg, mesh, {60 + 250 * double(i), 240}, 24);
    std::vector<Edge> changed;
    for (const ChangedEdge& edge : changed_by_fold(mesh, c.line)) changed.push_back(edge.edge);
    sheet.draw(changed, {orange, 3});
    const Vec2 along(std::cos(c.line.direction), std::sin(c.line.direction));
    svg.line(sheet.uv(c.line.through - c.before * along),
             sheet.uv(c.line.through + c.after * along), {blue, 2, "8 5"});
    svg.label(sheet.uv({4, 8}) + Point{0, -20}, c.name, blue, "middle", 15);
    svg.label(sheet.uv({4, 0}) + Point{0, 30}, text("%zu edges change", changed.size()), orange,
              "middle", 15);
  }
  return svg;
}

// The vertices that share an element with a vertex.
std::set<int> neighbours(int vertex, const auto& elements) {
  std::set<int> found;
  for (const auto& vertices : elements)
    if (std::ranges::count(vertices, vertex)) found.insert(vertices.begin(), vertices.end());
  found.erase(vertex);
  return found;
}

Svg twelve_neighbours() {
  Svg svg(560, 300);
  const Mesh mesh = make_grid({4, 4}, {4, 4}, Diagonals::same);
  std::vector<std::array<int, 4>> hinges;
  for (const InteriorEdge& edge : find_edges(mesh.faces).interior) hinges.push_back(edge.vertices);
  const int centre = mesh.grid->vertex(2, 2);
  const std::set<int> by_triangles = neighbours(centre, mesh.faces),
                      by_hinges = neighbours(centre, hinges);
  Sheet sheet(svg, mesh, {40, 270}, 60);
  for (const int i : by_hinges)
    svg.dot(sheet.vertex(i), 9, by_triangles.contains(i) ? blue : orange);
  svg.dot(sheet.vertex(centre), 9);
  const auto line = [&](double y, const std::string& colour, const std::string& words) {
    svg.dot({330, y}, 9, colour);
    svg.label({350, y + 6}, words, ink, "start", 15);
  };
  line(110, ink, "one vertex");
  line(150, blue, text("%zu share a triangle", by_triangles.size()));
  line(190, orange, text("%zu share only a hinge", by_hinges.size() - by_triangles.size()));
  return svg;
}

}  // namespace

int main(int argc, char** argv) {
  return figures::run(argc, argv, FIGURES,
                      {{"hinge_side.svg", hinge_from_the_side},
                       {"hinge_above.svg", hinge_from_above},
                       {"push.svg", push_against_fold},
                       {"droop.svg", droop},
                       {"folds.svg", folds_of_a_mesh},
                       {"neighbours.svg", twelve_neighbours}});
}
