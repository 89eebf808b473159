#include "cantilever.h"

HeldStrip::HeldStrip(const Cantilever& c)
    : c_(c),
      mesh(make_grid({(c.N + 1) * c.h(), c.across * c.h()}, {c.N + 1, c.across}, c.diagonals)) {
  shake();
  Model m =
      model(c.membrane * c.B / (c.L * c.L), 0.5 * c.membrane * c.B / (c.L * c.L), Gravity::on);
  add_bend(m, c.bend_model, stiffness_of_modulus(c.bend_model, c.B).value_or(c.spring_k));
  for (const int row : {0, 1})
    for (int j = 0; j <= c.across; ++j) m.pins.push_back(mesh.grid->vertex(row, j));
  cloth = make_cloth(mesh, m);
}

Sparse HeldStrip::freedom() const {
  std::vector<std::vector<int>> unknowns;
  for (int row = 2; row <= c_.N + 1; ++row) {
    if (c_.rows == Rows::locked) {
      unknowns.push_back(coordinates(row, 0));
      unknowns.push_back(coordinates(row, 1));
    } else {
      for (const int axis : {0, 1, 2})
        for (const int coordinate : coordinates(row, axis)) unknowns.push_back({coordinate});
    }
  }
  return ::freedom(mesh.x.size(), unknowns);
}

double HeldStrip::down(const VecX& x) const {
  return -mean(x, 1);
}

double HeldStrip::out(const VecX& x) const {
  return mean(x, 0) - c_.h() / 2;
}

double HeldStrip::mean(const VecX& x, int axis) const {
  return x(coordinates(c_.N + 1, axis)).mean();
}

std::vector<int> HeldStrip::coordinates(int row, int axis) const {
  std::vector<int> found;
  for (int j = 0; j <= c_.across; ++j) found.push_back(3 * mesh.grid->vertex(row, j) + axis);
  return found;
}

void HeldStrip::shake() {
  if (c_.jitter == 0) return;
  Random random(52);
  const double most = c_.jitter * c_.h();
  for (int row = 2; row <= c_.N; ++row)
    for (int j = 0; j <= c_.across; ++j) {
      const int i = 3 * mesh.grid->vertex(row, j);
      mesh.x[i] += random.between(-most, most);
      if (j > 0 && j < c_.across) mesh.x[i + 2] += random.between(-most, most);
    }
  for (size_t face = 0; face < mesh.faces.size(); ++face)
    for (int corner = 0; corner < 3; ++corner) {
      const Vec3 x = mesh.x.segment<3>(3 * mesh.faces[face][corner]);
      mesh.rest[face][corner] = Vec2(x.x(), -x.z());
    }
}

std::vector<Tip> tips(const Cantilever& c, const std::vector<double>& Gammas) {
  HeldStrip strip(c);
  const Sparse P = strip.freedom();
  VecX x = strip.mesh.x;
  std::vector<Tip> all;
  for (const double Gamma : Gammas) {
    strip.weigh(Gamma);
    x = equilibrium(strip.cloth, P, x);
    all.push_back({strip.down(x), strip.out(x)});
  }
  return all;
}
