// Claims of the Baraff–Witkin note (notes 000 in the bibliography) on damping and on the implicit step,
// computed again. Each test says what the note prints and what is right.
//
// Tests elsewhere show more of it: Matrix, Definite, Solvers, PrintedMatrix.
#include <gtest/gtest.h>

#include <set>

#include "math/pattern.h"
#include "step03_implicit/time_step.h"
#include "support/dense.h"
#include "support/energy.h"

namespace baraff_witkin_implicit_test {

const Rest unit_rest = {Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)};

VecX vector_of(std::initializer_list<double> numbers) {
  return Eigen::Map<const VecX>(numbers.begin(), Eigen::Index(numbers.size()));
}

// Damping ----------------------------------------------------------------------------------------

// The note: K is symmetric because of action and reaction. That is not why: the damping force has neither a
// net force nor a torque, and yet its slope, −kd (g (H v)ᵀ + Ċ H), is not symmetric. A slope is symmetric if
// the force has an energy, because K = −∂²E/∂x².
TEST(Notes000, ActionAndReactionDoNotMakeASlopeSymmetric) {
  const Cloth cloth = one_triangle(make_triangle(unit_rest), 1, 1);
  const VecX x = vector_of({0, 0, 0, 1.2, 0.3, 0.1, -0.2, 0.9, 0.3});
  const VecX v = vector_of({0.5, -1, 0, 1, 2, 0.3, -0.7, 0.2, 1});
  VecX d = VecX::Zero(9);
  MatX J = MatX::Zero(9, 9), K = J;
  for (const DenseCondition& c : dense_conditions(cloth, x)) {
    const double Cdot = c.g.dot(v);
    d -= Cdot * c.g;
    J -= c.g * (c.H * v).transpose() + Cdot * c.H;
    K -= c.g * c.g.transpose() + c.C * c.H;
  }
  Vec3 net = Vec3::Zero(), torque = Vec3::Zero();
  for (int i = 0; i < 9; i += 3) {
    net += d.segment<3>(i);
    torque += Vec3(x.segment<3>(i)).cross(Vec3(d.segment<3>(i)));
  }
  EXPECT_GT(d.norm(), 1);
  EXPECT_LT(net.norm() + torque.norm(), 1e-14);
  EXPECT_LT((K - K.transpose()).norm(), 1e-14);
  EXPECT_NEAR((J - J.transpose()).norm() / J.norm(), 0.869, 5e-4);
}

// The note: the part g (H v)ᵀ of that slope is left out because it is small. Beside the part that is kept it
// is not (Matrix.TheOmittedPartIsNotSmallBesideTheKeptOne). Beside h D, which stays in the matrix as well, it
// is: a cloth that turns by ω has h² kd g (H v)ᵀ and h kd g gᵀ, and their ratio is h ω.
TEST(Notes000, OmittedDampingIsHOmegaTimesWhatStays) {
  const double h = 0.02;
  const Cloth cloth = one_triangle(make_triangle(unit_rest), 1, 0);
  const VecX x = vector_of({0, 0, 0, 1, 0, 0, 0, 1, 0});
  for (const double omega : {1.0, 10.0, 50.0}) {
    const VecX v = omega * vector_of({0, 0, 0, 0, 1, 0, -1, 0, 0});
    for (const DenseCondition& c : dense_conditions(cloth, x)) {
      EXPECT_NEAR(c.g.dot(v), 0, 1e-14) << "a rotation has no rate";
      const MatX omitted = h * h * c.g * (c.H * v).transpose(), stays = h * c.g * c.g.transpose();
      EXPECT_NEAR(omitted.norm() / stays.norm(), h * omega, 1e-12);
    }
  }
}

// What is kept, Ċ H, can make the matrix indefinite all the same, where the thread gets shorter.
TEST(Notes000, KeptDampingIsNegativeWhereAThreadGetsShorter) {
  const Cloth cloth = one_triangle(make_triangle(unit_rest), 1, 0);
  const VecX x = vector_of({0, 0, 0, 1, 0, 0, 0, 1, 0});
  const DenseCondition thread = dense_conditions(cloth, x)[0];
  for (const double speed : {-1.0, 1.0}) {
    const VecX v = vector_of({0, 0, 0, speed, 0, 0, 0, 0, 0});
    const MatX kept = thread.g.dot(v) * thread.H;
    EXPECT_EQ(eigenvalues(kept)[0] < -0.1, speed < 0);
  }
}

