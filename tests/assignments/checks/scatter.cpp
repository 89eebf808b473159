#include "assignments/checks/check.h"
#include "math/triangle.h"

namespace {

// A triangle of the vertices 4, 1, 2 among five.
struct Case {
  explicit Case(Random& random)
      : t(make_triangle(random_rest(random))),
        x(random.vector(15, 1)), f_y{random.vector(3, 1), random.vector(3, 1)} {
    t.vertices = {4, 1, 2};
  }
  VecX scattered() const {
    VecX f = VecX::Zero(15);
    scatter(t, f_y, f);
    return f;
  }
  Triangle t;
  VecX x;
  Vecs<2> f_y;
};

// The forces do the same work on the vertices as on y. So f_i is the slope of Σ f_m·y_m by x_i.
TEST(Scatter, DoesTheSameWork) {
  Random random(seed());
  for (int i = 0; i < 20; ++i) {
    const Case c(random);
    const auto work = [&](const VecX& x) {
      return one_number(joined(c.f_y).dot(joined(gather(c.t, x))));
    };
    const VecX got = c.scattered(), expected = slope_of(work, c.x, 1).transpose();
    for (const int vertex : c.t.vertices)
      AGREES(
          "the force on vertex " + std::to_string(vertex) + " of a triangle with vertices 4, 1, 2",
          got.segment<3>(3 * vertex), expected.segment<3>(3 * vertex), 1e-9);
  }
}

TEST(Scatter, AddsUpToNoNetForce) {
  Random random(seed() + 1);
  for (int i = 0; i < 20; ++i) {
    const VecX net = Case(random).scattered().reshaped(3, 5).rowwise().sum();
    AGREES("the sum of the forces on all vertices", net, VecX::Zero(3), 1e-12);
  }
}

TEST(Scatter, AddsToTheForcesThatAreThere) {
  Random random(seed() + 2);
  const Case c(random);
  VecX f = VecX::Ones(15);
  scatter(c.t, c.f_y, f);
  AGREES("f, which was 1 N everywhere before", f, VecX::Ones(15) + c.scattered(), 1e-12);
}

TEST(Scatter, LeavesOtherVerticesAlone) {
  Random random(seed() + 3);
  const VecX f = Case(random).scattered();
  AGREES("the force on vertex 0, which the triangle does not have", f.segment<3>(0), VecX::Zero(3),
         0);
  AGREES("the force on vertex 3, which the triangle does not have", f.segment<3>(9), VecX::Zero(3),
         0);
}

}  // namespace
