// A thread that has collapsed to a point has no direction. Nothing may become infinite there, and
// nothing may change where the thread has a length.
#include <gtest/gtest.h>

#include "support/energy.h"
#include "support/poses.h"

namespace guard_test {

Triangle unit_triangle() {
  return make_triangle({Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)});
}

TEST(Guard, LengthIsTheNormToTheLastDigitWhereThereIsOne) {
  Random random(11);
  for (const double size : {0.1, 0.3, 1.0, 10.0, 1e4})
    for (int i = 0; i < 1000; ++i) {
      const Vec3 w = size * 1.0001 * random.direction();
      const Length length(w);
      EXPECT_DOUBLE_EQ(length.value, w.norm());  // within 4 units of the last place
      EXPECT_LT((length.n - w / w.norm()).norm(), 4e-16) << "|w| = " << size;
    }
}

TEST(Guard, AtAPointTheEnergyIsThatOfThreadsWithoutLength) {
  const Vec3 point(3, -2, 5);
  VecX x(9);
  x << point, point, point;
  const Cloth cloth = one_triangle(unit_triangle(), 100, 50);
  EXPECT_NEAR(potential_energy(cloth, x), 100 / 2 * 0.5 * 2, 1e-6);  // k/2 a (b² + b²)

  const Cloth spring = one_spring(make_spring(0, 1, 0.5), 100);
  EXPECT_NEAR(potential_energy(spring, x.head(6)), 100 / 2 * 0.25, 1e-6);
}

// For every length of the thread: |f_i| = k |C| |∂C/∂x_i| ≤ k √a b · √a |weight(m, i)| for each of the
// two.
TEST(Guard, ForceOfAShortThreadIsBounded) {
  Random random(12);
  const double k = 7;
  for (double size = 1; size > 1e-320; size /= 10)
    for (int i = 0; i < 10; ++i) {
      const Rest rest = random_rest(random);
      const Triangle t = make_triangle(rest);
      const Vecs<2> w = {size * random.direction(), size * random.direction()};
      const VecX f = forces(one_triangle(t, k, 0), positions(rest, w, Vec3::Zero()));
      for (int vertex = 0; vertex < 3; ++vertex) {
        const double bound = k * t.area * t.weight.col(vertex).cwiseAbs().sum();
        EXPECT_LE(f.segment<3>(3 * vertex).norm(), bound * (1 + 1e-12)) << "|w| = " << size;
      }
    }
}

// Where a thread shrinks to a point and grows again, its direction turns over. Without the guard n jumps by 2
// there; with it n is differentiable, and its slope is nowhere above 1/ε.
TEST(Guard, DirectionTurnsOverWithoutAJump) {
  Random random(13);
  const double step = Length::epsilon / 100;
  for (int line = 0; line < 20; ++line) {
    const Vec3 d = random.direction(), aside = random.between(0, 2) * step * random.direction();
    Vec3 before = Length(-2000 * step * d + aside).n;
    EXPECT_LT((before + d).norm(), 0.1);
    for (int i = -1999; i <= 2000; ++i) {
      const Vec3 n = Length(i * step * d + aside).n;
      EXPECT_LE((n - before).norm(), step / Length::epsilon * (1 + 1e-9)) << "step " << i;
      EXPECT_LT(n.norm(), 1);
      before = n;
    }
    EXPECT_LT((before - d).norm(), 0.1);
  }
}

}  // namespace guard_test
