// Dense matrices of a cloth: every condition on all coordinates, with its gradient g = ∂C/∂x and its second
// derivative H = ∂²C/∂x². The matrices that the steps assemble block by block must be the same.
#pragma once
#include <vector>

#include "math/block_matrix.h"
#include "math/method.h"
#include "scene/make_cloth.h"
#include "support/decompositions.h"
#include "support/poses.h"

MatX dense(const BlockMatrix&);

struct DenseCondition {
  Term term;
  double C;
  VecX g;
  MatX H;
};

std::vector<DenseCondition> dense_conditions(const Cloth&, const VecX& x);

// What the definite matrix keeps of Σ k C H, by eigenvectors: of every triangle and spring the positive part
// of its tension T_mn = nᵀ S_mn n, for every direction n across it.
MatX dense_tension(const Cloth&, const VecX& x);

// A square metre with stretch, shear, two springs across and damping in all of them.
Cloth rich_cloth(const Mesh&);

Mesh small_grid();

// The grid disturbed by up to `size` m in every coordinate, with velocities of up to 2 m/s.
State disturbed(const Mesh&, double size, Random&);

// f, K and D of step 3 at a state.
struct Evaluated {
  VecX f;
  MatX K, D;
};

Evaluated evaluate(const Cloth&, const State&, Jacobian);

double relative(const MatX& a, const MatX& b);  // |a − b|/|b|
