// What bends where two triangles share an edge: the elements of the models of [bend].
#pragma once
#include <span>

#include "math/hinge.h"
#include "math/quadratic_bend.h"
#include "math/spring.h"
#include "scene/mesh.h"

// A hinge rests flat where both of its faces do, and else as it lies in the mesh; quadratic ones and
// springs always rest flat.
std::vector<Hinge> make_hinges(const Mesh&);
std::vector<QuadraticHinge> make_quadratic_hinges(const Mesh&);
std::vector<Spring> make_bend_springs(const Mesh&);

// The angles at rest are those at x.
void rest_at(const VecX& x, std::span<Hinge>);
