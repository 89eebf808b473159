// The lengthwise frequencies of a strip that is held at one end: f_n = (2n − 1)/(4 L) √(k/ρ) for the
// continuous cloth. Rows at a distance h, with lumped masses, vibrate like a chain of springs,
//
//   ω_n = 2/h √(k/ρ) sin((2n − 1) π h/(4 L))
//
// which is lower than f_n by an error of order 2. A column inside the cloth is exactly such a chain, whose
// last vertex has half a mass. At the two lower corners the last vertex has two or four thirds of that,
// because one or two triangles meet there.
#include <gtest/gtest.h>

#include "step01_explicit/time_step.h"
#include "support/modes.h"
#include "support/scenes.h"

namespace vibration_test {

constexpr double k = 100, L = 1;

double chain_omega(int n, int rows) {
  return 2 * rows / L * std::sqrt(k / density) * std::sin((2 * n - 1) * pi / (4 * rows));
}

// A strip 1 m wide, laid down as one chain of springs along x.
Cloth chain(int rows) {
  const double h = L / rows;
  Cloth cloth;
  cloth.mass = VecX::Constant(3 * (rows + 1), density * h);
  cloth.mass.tail<3>() /= 2;
  cloth.inverse_mass = cloth.mass.cwiseInverse();
  cloth.inverse_mass.head<3>().setZero();
  for (int i = 0; i < rows; ++i) cloth.springs.elements.push_back(make_spring(i, i + 1, h));
  cloth.term<SpringTerm>() = SpringTerm(k / h);
  return cloth;
}

MatX stiffness(const Cloth& cloth, const State& state) {
  step01::System system(cloth);
  return stiffness_matrix(cloth, state, step01::forces, system, 1e-6);
}

TEST(LengthwiseVibration, OfAChainOfSpringsHasTheLumpedFrequencies) {
  for (const int rows : {4, 8, 16, 32}) {
    const Cloth cloth = chain(rows);
    State rest{VecX::Zero(3 * (rows + 1)), VecX::Zero(3 * (rows + 1))};
    for (int i = 0; i <= rows; ++i) rest.x[3 * i] = i * L / rows;
    const VecX omega = modes(cloth, stiffness(cloth, rest)).omega.tail(rows);  // the others are 0
    for (int n = 1; n <= rows; ++n)
      EXPECT_NEAR(omega[n - 1] / chain_omega(n, rows), 1, 1e-8) << "mode " << n << " of " << rows;
  }
}

// The mode of the chain on one inner column, with all other columns at rest, is a mode of the cloth.
TEST(LengthwiseVibration, OfAColumnInsideTheClothIsThatOfTheChain) {
  for (const int rows : {4, 8, 16, 32}) {
    const TestScene scene = strip(3.0 / rows, {3, rows}, k, 0, Gravity::off);
    const MatX K = stiffness(scene.cloth, scene.start);
    for (const int n : {1, 2, rows}) {
      VecX p = VecX::Zero(scene.start.x.size());
      for (int row = 0; row < rows; ++row)
        p[3 * (4 * row + 1) + 1] = std::sin((2 * n - 1) * pi / 2 * (1 - double(row) / rows));
      const double omega = chain_omega(n, rows);
      const VecX inertia = omega * omega * scene.cloth.mass.cwiseProduct(p);
      VecX Kp = K * p;
      for (const Pin& pin : scene.cloth.pins) Kp.segment<3>(3 * pin.vertex).setZero();
      EXPECT_LT((Kp - inertia).norm(), 1e-5 * inertia.norm()) << "mode " << n << " of " << rows;
    }
  }
}

// The mode of a cloth with shear that is most like sin(π s/2L), s from the top.
double first_frequency(int rows) {
  const TestScene scene = strip(0.25, {rows / 4, rows}, k, k / 2, Gravity::off);
  const Modes all = modes(scene.cloth, stiffness(scene.cloth, scene.start));
  VecX shape = VecX::Zero(scene.start.x.size());
  for (int i = 0; i < scene.cloth.vertices(); ++i)
    shape[3 * i + 1] = std::sin(-pi / (2 * L) * scene.start.x[3 * i + 1]);
  const VecX likeness = all.shape.transpose() * scene.cloth.mass.cwiseProduct(shape);
  Eigen::Index mode;
  likeness.cwiseAbs().maxCoeff(&mode);
  return all.omega[mode] / (2 * pi);
}

// The light and the heavy corner couple the columns through shear, and less so on a finer mesh. The expected
// values come from an independent program. (With 8 rows this mode mixes with a sideways one.)
TEST(LengthwiseVibration, OfTheClothComesFourTimesCloserAsTheCellsHalve) {
  const double exact = std::sqrt(k / density) / (4 * L);  // 5.590170 Hz
  const double f4 = first_frequency(4), f16 = first_frequency(16), f32 = first_frequency(32);
  EXPECT_NEAR(f4, 5.5394, 5e-5);
  EXPECT_NEAR(f16, 5.58801, 1e-5);
  EXPECT_NEAR(f32, 5.58961, 5e-6);
  const double order_4_16 = std::log2((exact - f4) / (exact - f16)) / 2;
  const double order_16_32 = std::log2((exact - f16) / (exact - f32));
  EXPECT_NEAR(order_4_16, 2, 0.3);
  EXPECT_NEAR(order_16_32, 2, 0.1);
}

}  // namespace vibration_test
