// Block incomplete Cholesky without fill, IC(0), for any mesh.
//
//   A ≈ (Δ + U)ᵀ Δ⁻¹ (Δ + U)          Δ block diagonal, U strictly upper
//
// Cholesky eliminates row k from its later neighbours i ≤ j,
//
//   A_ij −= A_kiᵀ Δ_k⁻¹ A_kj,   Δ_k = A_kk when its turn comes,
//
// and IC(0) does so only where A has a block (i, j). What is dropped can cost a Δ_k its definiteness;
// then the factorisation begins again with more on the diagonal, (1 + shift) A_ii.
#pragma once
#include "math/pinned_blocks.h"
#include "math/preconditioner.h"

class IncompleteCholesky : public Preconditioner {
 public:
  IncompleteCholesky(const BlockMatrix& pattern, const std::vector<Pin>& pins);

  void set(const BlockMatrix& A) override;
  void apply(const VecX& r, VecX& s) override;

  double shift = 0;  // of the last factorisation

 private:
  bool factorise();

  PinnedBlocks pinned;
  BlockMatrix U;              // begins as S A S + I − S
  std::vector<Mat3> inverse;  // Δ_k⁻¹
  std::vector<int> targets;   // the slots of (i, j) in the order of elimination, −1 if A has none
};
