#include "program/diagnostics.h"

#include <algorithm>

#include "math/energy.h"
#include "scene/make_cloth.h"

namespace {

// The larger stretch of the two threads of a face: max(|w_u|, |w_v|).
double face_stretch(const Mesh& mesh, size_t face, const VecX& x) {
  const Vecs<2> w = gather(make_triangle(mesh, face), x);
  return std::sqrt(std::max(w[0].squaredNorm(), w[1].squaredNorm()));
}

}  // namespace

[[gnu::flatten]] TermEnergies elastic_energies(const Cloth& cloth, const VecX& x) {
  TermEnergies energies;
  for_each_family(cloth, [&](const auto& family) {
    family.for_each_term([&]<class T>(const std::optional<T>& term) {
      if (!term) return;
      auto entry = std::find_if(energies.begin(), energies.end(),
                                [](const auto& e) { return e.first == T::info.table; });
      if (entry == energies.end()) entry = energies.insert(energies.end(), {T::info.table, 0.0});
      add_elastic_energy(*term, family.elements, x, entry->second);
    });
  });
  return energies;
}

double Energies::elastic() const {
  double sum = 0;
  for (const auto& [name, energy] : by_term) sum += energy;
  return sum;
}

Energies energies(const Cloth& cloth, const State& state) {
  Energies e;
  e.kinetic = kinetic_energy(cloth, state.v);
  e.gravitational = gravitational_energy(cloth, state.x);
  e.by_term = elastic_energies(cloth, state.x);
  return e;
}

double max_stretch(const Mesh& mesh, const VecX& x) {
  double largest = 0;
  for (size_t f = 0; f < mesh.faces.size(); ++f) {
    const double stretch = face_stretch(mesh, f, x);
    if (!(stretch <= largest)) largest = stretch;  // a NaN is kept
  }
  return largest;
}

VecX vertex_strain(const Mesh& mesh, const VecX& x) {
  VecX strain = VecX::Zero(mesh.vertices());
  for (size_t f = 0; f < mesh.faces.size(); ++f) {
    const double face = face_stretch(mesh, f, x) - 1;
    for (int i : mesh.faces[f]) strain[i] = std::max(strain[i], face);
  }
  return strain;
}

double lowest(const VecX& x) {
  double y = x[1];
  for (int i = 4; i < x.size(); i += 3) y = std::min(y, x[i]);
  return y;
}

Eigen::AlignedBox3d box_of(const VecX& x) {
  Eigen::AlignedBox3d box;
  for (int i = 0; i < x.size() / 3; ++i) box.extend(x.segment<3>(3 * i));
  return box;
}

double rms_distance(const VecX& a, const VecX& b) {
  return (a - b).norm() / std::sqrt(double(a.size()) / 3);
}
