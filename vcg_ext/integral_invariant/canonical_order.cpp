// SPDX-License-Identifier: GPL-3.0-or-later
// Before the first stage: a mesh in an order that its shape alone decides. In: the caller's mesh. Out: the same in
// another order, and the way back.
#include "integral_invariant/canonical_order.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

#include "integral_invariant/support/hilbert_curve.h"

namespace integral_invariant {

namespace {

/// Whether a triangle that can bound the solid uses the vertex.
std::vector<char> used_vertices(const TriangleMesh& mesh)
{
  std::vector<char> used(mesh.positions.size(), 0);
  for (const Triangle& t : mesh.triangles)
    if (is_proper(t, mesh.positions))
      for (const std::int32_t v : t) used[std::size_t(v)] = 1;
  return used;
}

HilbertCurve curve_through(const std::vector<Vec3>& positions, const std::vector<char>& used)
{
  Box box;
  for (std::size_t v = 0; v < positions.size(); ++v)
    if (used[v]) box.add(positions[v]);
  const Vec3 extent = box.high - box.low;
  return {box.low + extent * 0.5, 0.5 * norm(extent)};
}

struct Key {
  std::uint64_t index;
  std::uint32_t vertex;
};

/// The caller's vertices in canonical order.
std::vector<std::uint32_t> vertex_order(const TriangleMesh& mesh, Execution& execution)
{
  const std::vector<char> used = used_vertices(mesh);
  const std::vector<std::uint64_t> along = curve_through(mesh.positions, used).indices(mesh.positions, execution);
  std::vector<Key> keys;
  keys.reserve(mesh.positions.size());
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    if (used[v]) keys.push_back({along[v], std::uint32_t(v)});
  std::sort(keys.begin(), keys.end(), [&](const Key& a, const Key& b) {
    return a.index != b.index ? a.index < b.index : precedes(a.vertex, b.vertex, mesh.positions);
  });
  std::vector<std::uint32_t> order;
  order.reserve(mesh.positions.size());
  for (const Key& key : keys) order.push_back(key.vertex);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    if (!used[v]) order.push_back(std::uint32_t(v));
  return order;
}

/// Of triangles with the same first vertex, which comes first; the same for both when they are turned over, so that a
/// mesh that is inside out has the order of its right side.
bool precedes_turned(const Triangle& a, const Triangle& b)
{
  const std::int32_t low_a = std::min(a[1], a[2]), low_b = std::min(b[1], b[2]);
  if (low_a != low_b) return low_a < low_b;
  const std::int32_t high_a = std::max(a[1], a[2]), high_b = std::max(b[1], b[2]);
  return high_a != high_b ? high_a < high_b : a[1] < b[1];
}

/// Sorted, each from its smallest vertex on, in the numbers that `place` gives the vertices.
std::vector<Triangle> ordered_triangles(const TriangleMesh& mesh, const std::vector<std::uint32_t>& place,
                                        Execution& execution)
{
  const auto renumbered = [&](const Triangle& t) {
    return smallest_first({std::int32_t(place[std::size_t(t[0])]), std::int32_t(place[std::size_t(t[1])]),
                           std::int32_t(place[std::size_t(t[2])])});
  };
  // By the first vertex in two passes, then each vertex's few; equal ones are repetitions, which nothing tells apart.
  std::vector<std::uint32_t> start(mesh.positions.size() + 1, 0);
  for (const Triangle& t : mesh.triangles) ++start[std::size_t(renumbered(t)[0]) + 1];
  std::partial_sum(start.begin(), start.end(), start.begin());
  std::vector<Triangle> triangles(mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) {
    const Triangle r = renumbered(t);
    triangles[start[std::size_t(r[0])]++] = r;
  }
  for_each_index(mesh.positions.size(), execution, [&](std::size_t v) {
    std::sort(triangles.begin() + std::ptrdiff_t(v == 0 ? 0 : start[v - 1]),
              triangles.begin() + std::ptrdiff_t(start[v]), precedes_turned);
  });
  return triangles;
}

}  // namespace

CanonicalMesh in_canonical_order(const TriangleMesh& mesh)
{
  Execution execution(1);
  return in_canonical_order(mesh, execution);
}

CanonicalMesh in_canonical_order(const TriangleMesh& mesh, Execution& execution)
{
  require_valid_indices(mesh);
  CanonicalMesh canonical;
  canonical.caller = vertex_order(mesh, execution);
  canonical.mesh.positions.reserve(mesh.positions.size());
  std::vector<std::uint32_t> place(mesh.positions.size());
  for (const std::uint32_t v : canonical.caller) {
    place[v] = std::uint32_t(canonical.mesh.positions.size());
    canonical.mesh.positions.push_back(mesh.positions[v]);
  }
  canonical.mesh.triangles = ordered_triangles(mesh, place, execution);
  return canonical;
}

}  // namespace integral_invariant
