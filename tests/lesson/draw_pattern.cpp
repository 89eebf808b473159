// Draws the pattern of the matrix of a grid of N × N cells: one square per block of 3 × 3 numbers, the
// blocks that one triangle adds to in another colour.
#include <cstdio>
#include <cstdlib>

#include "math/pattern.h"
#include "picture/png.h"
#include "scene/make_cloth.h"

namespace {

using Pixel = std::array<unsigned char, 3>;
constexpr Pixel paper = {255, 255, 255}, grid = {232, 234, 238}, block = {92, 106, 132},
                triangle = {205, 72, 62};
constexpr int side = 24;  // pixels of a block, a line of the grid included

void fill(Image& image, int row, int column, const Pixel& colour) {
  for (int y = row * side + 1; y < (row + 1) * side; ++y)
    for (int x = column * side + 1; x < (column + 1) * side; ++x)
      std::copy(colour.begin(), colour.end(), image.rgb.begin() + 3 * (y * image.width + x));
}

Image empty_sheet(int rows) {
  Image image{rows * side + 1, rows * side + 1, {}};
  for (int i = 0; i < image.width * image.height; ++i)
    image.rgb.insert(image.rgb.end(), grid.begin(), grid.end());
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < rows; ++column) fill(image, row, column, paper);
  return image;
}

}  // namespace

int main(int argc, char** argv) {
  const int cells = argc == 3 ? std::atoi(argv[1]) : 0;
  if (cells < 1 || cells > 40) {
    std::fprintf(stderr, "usage: draw_pattern CELLS file.png, with 1 to 40 cells\n");
    return 2;
  }
  Model model;
  model.add(StretchTerm(1));
  const Cloth cloth = make_cloth(make_grid({1, 1}, {cells, cells}, Diagonals::same), model);
  const BlockMatrix A = make_block_matrix(cloth);

  Image image = empty_sheet(A.rows());
  for (int i = 0; i < A.rows(); ++i) {
    fill(image, i, i, block);
    for (int s = A.row_start[i]; s < A.row_start[i + 1]; ++s) {
      fill(image, i, A.column[s], block);
      fill(image, A.column[s], i, block);
    }
  }
  for (int i : cloth.triangles.elements[size_t(cells)].vertices)
    for (int j : cloth.triangles.elements[size_t(cells)].vertices) fill(image, i, j, triangle);
  write_png(argv[2], image);
}