// The implicit step ------------------------------------------------------------------------------

// The note divides by the mass: (I − h M⁻¹ D − h² M⁻¹ K). That is symmetric only if all masses are equal
// (Solvers.TheNotesFormGivesTheSameStepAndIsSymmetricOnlyForEqualMasses). Those of a grid are not: they are
// 1, 1/2, 1/3 and 1/6 of the mass of an inner vertex.
TEST(Notes000, MassesOfAGridTakeFourValues) {
  const Mesh mesh = make_grid({1, 1}, {6, 6}, Diagonals::same);
  const Cloth cloth = make_cloth(mesh, Model().add(StretchTerm(500)));
  std::set<long> sixths;
  for (const double m : cloth.mass) {
    const double share = 6 * m / cloth.mass.maxCoeff();
    EXPECT_NEAR(share, std::round(share), 1e-12);
    sixths.insert(std::lround(share));
  }
  EXPECT_EQ(sixths, (std::set<long>{1, 2, 3, 6}));
}

// One vibration of two masses, 100 steps of h ω = 0.1: the energy that is left, from 1.
struct Vibration {
  static constexpr double h = 0.1;
  Cloth cloth = one_spring(make_spring(0, 1, 0), 0.5);  // ω² = 2 k/m = 1
  State state = {vector_of({1, 0, 0, -1, 0, 0}), VecX::Zero(6)};

  double energy_now() const {
    return kinetic_energy(cloth, state.v) + ::energy(cloth.springs, state.x);
  }
  template <class Step>
  double energy_after_hundred(const Step& step) {
    const double before = energy_now();
    for (int n = 0; n < 100; ++n) step();
    return energy_now() / before;
  }
};

// The note: the implicit step solves correctly however long h is; and h must be small enough. Neither is
// right. It is stable, not accurate: per step it keeps 1/(1 + h²ω²) of the energy. Forward Euler gains the
// same factor, symplectic Euler keeps the energy in bounds.
TEST(Notes000, TheImplicitStepIsStableAndLosesEnergy) {
  Vibration implicit;
  step03::System system(implicit.cloth);
  const double kept = implicit.energy_after_hundred(
      [&] { step03::time_step(implicit.cloth, Vibration::h, implicit.state, system); });
  EXPECT_NEAR(kept, std::pow(1.01, -100), 1e-12);
  EXPECT_NEAR(kept, 0.370, 5e-4);

  Vibration forward;
  const double gained = forward.energy_after_hundred([&] {
    State& s = forward.state;
    const VecX f = forces(forward.cloth, s.x);
    s.x += Vibration::h * s.v;
    s.v += Vibration::h * f;
  });
  EXPECT_NEAR(gained, std::pow(1.01, 100), 1e-12);
  EXPECT_NEAR(gained, 2.705, 5e-4);

  Vibration symplectic;
  step01::System explicit_system(symplectic.cloth);
  const double bounded = symplectic.energy_after_hundred([&] {
    step01::time_step(symplectic.cloth, Vibration::h, symplectic.state, explicit_system);
  });
  EXPECT_NEAR(bounded, 0.956, 5e-4);
}

// The matrix -------------------------------------------------------------------------------------

// The note takes for granted that A = M − h² K is positive definite, as conjugate gradients need it. A sheet
// of 1 m² and 6 × 6 cells, k = 500 N/m, h = 0.02 s: it is so at rest, and no longer where it is 1 % shorter
// both ways. The definite matrix stays above the smallest mass.
TEST(Notes000, PrintedMatrixIsIndefiniteAtOnePercentOfCompression) {
  const Mesh mesh = make_grid({1, 1}, {6, 6}, Diagonals::same);
  const Cloth cloth = make_cloth(mesh, Model().add(StretchTerm(500)).add(ShearTerm(500)));
  const double h = 0.02;
  const auto lowest = [&](double compression, Jacobian jacobian) {
    const VecX x = (1 - compression) * mesh.x;
    MatX A = -h * h * evaluate(cloth, {x, VecX::Zero(x.size())}, jacobian).K;
    A.diagonal() += cloth.mass;
    return eigenvalues(A)[0];
  };
  const double lightest = cloth.mass.minCoeff();
  EXPECT_NEAR(lightest, 9.26e-4, 1e-6);
  EXPECT_NEAR(lowest(0, Jacobian::bw98), lightest, 1e-12);
  EXPECT_NEAR(lowest(0.001, Jacobian::bw98), 7.1e-4, 1e-5);
  EXPECT_NEAR(lowest(0.01, Jacobian::bw98), -9.8e-3, 1e-4);
  EXPECT_NEAR(lowest(0.05, Jacobian::bw98), -7.4e-2, 1e-3);
  EXPECT_NEAR(lowest(0.05, Jacobian::definite), lightest, 1e-12);
}

