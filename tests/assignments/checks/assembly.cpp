#include "assignments/checks/check.h"
#include "assignments/checks/cloths.h"

namespace {

// The matrix of one triangle, 9 × 9 with random numbers, added to that of a cloth. The vertices of the triangle
// come in every order: its block (0, 1) may belong above or below the diagonal.
struct Case {
  Case(const Face& order, unsigned variant) {
    Random random(seed() + variant);
    SmallCloth small(2);
    BlockMatrix A = make_block_matrix(small.cloth);
    const Face& vertices = order;
    Slots<3> slots;
    for (int i = 0, pair = 0; i < 3; ++i)
      for (int j = i + 1; j < 3; ++j, ++pair)
        slots[pair] =
            A.slot(std::min(vertices[i], vertices[j]), std::max(vertices[i], vertices[j]));
    MatX B = random.vector(81, 1).reshaped(9, 9);
    B = MatX(B + B.transpose());
    expected = MatX::Zero(27, 27);
    for (int i = 0, pair = 0; i < 3; ++i) {
      add_block<3>(vertices, i, i, 0, slots, Mat3(B.block<3, 3>(3 * i, 3 * i)), A);
      for (int j = i + 1; j < 3; ++j, ++pair)
        add_block<3>(vertices, i, j, pair, slots, Mat3(B.block<3, 3>(3 * i, 3 * j)), A);
      for (int j = 0; j < 3; ++j)
        expected.block<3, 3>(3 * vertices[i], 3 * vertices[j]) = B.block<3, 3>(3 * i, 3 * j);
    }
    got = whole(A);
  }
  MatX got, expected;
};

TEST(Assembly, InTheOrderOfTheVertices) {
  const Case c({0, 1, 4}, 0);
  AGREES("the matrix of the cloth, for a triangle of the vertices 0, 1, 4", c.got, c.expected,
         1e-12);
}

TEST(Assembly, InAnyOrder) {
  unsigned variant = 1;
  for (const Face& order :
       {Face{4, 1, 0}, Face{1, 4, 0}, Face{4, 0, 1}, Face{8, 4, 7}, Face{4, 8, 7}}) {
    const Case c(order, variant++);
    AGREES("the matrix of the cloth, for a triangle of the vertices " + std::to_string(order[0]) +
               ", " + std::to_string(order[1]) + ", " + std::to_string(order[2]),
           c.got, c.expected, 1e-12);
  }
}

}  // namespace
