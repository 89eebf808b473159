// Meshes that are no grids: a disc with vertices at random places, and any mesh with smaller triangles.
#pragma once
#include <map>

#include "scene/mesh.h"
#include "support/poses.h"

// A disc of radius 1/2 m in the plane y = 0, of 6 rings² triangles. Ring r has 6 r vertices, at random near
// even distances. Between two rings each triangle takes the vertex that comes next around, on either ring.
inline Mesh random_disc(int rings, unsigned seed) {
  Random random(seed);
  Mesh mesh;
  std::vector<Vec2> uv = {Vec2(0, 0)};
  struct Ring {
    int first;
    std::vector<double> angles;  // rising, less than one turn apart
    int vertex(size_t i) const { return first + int(i % angles.size()); }
    double angle(size_t i) const {
      return angles[i % angles.size()] + 2 * pi * double(i / angles.size());
    }
  };
  Ring inner{0, {0}};
  for (int r = 1; r <= rings; ++r) {
    Ring ring{int(uv.size()), {}};
    const double turn = random.between(0, 1);
    for (int i = 0; i < 6 * r; ++i) {
      ring.angles.push_back(2 * pi * (i + turn + random.between(-0.25, 0.25)) / (6 * r));
      const double radius = (r + (r < rings ? random.between(-0.2, 0.2) : 0)) / (2 * rings);
      uv.push_back(radius * Vec2(std::cos(ring.angles.back()), std::sin(ring.angles.back())));
    }
    const size_t within = r == 1 ? 0 : inner.angles.size(), around = ring.angles.size();
    for (size_t i = 0, j = 0; i < within || j < around;)
      if (j == around || (i < within && inner.angle(i + 1) < ring.angle(j + 1))) {
        mesh.faces.push_back({inner.vertex(i), ring.vertex(j), inner.vertex(i + 1)});
        ++i;
      } else {
        mesh.faces.push_back({inner.vertex(i), ring.vertex(j), ring.vertex(j + 1)});
        ++j;
      }
    inner = ring;
  }
  mesh.x.resize(3 * Eigen::Index(uv.size()));
  for (size_t i = 0; i < uv.size(); ++i)
    mesh.x.segment<3>(3 * Eigen::Index(i)) = Vec3(uv[i].x(), 0, -uv[i].y());
  for (const Face& f : mesh.faces)
    mesh.rest.push_back({uv[size_t(f[0])], uv[size_t(f[1])], uv[size_t(f[2])]});
  return mesh;
}

// Every triangle in four, by the middles of its edges.
inline Mesh refined(const Mesh& coarse) {
  Mesh fine{.faces = {}, .rest = {}, .x = coarse.x};
  std::vector<Vec3> middles;
  std::map<std::array<int, 2>, int> middle_of;
  const auto middle = [&](int a, int b) {
    const auto [place, is_new] = middle_of.try_emplace({std::min(a, b), std::max(a, b)},
                                                       coarse.vertices() + int(middles.size()));
    if (is_new) middles.push_back((coarse.x.segment<3>(3 * a) + coarse.x.segment<3>(3 * b)) / 2);
    return place->second;
  };
  for (size_t f = 0; f < coarse.faces.size(); ++f) {
    const auto [a, b, c] = coarse.faces[f];
    const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    const auto [u, v, w] = coarse.rest[f];
    const Vec2 uv = (u + v) / 2, vw = (v + w) / 2, wu = (w + u) / 2;
    fine.faces.insert(fine.faces.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    fine.rest.insert(fine.rest.end(), {{u, uv, wu}, {uv, v, vw}, {wu, vw, w}, {uv, vw, wu}});
    if (!coarse.in_space.empty()) fine.in_space.insert(fine.in_space.end(), 4, coarse.in_space[f]);
  }
  fine.x.conservativeResize(3 * (coarse.vertices() + Eigen::Index(middles.size())));
  for (size_t i = 0; i < middles.size(); ++i)
    fine.x.segment<3>(3 * (coarse.vertices() + Eigen::Index(i))) = middles[i];
  return fine;
}
