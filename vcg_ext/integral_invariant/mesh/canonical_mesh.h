// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "integral_invariant/mesh/surface.h"
#include "integral_invariant/support/axes.h"
#include "integral_invariant/support/execution.h"

namespace integral_invariant {

/// A mesh in an order that its shape alone decides: the same mesh, with its vertices, its faces and the corners of its
/// faces in any other order, comes out as the same arrays, so what is computed from them is the same, bit by bit.
/// Vertices at one place are one vertex, however many copies of it the caller has.
struct CanonicalMesh {
  TriangleMesh mesh;
  std::vector<std::uint32_t>
      original_index;  ///< vertex i of `mesh` is the caller's vertex original_index[i], the first of its copies
  std::vector<std::uint32_t> vertex_of;  ///< the caller's vertex v is vertex vertex_of[v] of `mesh`
  std::size_t collapsed_triangles = 0;   ///< two of their corners are one vertex now: left out of `mesh`

  /// Vertices of the caller that are copies of another one.
  std::size_t joined_vertices() const { return vertex_of.size() - original_index.size(); }
  /// Counts what joining took away; `report` is about `mesh`, and then about the caller's.
  void complete(SurfaceReport& report) const;
  /// One value a vertex of `mesh`, as the caller has them.
  template <class Value>
  std::vector<Value> for_caller(const std::vector<Value>& values) const
  {
    std::vector<Value> result;
    result.reserve(vertex_of.size());
    for (const std::uint32_t v : vertex_of) result.push_back(values[v]);
    return result;
  }
  /// `values` has one entry a vertex of the caller, of which those of original_index[i] are set: gives them to the
  /// copies.
  template <class Value>
  void give_to_copies(std::vector<Value>& values) const
  {
    if (joined_vertices() == 0) return;
    for (std::size_t v = 0; v < vertex_of.size(); ++v) values[v] = values[original_index[vertex_of[v]]];
  }
};

/// Vertices along a Hilbert curve through the box of the surface along the given axes, within a cell of it by their
/// coordinates; those that
/// no triangle of three different, finite vertices uses come last, in the order in which the caller has them. Those
/// that triangles use are joined where they are at the same place, and along open edges where they are as near as the
/// mesh's own precision can tell (see coincident_border()). Triangles begin with their smallest vertex, and are sorted.
/// Cost: O(n log n + m), and 56 bytes a vertex. \throw InputError where an index is out of range
CanonicalMesh make_canonical_mesh(const TriangleMesh& mesh, Execution& execution, const Axes& axes = {});
/// The same with one thread.
CanonicalMesh make_canonical_mesh(const TriangleMesh& mesh);

}  // namespace integral_invariant
