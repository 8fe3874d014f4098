// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "integral_invariant/support/execution.h"
#include "integral_invariant/surface.h"

namespace integral_invariant {

/// A mesh in an order that its shape alone decides: the same mesh, with its vertices, its faces and the corners of its
/// faces in any other order, comes out as the same arrays, so what is computed from them is the same, bit by bit.
struct CanonicalMesh {
  TriangleMesh mesh;
  std::vector<std::uint32_t> caller;  ///< vertex i of `mesh` is the caller's vertex caller[i]
};

/// Vertices along a Hilbert curve through the box of the surface, within a cell of it by their coordinates; those that
/// no triangle of three different, finite vertices uses come last. Triangles begin with their smallest vertex, and are
/// sorted. Vertices at the same place, and those that no triangle uses, keep the order in which the caller has them:
/// nothing else tells them apart. Nothing is left out or merged. Cost: O(n log n + m), and 52 bytes a vertex. \throw
/// InputError where an index is out of range
CanonicalMesh in_canonical_order(const TriangleMesh& mesh, Execution& execution);
/// The same with one thread.
CanonicalMesh in_canonical_order(const TriangleMesh& mesh);

}  // namespace integral_invariant
