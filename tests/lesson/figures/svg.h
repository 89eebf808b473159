// A drawing for a lesson, as SVG. Lengths are pixels, y points down. Colours are those of the plots
// (support/gnuplot.h), which colour-blind readers can distinguish.
#pragma once
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "text/text.h"

namespace figures {

inline const std::string ink = "#333333", pale = "#aaaaaa", faint = "#e8e8ec", blue = "#0072B2",
                         orange = "#D55E00", green = "#009E73", pink = "#CC79A7",
                         cloth_red = "#e5554c", cloth_cream = "#fdebcb";

struct Point {
  double x = 0, y = 0;
};
inline Point operator+(Point a, Point b) {
  return {a.x + b.x, a.y + b.y};
}
inline Point operator-(Point a, Point b) {
  return {a.x - b.x, a.y - b.y};
}
inline Point operator*(double s, Point a) {
  return {s * a.x, s * a.y};
}
inline double length(Point a) {
  return std::hypot(a.x, a.y);
}

// Data to pixels: (0, 0) of the data lies at `origin`, and their y points up.
struct Scale {
  Point origin;
  double x_unit, y_unit;  // pixels

  Point operator()(double x, double y) const {
    return {origin.x + x_unit * x, origin.y - y_unit * y};
  }
};

struct Stroke {
  std::string colour = ink;
  double width = 2;
  std::string dashes = "";  // "6 4": 6 pixels drawn, 4 left out
};

class Svg {
 public:
  Svg(int width_, int height_) : width(width_), height(height_) {}

  void line(Point a, Point b, const Stroke& stroke = {}) { path({a, b}, stroke); }

  // A line through the points; with `fill` a closed area.
  void path(const std::vector<Point>& points, const Stroke& stroke = {},
            const std::string& fill = "none") {
    std::string list;
    for (const Point& p : points) list += text("%s%.1f,%.1f", list.empty() ? "" : " ", p.x, p.y);
    body += text("<%s points=\"%s\" fill=\"%s\" %s/>\n", fill == "none" ? "polyline" : "polygon",
                 list.c_str(), fill.c_str(), words(stroke).c_str());
  }

  // Many lines of one stroke.
  void lines(const std::vector<std::array<Point, 2>>& all, const Stroke& stroke = {}) {
    std::string moves;
    for (const auto& [a, b] : all) moves += text("M%.1f,%.1fL%.1f,%.1f", a.x, a.y, b.x, b.y);
    body += text("<path d=\"%s\" fill=\"none\" %s/>\n", moves.c_str(), words(stroke).c_str());
  }

  // From a to b, with its head at b.
  void arrow(Point a, Point b, const Stroke& stroke = {}) {
    const double whole = length(b - a), head = std::min(4 + 3 * stroke.width, whole);
    if (whole == 0) return;
    const Point along = 1 / whole * (b - a), across = {-along.y, along.x};
    const Point foot = b - head * along;
    line(a, foot, stroke);
    path({b, foot + 0.4 * head * across, foot - 0.4 * head * across}, {stroke.colour, 0},
         stroke.colour);
  }

  void dot(Point centre, double radius = 5, const std::string& colour = ink) {
    body += text("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"%.1f\" fill=\"%s\"/>\n", centre.x, centre.y,
                 radius, colour.c_str());
  }

  // `anchor` is where the point lies in the text: start, middle or end.
  void label(Point at, const std::string& words, const std::string& colour = ink,
             const std::string& anchor = "middle", int size = 17) {
    body += text(
        "<text x=\"%.1f\" y=\"%.1f\" fill=\"%s\" text-anchor=\"%s\" font-size=\"%d\">%s</text>\n",
        at.x, at.y, colour.c_str(), anchor.c_str(), size, escaped(words).c_str());
  }

  // A label with a white border, readable where it lies on lines.
  void note(Point at, const std::string& words, const std::string& colour = ink,
            const std::string& anchor = "middle", int size = 17) {
    body +=
        "<g stroke=\"white\" stroke-width=\"5\" stroke-linejoin=\"round\" "
        "paint-order=\"stroke\">\n";
    label(at, words, colour, anchor, size);
    body += "</g>\n";
  }

  // The file. Its background is white, so that it is readable on a dark page.
  std::string file() const {
    return text(
               "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %d %d\" width=\"%d\" "
               "height=\"%d\" font-family=\"DejaVu Sans, Verdana, sans-serif\">\n"
               "<rect width=\"100%%\" height=\"100%%\" fill=\"white\"/>\n",
               width, height, width, height) +
           body + "</svg>\n";
  }

 private:
  static std::string words(const Stroke& stroke) {
    return text(
               "stroke=\"%s\" stroke-width=\"%.1f\" stroke-linejoin=\"round\" "
               "stroke-linecap=\"round\"",
               stroke.colour.c_str(), stroke.width) +
           (stroke.dashes.empty() ? "" : " stroke-dasharray=\"" + stroke.dashes + "\"");
  }

  static std::string escaped(const std::string& words) {
    std::string out;
    for (const char c : words) out += c == '&' ? "&amp;" : c == '<' ? "&lt;" : std::string(1, c);
    return out;
  }

  int width, height;
  std::string body;
};

}  // namespace figures
