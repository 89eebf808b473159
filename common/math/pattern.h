// Where the elements of a cloth lie in its matrices: found once, before the first step.
#pragma once
#include "math/block_matrix.h"
#include "math/cloth.h"

// A zero matrix with a block for every two vertices that share an element.
inline BlockMatrix make_block_matrix(const Cloth& cloth) {
  std::vector<std::array<int, 2>> pairs;
  for_each_family(cloth, [&](const auto& family) { add_pairs(family, pairs); });
  return make_block_matrix(cloth.vertices(), std::move(pairs));
}

// The blocks of every element, found by the family that it belongs to.
template <class Family>
struct FamilySlots {
  std::vector<Slots<Family::N>> slots;
};

struct ClothSlots : FamilySlots<Triangles>,
                    FamilySlots<Springs>,
                    FamilySlots<Hinges>,
                    FamilySlots<QuadraticHinges>,
                    FamilySlots<BendSprings> {
  ClothSlots(const Cloth& cloth, const BlockMatrix& pattern) {
    for_each_family(cloth, [&](const auto& family) { of(family) = find_slots(family, pattern); });
  }

  template <class Family>
  std::vector<Slots<Family::N>>& of(const Family&) {
    return FamilySlots<Family>::slots;
  }

  size_t bytes() const {
    return (bytes_of<Triangles>() + bytes_of<Springs>() + bytes_of<Hinges>() +
            bytes_of<QuadraticHinges>() + bytes_of<BendSprings>());
  }

 private:
  template <class Family>
  size_t bytes_of() const {
    return sizeof(Slots<Family::N>) * FamilySlots<Family>::slots.size();
  }
};
