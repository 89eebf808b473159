// The forces of stretch and shear in three ways: ours, the note's formulas vertex by vertex, and
// automatic differentiation of the energy. The cloth and the forces are the same, the costs differ.
#pragma once
#include <vector>

#include "scene/make_cloth.h"
#include "step01_explicit/time_step.h"
#include "support/autodiff_energy.h"
#include "support/poses.h"

inline constexpr double k_stretch = 1000, k_shear = 500;

// A square sheet of n × n cells, every vertex displaced by up to a fifth of a cell.
struct Sheet {
  explicit Sheet(int n) : mesh(make_grid({1, 1}, {n, n}, Diagonals::alternating)) {
    Random random(61);
    state.x = mesh.x + random.vector(int(mesh.x.size()), 0.2 / n);
    state.v = VecX::Zero(mesh.x.size());
  }
  size_t triangles() const { return mesh.faces.size(); }

  Mesh mesh;
  State state;
};

// 1. Ours: the conditions are summed on w_u and w_v, and the sum goes to the vertices once.
class Ours {
 public:
  explicit Ours(const Sheet& sheet) : cloth(make_cloth(sheet.mesh, model())), system(cloth) {}

  const VecX& forces(const State& state) {
    step01::forces(cloth, state, system);
    return system.f;
  }

 private:
  static Model model() {
    Model m;
    m.add(StretchTerm(k_stretch));
    m.add(ShearTerm(k_shear));
    return m;
  }

  Cloth cloth;
  step01::System system;
};

// 2. The formulas of the Baraff–Witkin note (notes 000) as printed: for each condition and vertex i
//
//   f_i −= k C ∂C/∂x_i,   ∂C/∂x_i = α p_u[i] n_u  or  α (p_u[i] w_v + p_v[i] w_u)
//
// with p_u, p_v from the determinant of the rest edges. The note leaves
// the constant α open: α = √a.
class Transcribed {
 public:
  explicit Transcribed(const Sheet& sheet) : f(sheet.mesh.x.size()) {
    for (size_t face = 0; face < sheet.mesh.faces.size(); ++face) {
      const auto& [uv0, uv1, uv2] = sheet.mesh.rest[face];
      const double du1 = uv1.x() - uv0.x(), dv1 = uv1.y() - uv0.y();
      const double du2 = uv2.x() - uv0.x(), dv2 = uv2.y() - uv0.y();
      const double det = du1 * dv2 - du2 * dv1;
      elements.push_back({sheet.mesh.faces[face],
                          {(dv1 - dv2) / det, dv2 / det, -dv1 / det},
                          {(du2 - du1) / det, -du2 / det, du1 / det},
                          std::sqrt(0.5 * std::abs(det))});
    }
  }

  const VecX& forces(const State& state) {
    f.setZero();
    for (const Element& t : elements) {
      Vec3 wu = Vec3::Zero(), wv = Vec3::Zero();
      for (size_t i = 0; i < 3; ++i) {
        const Vec3 x = state.x.segment<3>(3 * t.vertices[i]);
        wu += t.pu[i] * x;
        wv += t.pv[i] * x;
      }
      const double wu_norm = wu.norm(), wv_norm = wv.norm();
      const Vec3 nu = wu / wu_norm, nv = wv / wv_norm;
      const double Cu = t.alpha * (wu_norm - 1), Cv = t.alpha * (wv_norm - 1);
      const double C = t.alpha * wu.dot(wv);
      for (size_t i = 0; i < 3; ++i) {
        const Vec3 dCudx = t.alpha * t.pu[i] * nu;
        const Vec3 dCvdx = t.alpha * t.pv[i] * nv;
        const Vec3 dCdx = t.alpha * (t.pu[i] * wv + t.pv[i] * wu);
        f.segment<3>(3 * t.vertices[i]) -= k_stretch * (dCudx * Cu + dCvdx * Cv);
        f.segment<3>(3 * t.vertices[i]) -= k_shear * dCdx * C;
      }
    }
    return f;
  }

 private:
  struct Element {
    Face vertices;
    std::array<double, 3> pu, pv;
    double alpha;
  };
  std::vector<Element> elements;
  VecX f;
};

// 3. Eigen's AutoDiffScalar on the energy: no derivative is written by hand, but every
// operation carries nine slopes.
class Differentiated {
 public:
  explicit Differentiated(const Sheet& sheet) : mesh(sheet.mesh), f(sheet.mesh.x.size()) {}

  const VecX& forces(const State& state) {
    f.setZero();
    for (size_t face = 0; face < mesh.faces.size(); ++face) {
      const auto& [i, j, k] = mesh.faces[face];
      const std::array<Vec3, 3> x = {state.x.segment<3>(3 * i), state.x.segment<3>(3 * j),
                                     state.x.segment<3>(3 * k)};
      const Nine E = energy_from_scratch(mesh.rest[face], x, {1, 1}, k_stretch, k_shear);
      f.segment<3>(3 * i) -= E.derivatives().head<3>();
      f.segment<3>(3 * j) -= E.derivatives().segment<3>(3);
      f.segment<3>(3 * k) -= E.derivatives().tail<3>();
    }
    return f;
  }

 private:
  const Mesh& mesh;
  VecX f;
};

// The largest difference of two force vectors, relative to the largest force.
inline double difference(const VecX& a, const VecX& b) {
  return (a - b).cwiseAbs().maxCoeff() / b.cwiseAbs().maxCoeff();
}
