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

// The blocks of every element, family by family.
struct ClothSlots {
  ClothSlots(const Cloth& cloth, const BlockMatrix& pattern)
      : triangles(find_slots(cloth.triangles, pattern)),
        springs(find_slots(cloth.springs, pattern)), hinges(find_slots(cloth.hinges, pattern)),
        quadratic_hinges(find_slots(cloth.quadratic_hinges, pattern)) {}

  std::vector<Slots<3>> triangles;
  std::vector<Slots<2>> springs;
  std::vector<Slots<4>> hinges, quadratic_hinges;
};
