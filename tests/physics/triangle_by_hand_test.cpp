// One triangle, worked out with pencil and paper; the lesson quotes these numbers. At rest its legs of
// 0.1 m lie along u and v. Vertex 0 stays; vertex 1 is pulled along x by 0.01 m, and vertex 2 as well:
//
//   (u, v)  (0, 0)      (0.1, 0)       (0, 0.1)              k  = 1000 N/m   stretch
//   x       (0, 0, 0)   (0.11, 0, 0)   (0.01, 0.1, 0)        ks =  500 N/m   shear
//
// Dm = 0.1 I, so w_u = 10 (x1 − x0), w_v = 10 (x2 − x0):
//   F = [1.1 0.1; 0 1; 0 0]      |w_u| = 1.1    |w_v| = √1.01 = 1.00498756    w_u·w_v = 0.11
// a = 0.005 m², √a = 0.0707106781 m:
//   C_u = √a 0.1 = 0.00707106781   C_v = √a 0.00498756 = 0.000352674   C_s = √a 0.11 = 0.00777817459
//   E   = k/2 C²:    0.025 J            6.21894e-5 J                        0.015125 J
// Forces on w, −k C ∂C/∂w, in N m; the √a of C and the √a of its derivative make an a:
//   on w_u   stretch  −1000 · 0.005 · 0.1        (1, 0, 0)                   = (−0.5,        0,          0)
//            shear    −500 · 0.005 · 0.11        w_v                         = (−0.0275,    −0.275,      0)
//   on w_v   stretch  −1000 · 0.005 · 0.00498756 (0.0995037, 0.995037, 0)    = (−0.00248140, −0.0248140, 0)
//            shear    −500 · 0.005 · 0.11        w_u                         = (−0.3025,     0,          0)
// Forces on vertices 1 and 2 are ten times those on w_u and on w_v, and vertex 0 balances them.
#include <gtest/gtest.h>

#include "program/diagnostics.h"
#include "step01_explicit/time_step.h"
#include "support/scenes.h"

namespace triangle_by_hand_test {

Mesh triangle_by_hand() {
  Mesh mesh;
  mesh.faces = {{0, 1, 2}};
  mesh.rest = {{Vec2(0, 0), Vec2(0.1, 0), Vec2(0, 0.1)}};
  mesh.x.resize(9);
  mesh.x << 0, 0, 0, 0.11, 0, 0, 0.01, 0.1, 0;
  return mesh;
}

void expect_near(const Vec3& v, const Vec3& expected, double tolerance, const std::string& what) {
  for (const int i : {0, 1, 2})
    EXPECT_NEAR(v[i], expected[i], tolerance) << what << ", "
                                              << "xyz"[i];
}

TEST(TriangleByHand, HasTheseThreadsAndConditions) {
  const Mesh mesh = triangle_by_hand();
  const Triangle t = make_triangle(mesh, 0);
  const Vecs<2> w = gather(t, mesh.x);
  EXPECT_NEAR(t.area, 0.005, 1e-15);
  expect_near(w[0], Vec3(1.1, 0, 0), 1e-14, "w_u");
  expect_near(w[1], Vec3(0.1, 1, 0), 1e-14, "w_v");
  EXPECT_NEAR(Stretch(t, w, 0).C, 0.00707106781, 1e-11);
  EXPECT_NEAR(Stretch(t, w, 1).C, 0.000352674, 1e-9);
  EXPECT_NEAR(Shear(t, w).C, 0.00777817459, 1e-11);
}

TEST(TriangleByHand, HasTheseWeights) {
  const Triangle t = make_triangle(triangle_by_hand(), 0);
  const Eigen::Matrix<double, 2, 3> weights{{-10, 10, 0}, {-10, 0, 10}};
  EXPECT_LT((t.weight - weights).cwiseAbs().maxCoeff(), 1e-13) << t.weight;
}

TEST(TriangleByHand, HasTheseDerivativesAndForcesOnItsThreads) {
  const Mesh mesh = triangle_by_hand();
  const Triangle t = make_triangle(mesh, 0);
  const Vecs<2> w = gather(t, mesh.x);
  const Stretch u(t, w, 0), v(t, w, 1);
  const Shear shear(t, w);
  expect_near(u.dCdy[0], Vec3(0.0707107, 0, 0), 5e-8, "dC_u/dw_u");
  expect_near(v.dCdy[0], Vec3(0.00703598, 0.0703598, 0), 5e-8, "dC_v/dw_v");
  expect_near(shear.dCdy[0], Vec3(0.00707107, 0.0707107, 0), 5e-8, "dC_s/dw_u");
  expect_near(shear.dCdy[1], Vec3(0.0777817, 0, 0), 5e-8, "dC_s/dw_v");
  expect_near(-1000 * u.C * u.dCdy[0], Vec3(-0.5, 0, 0), 1e-12, "stretch on w_u");
  expect_near(-500 * shear.C * shear.dCdy[0], Vec3(-0.0275, -0.275, 0), 1e-12, "shear on w_u");
  expect_near(-1000 * v.C * v.dCdy[0], Vec3(-0.0024814, -0.024814, 0), 5e-8, "stretch on w_v");
  expect_near(-500 * shear.C * shear.dCdy[1], Vec3(-0.3025, 0, 0), 1e-12, "shear on w_v");
}

TEST(TriangleByHand, HasTheseEnergies) {
  const Mesh mesh = triangle_by_hand();
  const Cloth cloth = make_cloth(mesh, model(1000, 500, Gravity::off));
  const TermEnergies energies = elastic_energies(cloth, mesh.x);
  ASSERT_EQ(energies.size(), 2u);
  EXPECT_NEAR(energies[0].second, 0.025 + 6.21894e-5, 1e-10) << energies[0].first;
  EXPECT_NEAR(energies[1].second, 0.015125, 1e-14) << energies[1].first;
}

TEST(TriangleByHand, HasTheseForces) {
  const Mesh mesh = triangle_by_hand();
  const Cloth cloth = make_cloth(mesh, model(1000, 500, Gravity::off));
  step01::System system(cloth);
  step01::forces(cloth, {mesh.x, VecX::Zero(9)}, system);
  const std::array<Vec3, 3> expected = {
      {{8.324814, 2.998140, 0}, {-5.275, -2.75, 0}, {-3.049814, -0.248140, 0}}};
  for (const int i : {0, 1, 2})
    expect_near(system.f.segment<3>(3 * i), expected[i], 6e-7, "vertex " + std::to_string(i));
}

// A third of its 0.2 kg/m² · 0.005 m² for each vertex, and h/m of the force in the first step.
TEST(TriangleByHand, StartsWithThisVelocity) {
  const Mesh mesh = triangle_by_hand();
  const Cloth cloth = make_cloth(mesh, model(1000, 500, Gravity::off));
  EXPECT_NEAR(cloth.mass[3], 0.001 / 3, 1e-16);
  step01::System system(cloth);
  State state{mesh.x, VecX::Zero(9)};
  step01::time_step(cloth, 1e-4, state, system);
  expect_near(state.v.segment<3>(3), Vec3(-1.5825, -0.825, 0), 1e-12, "v_1");
  expect_near(state.x.segment<3>(3), Vec3(0.10984175, -8.25e-5, 0), 1e-14, "x_1");
}

}  // namespace triangle_by_hand_test
