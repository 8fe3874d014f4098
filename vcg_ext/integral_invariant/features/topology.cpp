// SPDX-License-Identifier: GPL-3.0-or-later
// Adjacency of triangles. Cost: O(m log valence).
#include "integral_invariant/features/topology.h"

#include <algorithm>

namespace integral_invariant {

namespace {

struct Side {
  std::int32_t low, high, triangle, side;
};

}  // namespace

Topology::Topology(const Surface& surface, Execution& execution)
{
  const std::vector<Triangle>& triangles = surface.triangles();
  resize_in_steps(edge, triangles.size(), execution);
  across.assign(triangles.size(), {-1, -1, -1});
  // By the lower end, where only few are left to sort.
  Buckets<Side> sides =
      in_buckets<Side>(triangles.size(), surface.vertex_count(), execution, [&](std::size_t t, const auto& put) {
        for (std::int32_t i = 0; i < 3; ++i) {
          const auto [low, high] = std::minmax(triangles[t][i], triangles[t][(i + 1) % 3]);
          put(std::size_t(low), Side{low, high, std::int32_t(t), i});
        }
      });
  for_each_index(sides.count(), execution, [&](std::size_t v) {
    std::sort(sides.begin(v), sides.end(v), [](const Side& a, const Side& b) {
      return std::array{a.high, a.triangle, a.side} < std::array{b.high, b.triangle, b.side};
    });
  });
  for_each_in_order(sides.count(), execution, [&](std::size_t v) {
    for (const Side *side = sides.begin(v), *last = sides.end(v), *end; side != last; side = end, ++edge_count) {
      for (end = side; end != last && end->high == side->high; ++end)
        edge[end->triangle][end->side] = std::int32_t(edge_count);
      if (end - side != 2) continue;
      const Side &a = side[0], &b = side[1];
      across[a.triangle][a.side] = b.triangle;
      across[b.triangle][b.side] = a.triangle;
    }
  });

  around = in_buckets<std::uint32_t>(triangles.size(), surface.vertex_count(), execution,
                                     [&](std::size_t t, const auto& put) {
                                       for (const std::int32_t v : triangles[t]) put(std::size_t(v), std::uint32_t(t));
                                     });
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

std::vector<double> vertex_areas(const Surface& surface, Execution& execution)
{
  const std::vector<Vec3>& p = surface.positions();
  std::vector<double> areas(surface.vertex_count(), 0);
  for_each_in_order(surface.triangles().size(), execution, [&](std::size_t i) {
    const Triangle& t = surface.triangles()[i];
    const double share = norm(cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]])) / 6;
    for (const std::int32_t v : t) areas[v] += share;
  });
  return areas;
}

}  // namespace integral_invariant
