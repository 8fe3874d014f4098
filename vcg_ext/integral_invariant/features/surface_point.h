// SPDX-License-Identifier: GPL-3.0-or-later
// Features: places on the surface between the vertices. They hold indices and weights, not coordinates, so that they
// serve the caller's mesh and the normalised one alike, and carry any quantity of the vertices.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "integral_invariant/mesh/surface.h"
#include "integral_invariant/vec3.h"

namespace integral_invariant {

/// The weighted mean of three vertices; weights are not negative and sum to 1.
struct SurfacePoint {
  Triangle vertices{};
  std::array<double, 3> weights{1, 0, 0};
};

/// The point of the edge from `a` to `b` at the fraction `t`.
inline SurfacePoint edge_point(std::int32_t a, std::int32_t b, double t) { return {{a, b, a}, {1 - t, t, 0}}; }

/// A quantity of the vertices (numbers or vectors) at the point.
template <class Value>
Value interpolate(const std::vector<Value>& values, const SurfacePoint& p)
{
  return values[p.vertices[0]] * p.weights[0] + values[p.vertices[1]] * p.weights[1] +
         values[p.vertices[2]] * p.weights[2];
}

/// Length of the polyline, in the unit of `positions`; `closed` adds the way back to its first point.
inline double polyline_length(const std::vector<SurfacePoint>& points, bool closed, const std::vector<Vec3>& positions)
{
  double length = 0;
  for (std::size_t i = 1; i < points.size(); ++i)
    length += norm(interpolate(positions, points[i]) - interpolate(positions, points[i - 1]));
  if (closed && points.size() > 1)
    length += norm(interpolate(positions, points.front()) - interpolate(positions, points.back()));
  return length;
}

}  // namespace integral_invariant
