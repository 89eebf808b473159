// The springs of [spring].
#pragma once
#include <vector>

#include "math/spring.h"
#include "scene/mesh.h"

// On a grid: k along the edges of the cells, shear along one or both diagonals, apart between vertices that are
// two cells apart. On a mesh: k along every edge, apart between the vertices opposite an interior edge. A spring
// on the boundary stands for half as much cloth, and has half the stiffness. Sorted by vertices; no spring is
// there twice.
std::vector<Spring> make_spring_net(const Mesh&, const SpringTerm&);
