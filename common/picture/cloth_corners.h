// Turns the vertices of a cloth into the numbers that OpenGL draws.
#pragma once
#include <array>
#include <vector>

#include "math/types.h"

// x in the units and the origin of the picture. Coordinates beyond 1e4 are cut off there, so that
// their squares stay finite.
VecX staged(const VecX& x, const Vec3& origin, double size);

// Per vertex, the mean of the normals of its faces, weighted by area: 2 area n = e1 × e2.
VecX smooth_normals(const std::vector<Face>& faces, const VecX& x);

inline constexpr int floats_per_corner = 9;  // position 3, normal 3, texture 2, strain 1

// One block of floats per face corner. strain may be empty.
std::vector<float> corner_floats(const std::vector<Face>& faces,
                                 const std::vector<std::array<Vec2, 3>>& squares, const VecX& x,
                                 const VecX& strain);
