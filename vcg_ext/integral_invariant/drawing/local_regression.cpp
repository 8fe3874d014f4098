// SPDX-License-Identifier: GPL-3.0-or-later
// Neighbourhoods along edges, and the error of fits to correlated values. Cost: O(neighbours) a vertex.
#include "integral_invariant/drawing/local_regression.h"

#include <algorithm>
#include <cmath>

namespace integral_invariant {

NeighbourhoodWalk::NeighbourhoodWalk(const Surface& surface, const std::vector<Vec3>& normals)
    : surface_(surface), normals_(normals), mark_(surface.vertex_count(), -1)
{
}

const std::vector<std::int32_t>& NeighbourhoodWalk::around(std::int32_t vertex, double distance)
{
  constexpr double least_cosine = 0.5;  // beyond 60 degrees the surface is no graph over the tangent plane
  const auto &start = surface_.neighbour_start(), &neighbours = surface_.neighbours();
  const std::vector<Vec3>& p = surface_.positions();
  found_.assign(1, vertex);
  mark_[vertex] = vertex;
  for (std::size_t i = 0; i < found_.size(); ++i)
    for (std::uint32_t e = start[found_[i]]; e < start[found_[i] + 1]; ++e) {
      const std::int32_t q = std::int32_t(neighbours[e]);
      if (mark_[q] == vertex) continue;
      mark_[q] = vertex;
      if (squared_norm(p[q] - p[vertex]) < distance * distance && dot(normals_[q], normals_[vertex]) > least_cosine)
        found_.push_back(q);
    }
  return found_;
}

FitError fit_error(int degree, double correlation, const FitVariance& variance)
{
  if (!(variance.slope > 0)) return {1, 0};
  const double l2 = correlation * correlation, r2 = 1 / variance.slope, b = l2 + 2 * r2;
  const double value = degree == 1 ? l2 / b : l2 * (1 / b + 2 * r2 / (b * b) + 2 * r2 * r2 / (b * b * b));
  const double excess = std::max(1.0, variance.value / degree);
  return {std::sqrt(value * excess), std::sqrt(l2 / (b * b))};
}

}  // namespace integral_invariant
