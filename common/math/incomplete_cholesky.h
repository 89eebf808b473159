// Block incomplete Cholesky without fill, IC(0), for any mesh.
//
//   A ≈ (Λ + U)ᵀ Λ⁻¹ (Λ + U)          Λ block diagonal, U strictly upper
//
// Cholesky eliminates row k from its later neighbours i ≤ j,
//
//   A_ij −= A_kiᵀ Λ_k⁻¹ A_kj,   Λ_k = A_kk when its turn comes,
//
// and IC(0) does so only where A has a block (i, j). What is dropped can cost a Λ_k its definiteness;
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
  std::vector<Mat3> inverse;  // Λ_k⁻¹
  std::vector<int> targets;   // the slots of (i, j) in the order of elimination, −1 if A has none
};
