// The figures in the lesson of step 1.
#include "tests/lesson/figures/figures.h"

namespace {

using namespace figures;

// A triangle on the flat cloth, in (u, v), and the same triangle in space, with the images of the two
// threads, w_u and w_v.
Svg triangle() {
  Svg svg(720, 300);
  const Point flat[] = {{70, 230}, {230, 230}, {70, 70}},
              bent[] = {{430, 240}, {650, 200}, {470, 60}};
  svg.path({flat[0], flat[1], flat[2]}, {ink, 2}, cloth_cream);
  svg.path({bent[0], bent[1], bent[2]}, {ink, 2}, cloth_cream);
  svg.arrow(flat[0], 0.5 * (flat[0] + flat[1]), {blue, 4});
  svg.arrow(flat[0], 0.5 * (flat[0] + flat[2]), {orange, 4});
  svg.arrow(bent[0], 0.5 * (bent[0] + bent[1]), {blue, 4});
  svg.arrow(bent[0], 0.5 * (bent[0] + bent[2]), {orange, 4});
  svg.label({150, 260}, "u", blue);
  svg.label({45, 155}, "v", orange);
  svg.label({545, 245}, "w_u", blue);
  svg.label({430, 150}, "w_v", orange);
  svg.arrow({290, 150}, {390, 150}, {pale, 2});
  svg.label({340, 135}, "x(u, v)", pale);
  svg.label({150, 30}, "the flat cloth", ink, "middle", 15);
  svg.label({540, 30}, "in space", ink, "middle", 15);
  return svg;
}

}  // namespace

int main(int argc, char** argv) {
  return figures::run(argc, argv, FIGURES, {{"triangle.svg", triangle}});
}
