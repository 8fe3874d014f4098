// SPDX-License-Identifier: GPL-3.0-or-later
// Surface engine: the mesh in an order in which neighbours in space are neighbours in memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "integral_invariant/mesh/surface.h"
#include "integral_invariant/support/execution.h"

namespace integral_invariant {

/// An edge that its triangles do not pass equally often in both directions: the surface ends there or turns over.
struct BoundaryEdge {
  std::uint32_t from, to;  ///< points, in the direction that is passed more often
  std::int32_t surplus;    ///< how many times more, at least 1
  std::uint32_t opposite;  ///< third point of a triangle that passes from→to
};

/// The referenced vertices along a Hilbert curve, those at the same place merged to one point; triangles sorted by
/// their first point along the curve. Merging closes meshes whose triangles share places but not vertices.
struct PreparedMesh {
  static constexpr std::size_t run = 8;  ///< of points and triangles that lie together
  std::vector<Vec3> points;
  std::vector<Vec3> normals;                ///< per point: unit, from area vectors; arbitrary where they cancel
  std::vector<std::uint32_t> vertex_start;  ///< the vertices at point i are vertices[vertex_start[i]] and on
  std::vector<std::uint32_t> vertices;
  std::vector<Triangle> triangles;           ///< three different points, oriented as in the surface
  std::vector<BoundaryEdge> boundary_edges;  ///< sorted by their smaller point
};

/// Cost O(n log n), about 100 bytes a vertex for the result. `merge_dense`: where more than a thousand vertices lie
/// within an average edge's length, those within 1/32 of it count as one.
PreparedMesh prepare_mesh(const Surface& surface, bool merge_dense, Execution& execution);

}  // namespace integral_invariant
