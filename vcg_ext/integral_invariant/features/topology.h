// SPDX-License-Identifier: GPL-3.0-or-later
// Features: which triangle lies across an edge, and the gradient of linear functions on a triangle.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "integral_invariant/mesh/surface.h"
#include "integral_invariant/support/buckets.h"

namespace integral_invariant {

/// Adjacency of the triangles of a surface. Side i of a triangle runs from its vertex i to the next; vertex i + 2 faces
/// it.
struct Topology {
  /// Cost O(m log valence). \throw Cancelled
  Topology(const Surface& surface, Execution& execution);

  std::vector<std::array<std::int32_t, 3>> edge;  ///< index of each side's edge, below edge_count
  std::vector<std::array<std::int32_t, 3>>
      across;  ///< triangle on the other side; -1 at a boundary or where three meet
  std::size_t edge_count = 0;

  Buckets<std::uint32_t> around;  ///< triangles of each vertex, increasing
};

/// A triangle's doubled area and the gradients of its three barycentric weights; zeros where it has no area.
struct TriangleFrame {
  TriangleFrame(const Triangle& t, const std::vector<Vec3>& positions);

  Vec3 normal;  ///< unit
  double doubled_area = 0;
  std::array<Vec3, 3> gradient;

  /// Gradient of the linear function with these values at the vertices.
  Vec3 gradient_of(double a, double b, double c) const { return gradient[0] * a + gradient[1] * b + gradient[2] * c; }
  /// The part of `v` in the plane of the triangle.
  Vec3 tangential(const Vec3& v) const { return v - normal * dot(normal, v); }
};

/// A third of the area of its triangles for each vertex, in normalised units.
std::vector<double> vertex_areas(const Surface& surface, Execution& execution);

}  // namespace integral_invariant
