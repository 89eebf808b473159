// The elements of the models of [bend]: one at every edge that two triangles share.
#pragma once
#include <span>

#include "math/hinge.h"
#include "math/quadratic_bend.h"
#include "math/spring.h"
#include "scene/mesh.h"

// A hinge rests flat if both of its faces do, and otherwise at the angle that it has in the mesh.
// Quadratic hinges and springs always rest flat.
std::vector<Hinge> make_hinges(const Mesh&);
std::vector<QuadraticHinge> make_quadratic_hinges(const Mesh&);
std::vector<Spring> make_bend_springs(const Mesh&);

// Sets the rest angles to the angles at x.
void rest_at(const VecX& x, std::span<Hinge>);
