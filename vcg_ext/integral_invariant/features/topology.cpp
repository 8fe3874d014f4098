// SPDX-License-Identifier: GPL-3.0-or-later
// Adjacency of triangles. Cost: O(m log valence).
#include "integral_invariant/features/topology.h"

#include <algorithm>
#include <numeric>

namespace integral_invariant {

namespace {

struct Side {
  std::int32_t low, high, triangle, side;

  bool same_edge(const Side& other) const { return low == other.low && high == other.high; }
};

/// By their ends, and those of an edge by triangle: bucketed by the lower end, where only few are left to sort.
std::vector<Side> sorted_sides(const std::vector<Triangle>& triangles, std::size_t vertices)
{
  std::vector<std::size_t> next(vertices + 1, 0);
  for (const Triangle& t : triangles)
    for (std::size_t i = 0; i < 3; ++i) ++next[std::size_t(std::min(t[i], t[(i + 1) % 3])) + 1];
  std::partial_sum(next.begin(), next.end(), next.begin());
  std::vector<Side> sides(3 * triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::int32_t i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax(triangles[t][i], triangles[t][(i + 1) % 3]);
      sides[next[std::size_t(low)]++] = {low, high, std::int32_t(t), i};
    }
  std::size_t begin = 0;
  for (std::size_t v = 0; v < vertices; begin = next[v++])
    std::sort(sides.begin() + std::ptrdiff_t(begin), sides.begin() + std::ptrdiff_t(next[v]),
              [](const Side& a, const Side& b) {
                return std::array{a.high, a.triangle, a.side} < std::array{b.high, b.triangle, b.side};
              });
  return sides;
}

}  // namespace

Topology::Topology(const Surface& surface)
{
  const std::vector<Triangle>& triangles = surface.triangles();
  edge.resize(triangles.size());
  across.assign(triangles.size(), {-1, -1, -1});
  const std::vector<Side> sides = sorted_sides(triangles, surface.vertex_count());
  for (std::size_t begin = 0, end; begin < sides.size(); begin = end, ++edge_count) {
    for (end = begin; end < sides.size() && sides[end].same_edge(sides[begin]); ++end)
      edge[sides[end].triangle][sides[end].side] = std::int32_t(edge_count);
    if (end - begin != 2) continue;
    const Side &a = sides[begin], &b = sides[begin + 1];
    across[a.triangle][a.side] = b.triangle;
    across[b.triangle][b.side] = a.triangle;
  }

  around_start.assign(surface.vertex_count() + 1, 0);
  for (const Triangle& t : triangles)
    for (const std::int32_t v : t) ++around_start[v + 1];
  for (std::size_t v = 0; v < surface.vertex_count(); ++v) around_start[v + 1] += around_start[v];
  around.resize(3 * triangles.size());
  std::vector<std::uint32_t> next(around_start.begin(), around_start.end() - 1);
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (const std::int32_t v : triangles[t]) around[next[v]++] = std::uint32_t(t);
}

TriangleFrame::TriangleFrame(const Triangle& t, const std::vector<Vec3>& positions)
{
  const Vec3 area = cross(positions[t[1]] - positions[t[0]], positions[t[2]] - positions[t[0]]);
  doubled_area = norm(area);
  normal = normalized(area);
  const double squared = squared_norm(area);
  if (!(squared > 0)) return;
  for (int i = 0; i < 3; ++i)
    gradient[i] = cross(area, positions[t[(i + 2) % 3]] - positions[t[(i + 1) % 3]]) * (1 / squared);
}

std::vector<double> vertex_areas(const Surface& surface)
{
  std::vector<double> areas(surface.vertex_count(), 0);
  for (const Triangle& t : surface.triangles())
    for (const std::int32_t v : t) areas[v] += TriangleFrame(t, surface.positions()).doubled_area / 6;
  return areas;
}

}  // namespace integral_invariant
