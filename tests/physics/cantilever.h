// A strip of cloth, held horizontally at one end, that bends under its own weight.
//
//   ├──┼──●──●── … ──●     rows of vertices across, h apart; the first two are held
//     ↑ clamp        ↑ L
//
// A hinge stands for the bend of the half cells on both sides of its row. The hinge of the second row, which
// is held, stands for half a cell before the row. So the clamp lies there, and h = L/(N + 1/2).
#pragma once
#include "support/elastica.h"
#include "support/poses.h"
#include "support/scenes.h"
#include "support/statics.h"

// Locked rows stay straight and level: each has two unknowns, and the strip is a thread with hinges. A cloth
// with free rows may also warp across its width.
enum class Rows { locked, free };

struct Cantilever {
  int N = 32;  // rows that move
  Rows rows = Rows::locked;
  Diagonals diagonals = Diagonals::same;
  BendModel bend_model = BendModel::dihedral;
  int across = 1;         // cells
  double spring_k = 0;    // N/m, where the model is springs: they have no modulus
  double membrane = 1e6;  // k L²/B of stretch
  double jitter = 0;      // how far vertices are from their places on the grid, in h

  static constexpr double L = 1, B = 0.01;  // m, N·m
  double h() const { return L / (N + 0.5); }
};

class HeldStrip {
 public:
  explicit HeldStrip(const Cantilever&);

  Sparse freedom() const;

  // Γ = ρ g L³/B
  void weigh(double Gamma) {
    cloth.gravity = Vec3(0, -Gamma * c_.B / (density * c_.L * c_.L * c_.L), 0);
  }

  // H and W of the last row.
  double down(const VecX& x) const;
  double out(const VecX& x) const;

 private:
  double mean(const VecX& x, int axis) const;
  std::vector<int> coordinates(int row, int axis) const;
  // Rows that are held, the last one and the long edges keep their lines.
  void shake();

  Cantilever c_;

 public:
  Mesh mesh;
  Cloth cloth;
};

struct Tip {
  double down, out;  // m

  double droop() const { return down / out; }
};

// The tip for each Γ of a growing list. The strip begins flat, and the weight grows from one Γ to the next.
std::vector<Tip> tips(const Cantilever&, const std::vector<double>& Gammas);