// The sheared triangle of the note: its printed −K has the eigenvalues −1, −1 and −0.91.
TEST(Notes000, PrintedMatrixOfTheShearedTriangleHasThreeNegativeEigenvalues) {
  const Cloth cloth = one_triangle(make_triangle(unit_rest), 0, 2);  // 2: the note has α = 1
  const VecX x = vector_of({0, 0, 0, 1, 0.5, 0, 0.5, 1, 0});
  const VecX values = eigenvalues(-evaluate(cloth, {x, VecX::Zero(9)}, Jacobian::bw98).K);
  EXPECT_LT((values.head<3>() - Vec3(-1, -1, -0.908327)).norm(), 1e-6);
  EXPECT_LT(values.segment<3>(3).norm(), 1e-14) << "moves";
  EXPECT_GT(values[6], 1);
}

// C ∂²C/∂x² of a thread that collapses grows like 1/|w|. In the note it has no limit. Ours has one, because
// |w| is smoothed below 1e-9 (math/condition.h).
TEST(Notes000, PrintedMatrixGrowsWithoutBoundAsAThreadCollapses) {
  for (const auto& [w, size] : {std::pair{0.1, 25.46}, {1e-4, 2.828e4}, {1e-8, 2.828e8}}) {
    const VecX x = vector_of({0, 0, 0, w, 0, 0, 0, 1, 0});
    const DenseCondition thread =
        dense_conditions(one_triangle(make_triangle(unit_rest), 2, 0), x)[0];
    EXPECT_NEAR(2 * std::abs(thread.C) * thread.H.norm() / size, 1, 0.01) << w;
  }
}

// Columns ----------------------------------------------------------------------------------------

using Offset = std::pair<int, int>;

// The neighbours of an inner vertex in the matrix, itself included, as steps along u and v.
std::set<Offset> neighbours(const Model& model) {
  const int cells = 8, i = 4, j = 4, vertex = j * (cells + 1) + i;
  const Cloth cloth = make_cloth(make_grid({1, 1}, {cells, cells}, Diagonals::same), model);
  const BlockMatrix A = make_block_matrix(cloth);
  std::set<Offset> found = {{0, 0}};
  for (int row = 0; row < A.rows(); ++row)
    for (int s = A.row_start[size_t(row)]; s < A.row_start[size_t(row) + 1]; ++s) {
      const int column = A.column[size_t(s)];
      if (row != vertex && column != vertex) continue;
      const int other = row == vertex ? column : row;
      found.insert({other % (cells + 1) - i, other / (cells + 1) - j});
    }
  return found;
}

// The note: a row of K has at most 21 columns, of seven vertices. Right for stretch and shear. Bending
// couples a vertex with twelve others: 39 columns. A table of 21 loses six of them without a warning.
TEST(Notes000, ARowHasTwentyOneColumnsAndThirtyNineWithBending) {
  Model model;
  model.add(StretchTerm(500)).add(ShearTerm(500));
  std::set<Offset> all = {{0, 0}, {1, 0}, {-1, 0}, {0, 1}, {0, -1}, {-1, 1}, {1, -1}};
  EXPECT_EQ(neighbours(model), all);
  all.insert({{1, 1}, {-1, -1}, {-2, 1}, {2, -1}, {-1, 2}, {1, -2}});
  EXPECT_EQ(neighbours(model.add(DihedralBend(1e-4))), all);
  EXPECT_EQ(3 * all.size(), 39u);
}

}  // namespace baraff_witkin_implicit_test
