#include "math/pin.h"

Vec3 led_by(std::span<const Pin> pins, const Vec3& v) {
  Mat3 holds = Mat3::Zero();  // Σ (I − S)
  Vec3 prescribed = Vec3::Zero();
  for (const Pin& pin : pins) {
    holds += Mat3::Identity() - pin.S;
    prescribed += pin.held(Vec3::Zero());
  }
  const Eigen::SelfAdjointEigenSolver<Mat3> eigen(holds);
  Vec3 u = Vec3::Zero();
  for (int i = 0; i < 3; ++i) {
    const Vec3 n = eigen.eigenvectors().col(i);
    const double held = eigen.eigenvalues()[i];  // at most the number of pins; zero if none holds n
    u += (held > 1e-9 ? n.dot(prescribed) / held : n.dot(v)) * n;
  }
  return u;
}
