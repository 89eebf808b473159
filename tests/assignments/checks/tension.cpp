#include <Eigen/Eigenvalues>

#include "assignments/checks/check.h"
#include "math/tension.h"

namespace {

using Mat2 = Square<2>;

// A symmetric matrix with these eigenvalues, and axes that are turned by `angle`.
Mat2 with_eigenvalues(double first, double second, double angle) {
  const Mat2 R = Eigen::Rotation2Dd(angle).toRotationMatrix();
  return R * Eigen::Vector2d(first, second).asDiagonal() * R.transpose();
}

TEST(Tension, KeepsAPositiveMatrix) {
  const Mat2 T = with_eigenvalues(2, 5, 0.3);
  AGREES("T₊ of a matrix with the eigenvalues 2 and 5", positive_part(T), T, 1e-12);
}

TEST(Tension, DropsANegativeMatrix) {
  AGREES("T₊ of a matrix with the eigenvalues −2 and −5",
         positive_part(with_eigenvalues(-2, -5, 0.3)), Mat2::Zero(), 1e-12);
}

TEST(Tension, KeepsThePositiveHalf) {
  Random random(seed());
  for (int i = 0; i < 50; ++i) {
    const double high = random.between(0.1, 3), low = -random.between(0.1, 3),
                 angle = random.between(-pi, pi);
    AGREES("T₊ of a matrix with one positive and one negative eigenvalue",
           positive_part(with_eigenvalues(high, low, angle)), with_eigenvalues(high, 0, angle),
           1e-12);
  }
}

TEST(Tension, AcceptsEqualEigenvalues) {
  AGREES("T₊ of twice the identity", positive_part(Mat2(2 * Mat2::Identity())),
         2 * Mat2::Identity(), 1e-12);
  AGREES("T₊ of zero", positive_part(Mat2(Mat2::Zero())), Mat2::Zero(), 0);
}

}  // namespace
