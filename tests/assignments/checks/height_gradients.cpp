#include "assignments/checks/check.h"
#include "math/angle.h"

namespace {

// Three corners that are no line.
Vecs<3> random_flap(Random& random) {
  Vecs<3> p;
  Corners d;
  do {
    for (Vec3& point : p) point = random.vector(3, 1);
    d = make_flap(p[0], p[1], p[2]).d;
  } while (std::min({d[0], d[1], d[2]}) < 0.2);
  return p;
}

std::string gradient_of(int i) {
  return "∂d_" + std::to_string(i) + "/∂x of a random flap";
}

TEST(HeightGradients, AreTheSlopesOfTheHeights) {
  Random random(seed());
  for (int n = 0; n < 20; ++n) {
    const Vecs<3> p = random_flap(random);
    const Flap flap = make_flap(p[0], p[1], p[2]);
    for (int i = 0; i < 3; ++i) {
      const auto height = [i](const VecX& x) {
        return one_number(make_flap(x.head<3>(), x.segment<3>(3), x.tail<3>()).d[i]);
      };
      AGREES(gradient_of(i), joined(height_gradients(flap, i)),
             slope_of(height, joined(p), 1e-3).transpose(), 1e-5);
    }
  }
}

// Moving the whole flap changes no height.
TEST(HeightGradients, AddUpToZero) {
  Random random(seed() + 1);
  for (int n = 0; n < 20; ++n) {
    const Vecs<3> p = random_flap(random);
    for (int i = 0; i < 3; ++i) {
      const Vecs<3> g = height_gradients(make_flap(p[0], p[1], p[2]), i);
      AGREES("the sum over the corners of " + gradient_of(i), VecX(g[0] + g[1] + g[2]),
             VecX::Zero(3), 1e-9);
    }
  }
}

// A flap that is twice as large is twice as high: Σ x·∂d/∂x = d.
TEST(HeightGradients, GrowWithTheFlap) {
  Random random(seed() + 2);
  for (int n = 0; n < 20; ++n) {
    const Vecs<3> p = random_flap(random);
    const Flap flap = make_flap(p[0], p[1], p[2]);
    for (int i = 0; i < 3; ++i)
      AGREES("the sum of x_j · ∂d_" + std::to_string(i) + "/∂x_j over the corners, which is d_" +
                 std::to_string(i),
             joined(p).dot(joined(height_gradients(flap, i))), flap.d[i], 1e-9);
  }
}

// A right angle at corner 1, legs of 2 m and 1 m, in the plane z = 0.
TEST(HeightGradients, OfAFlapByHand) {
  const Flap flap = make_flap(Vec3(-2, 0, 0), Vec3(0, 0, 0), Vec3(0, 1, 0));
  VecX expected(9);
  expected << -1, 0, 0, 1, 0, 0, 0, 0, 0;  // the height of corner 0 stands on corner 1
  AGREES("∂d_0/∂x of a flap, 2 m high, whose height stands on corner 1",
         joined(height_gradients(flap, 0)), expected, 1e-12);
}

}  // namespace
