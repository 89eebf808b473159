// The coarser levels of a multigrid (math/multigrid.h): which coarse vertices a fine one interpolates from.
#pragma once
#include "math/block_matrix.h"
#include "math/grid.h"

// A coarse vertex that a fine one interpolates from; the weights of its parents add up to one.
struct Parent {
  int vertex;
  double weight;
};
using Parents = std::vector<std::vector<Parent>>;  // of every fine vertex

// In the grid of half as many cells: a vertex itself, the two ends of the coarse edge that it halves, or
// in the middle of a coarse cell without a diagonal its four corners.
Parents coarse_parents(const Grid& fine);

// On any mesh: smoothed aggregation (Tamstorf, Jones & McCormick 2015), from the pattern alone. Aggregates of
// neighbours are the coarse vertices. T, 1 where a vertex belongs to an aggregate, moves aggregates as
// stiff pieces; Q is smooth. A vertex i with d neighbours gives an aggregate the weight of its share of
// i and its neighbours:
//
//   Q = (I − ω D⁻¹ L) T,   L = D − N,   ω = d / (d + 1)   N_ij = 1 for neighbours, D = the numbers d
//
// A vertex without neighbours has no parents: block Gauss–Seidel solves its equations exactly.
Parents aggregate_parents(const BlockMatrix& pattern);

// The number of coarse vertices.
int coarse_vertices(const Parents&);
