#include "math/parents.h"

#include <algorithm>

namespace {

using Neighbours = std::vector<std::vector<int>>;

Neighbours neighbours_in(const BlockMatrix& pattern) {
  Neighbours of(size_t(pattern.rows()));
  for (int i = 0; i < pattern.rows(); ++i)
    for (int s = pattern.row_start[i]; s < pattern.row_start[i + 1]; ++s) {
      of[i].push_back(pattern.column[s]);
      of[pattern.column[s]].push_back(i);
    }
  return of;
}

constexpr int in_none = -1;

// Every vertex that no aggregate touches begins one with all its neighbours.
std::vector<int> disjoint_stars(const Neighbours& neighbours) {
  std::vector<int> aggregate(neighbours.size(), in_none);
  int count = 0;
  for (size_t i = 0; i < neighbours.size(); ++i) {
    const auto is_open = [&](int j) { return aggregate[j] == in_none; };
    const bool alone = neighbours[i].empty();
    if (alone || !is_open(int(i)) || !std::ranges::all_of(neighbours[i], is_open)) continue;
    aggregate[i] = count;
    for (const int j : neighbours[i]) aggregate[j] = count;
    ++count;
  }
  return aggregate;
}

// How many of the vertices belong to each aggregate, by its number.
std::vector<std::array<int, 2>> shares(const std::vector<int>& vertices,
                                       const std::vector<int>& aggregate) {
  std::vector<int> numbers;
  for (const int i : vertices)
    if (aggregate[i] != in_none) numbers.push_back(aggregate[i]);
  std::ranges::sort(numbers);
  std::vector<std::array<int, 2>> result;
  for (const int number : numbers) {
    if (result.empty() || result.back()[0] != number) result.push_back({number, 0});
    ++result.back()[1];
  }
  return result;
}

// The vertices between the stars join the star with the most of their neighbours.
std::vector<int> aggregates(const Neighbours& neighbours) {
  const std::vector<int> stars = disjoint_stars(neighbours);
  std::vector<int> all = stars;
  for (size_t i = 0; i < stars.size(); ++i) {
    if (stars[i] != in_none || neighbours[i].empty()) continue;
    all[i] = std::ranges::max(shares(neighbours[i], stars), {},
                              [](const auto& share) { return share[1]; })[0];
  }
  return all;
}

}  // namespace

Parents coarse_parents(const Grid& fine) {
  const Grid coarse = fine.half();
  Parents parents;
  for (int j = 0; j <= fine.cells[1]; ++j)
    for (int i = 0; i <= fine.cells[0]; ++i) {
      const int I = i / 2, J = j / 2, right = i % 2, up = j % 2;
      const auto parent = [&](int di, int dj, double weight) {
        return Parent{coarse.vertex(I + di, J + dj), weight};
      };
      if (!right && !up)
        parents.push_back({parent(0, 0, 1)});
      else if (!(right && up))
        parents.push_back({parent(0, 0, 0.5), parent(right, up, 0.5)});
      else if (fine.diagonals == Diagonals::same)
        parents.push_back({parent(1, 0, 0.5), parent(0, 1, 0.5)});
      else
        parents.push_back(
            {parent(0, 0, 0.25), parent(1, 0, 0.25), parent(0, 1, 0.25), parent(1, 1, 0.25)});
    }
  return parents;
}

Parents aggregate_parents(const BlockMatrix& pattern) {
  Neighbours around = neighbours_in(pattern);
  const std::vector<int> aggregate = aggregates(around);
  Parents parents(around.size());
  for (size_t i = 0; i < around.size(); ++i) {
    around[i].push_back(int(i));
    for (const auto& [number, share] : shares(around[i], aggregate))
      parents[i].push_back({number, share / double(around[i].size())});
  }
  return parents;
}

int coarse_vertices(const Parents& parents) {
  int last = -1;
  for (const auto& of_vertex : parents)
    for (const Parent& parent : of_vertex) last = std::max(last, parent.vertex);
  return last + 1;
}
