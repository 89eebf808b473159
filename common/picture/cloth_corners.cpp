#include "picture/cloth_corners.h"

VecX staged(const VecX& x, const Vec3& origin, double size) {
  VecX result(x.size());
  for (Eigen::Index i = 0; i < x.size(); i += 3)
    result.segment<3>(i) = ((x.segment<3>(i) - origin) / size).cwiseMax(-1e4).cwiseMin(1e4);
  return result;
}

VecX smooth_normals(const std::vector<Face>& faces, const VecX& x) {
  VecX normals = VecX::Zero(x.size());
  for (const Face& face : faces) {
    const Vec3 a = x.segment<3>(3 * face[0]);
    const Vec3 e1 = x.segment<3>(3 * face[1]) - a, e2 = x.segment<3>(3 * face[2]) - a;
    const Vec3 normal = e1.cross(e2);
    for (const int i : face) normals.segment<3>(3 * i) += normal;
  }
  for (Eigen::Index i = 0; i < normals.size(); i += 3) {
    const double length = normals.segment<3>(i).norm();
    if (length > 0)
      normals.segment<3>(i) /= length;
    else
      normals.segment<3>(i) = Vec3::UnitY();
  }
  return normals;
}

std::vector<float> corner_floats(const std::vector<Face>& faces,
                                 const std::vector<std::array<Vec2, 3>>& squares, const VecX& x,
                                 const VecX& strain) {
  const VecX normals = smooth_normals(faces, x);
  std::vector<float> floats;
  floats.reserve(faces.size() * 3 * floats_per_corner);
  const auto add = [&floats](double number) { floats.push_back(static_cast<float>(number)); };
  for (std::size_t f = 0; f < faces.size(); ++f)
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const int i = faces[f][corner];
      for (int d = 0; d < 3; ++d) add(x[3 * i + d]);
      for (int d = 0; d < 3; ++d) add(normals[3 * i + d]);
      for (int d = 0; d < 2; ++d) add(squares[f][corner][d]);
      add(strain.size() > 0 ? strain[i] : 0);
    }
  return floats;
}
