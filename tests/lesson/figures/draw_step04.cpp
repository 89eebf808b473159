// The figures in the lesson of step 4.
#include <Eigen/Dense>
#include <numbers>
#include <random>

#include "tests/lesson/figures/figures.h"

namespace {

using namespace figures;
using Eigen::Matrix2d, Eigen::Vector2d;

// The bowl ½ xᵀ A x, its lowest point 0 in the middle of a panel.
struct Bowl {
  Matrix2d A;
  Point middle;
  double scale;  // pixels

  Point at(const Vector2d& x) const { return middle + scale * Point{x[0], -x[1]}; }
};

Bowl tilted_bowl(Point middle) {
  const double tilt = 0.35;
  const Matrix2d R{{std::cos(tilt), -std::sin(tilt)}, {std::sin(tilt), std::cos(tilt)}};
  return {R * Vector2d(1, 7).asDiagonal() * R.transpose(), middle, 150};
}

// The ellipse on which the bowl is as high as at x.
void contour(const Bowl& bowl, const Vector2d& x, Svg& svg) {
  const Eigen::SelfAdjointEigenSolver<Matrix2d> eigen(bowl.A);
  const double height = x.dot(bowl.A * x);
  std::vector<Point> points;
  for (int i = 0; i <= 90; ++i) {
    const double angle = 2 * std::numbers::pi * i / 90;
    const Vector2d circle(std::cos(angle), std::sin(angle));
    const Vector2d stretched = circle.cwiseQuotient(eigen.eigenvalues().cwiseSqrt());
    points.push_back(bowl.at(std::sqrt(height) * eigen.eigenvectors() * stretched));
  }
  svg.path(points, {pale, 1});
}

// Each move goes to the lowest point along its direction. `beta` = 0: the direction is the residual.
std::vector<Vector2d> moves(const Bowl& bowl, Vector2d x, int count, bool conjugate) {
  std::vector<Vector2d> path = {x};
  Vector2d r = -bowl.A * x, p = r;
  for (int i = 0; i < count; ++i) {
    const double rr = r.squaredNorm(), alpha = r.dot(p) / p.dot(bowl.A * p);
    x += alpha * p;
    r -= alpha * (bowl.A * p);
    p = conjugate ? Vector2d(r + r.squaredNorm() / rr * p) : r;
    path.push_back(x);
  }
  return path;
}

void draw_moves(const Bowl& bowl, const std::vector<Vector2d>& path, const std::string& colour,
                Svg& svg) {
  for (const Vector2d& x : path) contour(bowl, x, svg);
  for (size_t i = 1; i < path.size(); ++i)
    svg.arrow(bowl.at(path[i - 1]), bowl.at(path[i]), {colour, 2});
  svg.dot(bowl.at(path[0]), 4, colour);
  svg.dot(bowl.at(Vector2d::Zero()), 4, ink);
}

// Down along the residual, and along conjugate directions.
Svg zigzag() {
  Svg svg(760, 300);
  const Bowl left = tilted_bowl({190, 165}), right = tilted_bowl({570, 165});
  const Vector2d start = Vector2d(-0.98, 0.0);
  draw_moves(left, moves(left, start, 8, false), orange, svg);
  draw_moves(right, moves(right, start, 2, true), blue, svg);
  svg.label({190, 28}, "along the residual: eight moves, not there yet", ink, "middle", 15);
  svg.label({570, 28}, "along conjugate directions: two moves", ink, "middle", 15);
  return svg;
}

// A string of vertices between two held ends. A sweep sets each to the mean of its neighbours, which is where
// the error of a vertex is zero as long as its neighbours stand still.
std::vector<double> after_sweeps(std::vector<double> e, int sweeps) {
  for (int sweep = 0; sweep < sweeps; ++sweep)
    for (size_t i = 1; i + 1 < e.size(); ++i) e[i] = (e[i - 1] + e[i + 1]) / 2;
  return e;
}

std::vector<double> rough_and_smooth(int cells) {
  std::mt19937 random(4);
  std::vector<double> e(size_t(cells) + 1);
  for (int i = 1; i < cells; ++i)
    e[size_t(i)] =
        std::sin(std::numbers::pi * i / cells) + double(random()) / double(random.max()) - 0.5;
  return e;
}

void draw_error(const std::vector<double>& e, Point left, double width, const std::string& colour,
                Svg& svg) {
  const auto at = [&](size_t i) {
    return left + Point{width * double(i) / double(e.size() - 1), -70 * e[i]};
  };
  svg.line(left, left + Point{width, 0}, {pale, 1});
  std::vector<Point> points;
  for (size_t i = 0; i < e.size(); ++i) points.push_back(at(i));
  svg.path(points, {colour, 1.5});
  for (size_t i = 0; i < e.size(); ++i) svg.dot(at(i), 2.5, colour);
}

// A grid of a string: its vertices on a line.
void draw_grid(Point left, int cells, Svg& svg) {
  const double width = 150;
  svg.line(left, left + Point{width, 0}, {pale, 1});
  for (int i = 0; i <= cells; ++i)
    svg.dot(left + Point{width * i / cells, 0}, cells > 16 ? 1.8 : 2.5, ink);
}

// The grids of a V-cycle: down to the coarsest on the left, up again on the right.
void draw_cycle(double top, Svg& svg) {
  const int levels = 4;
  const double across = 92, down = 36, middle = 380;
  const auto centre = [&](int level, int side) {
    return Point{middle + side * across * (levels - 1 - level), top + down * level};
  };
  const Point half{75, 0}, gap{0, 7};
  for (int level = 0; level + 1 < levels; ++level)
    for (const int side : {-1, 1}) {
      const Point fine = centre(level, side), coarse = centre(level + 1, side);
      draw_grid(fine - half, 32 >> level, svg);
      const Point upper = fine + gap, lower = coarse - gap;
      svg.arrow(side < 0 ? upper : lower, side < 0 ? lower : upper, {blue, 2});
    }
  const Point coarsest = centre(levels - 1, 0);
  draw_grid(coarsest - half, 32 >> (levels - 1), svg);
  svg.label(coarsest + Point{0, 24}, "solved exactly", ink, "middle", 14);
  svg.label(centre(2, -1) + Point{-90, 24}, "the residual goes down", blue, "end", 14);
  svg.label(centre(2, 1) + Point{90, 24}, "the correction comes up", blue, "start", 14);
}

// The error of a string, after one sweep and after three; and the grids of a V-cycle.
Svg sweeps_and_grids() {
  Svg svg(760, 370);
  const std::vector<double> e = rough_and_smooth(32);
  const std::string titles[] = {"an error", "after one sweep", "after three sweeps"};
  for (int i = 0; i < 3; ++i) {
    const double left = 30 + 245 * i;
    draw_error(after_sweeps(e, std::array{0, 1, 3}[size_t(i)]), {left, 150}, 210, i ? blue : orange,
               svg);
    svg.label({left + 105, 180}, titles[i], ink, "middle", 15);
  }
  draw_cycle(225, svg);
  return svg;
}

}  // namespace

int main(int argc, char** argv) {
  return figures::run(argc, argv, FIGURES,
                      {{"zigzag.svg", zigzag}, {"sweeps.svg", sweeps_and_grids}});
}
