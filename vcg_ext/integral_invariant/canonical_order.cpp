// SPDX-License-Identifier: GPL-3.0-or-later
// Before the first stage: a mesh in an order that its shape alone decides. In: the caller's mesh. Out: the same in
// another order, and the way back.
#include "integral_invariant/canonical_order.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "integral_invariant/curve_order.h"
#include "integral_invariant/support/buckets.h"
#include "integral_invariant/support/large_pages.h"

namespace integral_invariant {

namespace {

/// Whether a triangle that can bound the solid uses the vertex.
std::vector<char> used_vertices(const TriangleMesh& mesh, Execution& execution)
{
  std::vector<char> used(mesh.positions.size(), 0);
  for_each_in_order(mesh.triangles.size(), execution, [&](std::size_t i) {
    const Triangle& t = mesh.triangles[i];
    if (is_proper(t, mesh.positions))
      for (const std::int32_t v : t) used[std::size_t(v)] = 1;
  });
  return used;
}

HilbertCurve curve_through(const std::vector<Vec3>& positions, const std::vector<char>& used, Execution& execution)
{
  Box box;
  for_each_in_order(positions.size(), execution, [&](std::size_t v) {
    if (used[v]) box.add(positions[v]);
  });
  const Vec3 extent = box.high - box.low;
  return {box.low + extent * 0.5, 0.5 * norm(extent)};
}

/// The caller's vertices in canonical order.
std::vector<std::uint32_t> vertex_order(const TriangleMesh& mesh, Execution& execution)
{
  const std::vector<char> used = used_vertices(mesh, execution);
  const std::vector<CurvePlace> places = order_along(
      curve_through(mesh.positions, used, execution), mesh.positions, [&](std::size_t v) { return used[v] != 0; },
      execution);
  std::vector<std::uint32_t> order;
  reserve_large(order, mesh.positions.size());
  for_each_in_order(places.size(), execution, [&](std::size_t i) { order.push_back(places[i].vertex); });
  for_each_in_order(mesh.positions.size(), execution, [&](std::size_t v) {
    if (!used[v]) order.push_back(std::uint32_t(v));
  });
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
  // By the first vertex, then each vertex's few; equal ones are repetitions, which nothing tells apart.
  Buckets<Triangle> buckets =
      in_buckets<Triangle>(mesh.triangles.size(), place.size(), execution, [&](std::size_t i, const auto& put) {
        const Triangle& t = mesh.triangles[i];
        const Triangle renumbered =
            smallest_first({std::int32_t(place[std::size_t(t[0])]), std::int32_t(place[std::size_t(t[1])]),
                            std::int32_t(place[std::size_t(t[2])])});
        put(std::size_t(renumbered[0]), renumbered);
      });
  for_each_index(place.size(), execution,
                 [&](std::size_t v) { std::sort(buckets.begin(v), buckets.end(v), precedes_turned); });
  return std::move(buckets.items);
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
  reserve_large(canonical.mesh.positions, mesh.positions.size());
  std::vector<std::uint32_t> place;
  resize_in_steps(place, mesh.positions.size(), execution);
  for_each_in_order(canonical.caller.size(), execution, [&](std::size_t i) {
    place[canonical.caller[i]] = std::uint32_t(i);
    canonical.mesh.positions.push_back(mesh.positions[canonical.caller[i]]);
  });
  canonical.mesh.triangles = ordered_triangles(mesh, place, execution);
  return canonical;
}

}  // namespace integral_invariant
