// SPDX-License-Identifier: GPL-3.0-or-later
// Before the first stage: a mesh in an order that its shape alone decides, with one vertex a place. In: the caller's
// mesh. Out: the same in another order, and the way back.
#include "integral_invariant/mesh/canonical_mesh.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "integral_invariant/mesh/coincident_border.h"
#include "integral_invariant/mesh/hilbert_sort.h"
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

HilbertCurve curve_through(const std::vector<Vec3>& positions, const std::vector<char>& used, const Axes& axes,
                           Execution& execution)
{
  Box box;
  for_each_in_order(positions.size(), execution, [&](std::size_t v) {
    if (used[v]) box.add(axes.coordinates_of(positions[v]));
  });
  const Vec3 extent = box.high - box.low;
  return {axes.vector(box.low + extent * 0.5), 0.5 * norm(extent), axes};
}

/// Numbers the caller's vertices in canonical order; those at the same place, which follow each other, are one.
void number_vertices(const TriangleMesh& mesh, const Axes& axes, CanonicalMesh& canonical, Execution& execution)
{
  const std::vector<char> used = used_vertices(mesh, execution);
  const std::vector<CurveCell> places = hilbert_sort(
      curve_through(mesh.positions, used, axes, execution), mesh.positions, [&](std::size_t v) { return used[v] != 0; },
      execution);
  reserve_large(canonical.original_index, mesh.positions.size());
  reserve_large(canonical.mesh.positions, mesh.positions.size());
  resize_in_steps(canonical.vertex_of, mesh.positions.size(), execution);
  const auto add = [&](std::uint32_t v) {
    canonical.vertex_of[v] = std::uint32_t(canonical.original_index.size());
    canonical.original_index.push_back(v);
    canonical.mesh.positions.push_back(mesh.positions[v]);
  };
  for_each_in_order(places.size(), execution, [&](std::size_t i) {
    const std::uint32_t v = places[i].vertex;
    if (i > 0 && mesh.positions[v] == canonical.mesh.positions.back())
      canonical.vertex_of[v] = canonical.vertex_of[places[i - 1].vertex];
    else
      add(v);
  });
  for_each_in_order(mesh.positions.size(), execution, [&](std::size_t v) {
    if (!used[v]) add(std::uint32_t(v));
  });
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

/// Sorted, each from its smallest vertex on, in the numbers that `number` gives the vertices, of which there are
/// `vertices`; those whose corners fall together only in these numbers are left out.
std::vector<Triangle> ordered_triangles(const std::vector<Triangle>& triangles,
                                        const std::vector<std::uint32_t>& number, std::size_t vertices,
                                        Execution& execution)
{
  const auto corners_apart = [](const Triangle& t) { return t[0] != t[1] && t[1] != t[2] && t[2] != t[0]; };
  // By the first vertex, then each vertex's few; equal ones are repetitions, which nothing tells apart.
  Buckets<Triangle> buckets =
      in_buckets<Triangle>(triangles.size(), vertices, execution, [&](std::size_t i, const auto& put) {
        const Triangle& t = triangles[i];
        const Triangle renumbered =
            smallest_first({std::int32_t(number[std::size_t(t[0])]), std::int32_t(number[std::size_t(t[1])]),
                            std::int32_t(number[std::size_t(t[2])])});
        if (corners_apart(renumbered) || !corners_apart(t)) put(std::size_t(renumbered[0]), renumbered);
      });
  for_each_index(vertices, execution,
                 [&](std::size_t v) { std::sort(buckets.begin(v), buckets.end(v), precedes_turned); });
  return std::move(buckets.items);
}

/// Makes vertex v one with first[v], which is v itself or a smaller number.
void join_vertices(const std::vector<std::uint32_t>& first, CanonicalMesh& canonical, Execution& execution)
{
  std::vector<std::uint32_t> number(first.size());
  std::size_t count = 0;
  for_each_in_order(first.size(), execution, [&](std::size_t v) {
    number[v] = first[v] == v ? std::uint32_t(count) : number[first[v]];
    if (first[v] != v) return;
    canonical.original_index[count] = canonical.original_index[v];
    canonical.mesh.positions[count++] = canonical.mesh.positions[v];
  });
  canonical.original_index.resize(count);
  canonical.mesh.positions.resize(count);
  for (std::uint32_t& v : canonical.vertex_of) v = number[v];
  canonical.mesh.triangles = ordered_triangles(canonical.mesh.triangles, number, count, execution);
}

}  // namespace

CanonicalMesh make_canonical_mesh(const TriangleMesh& mesh)
{
  Execution execution(1);
  return make_canonical_mesh(mesh, execution);
}

CanonicalMesh make_canonical_mesh(const TriangleMesh& mesh, Execution& execution, const Axes& axes)
{
  require_valid_indices(mesh);
  CanonicalMesh canonical;
  number_vertices(mesh, axes, canonical, execution);
  canonical.mesh.triangles =
      ordered_triangles(mesh.triangles, canonical.vertex_of, canonical.original_index.size(), execution);
  const std::vector<std::uint32_t> first = coincident_border(canonical.mesh, execution);
  if (!first.empty()) join_vertices(first, canonical, execution);
  if (canonical.mesh.triangles.empty() && !mesh.triangles.empty()) refuse_without_area();
  canonical.collapsed_triangles = mesh.triangles.size() - canonical.mesh.triangles.size();
  return canonical;
}

void CanonicalMesh::complete(SurfaceReport& report) const
{
  report.vertices += joined_vertices();
  report.joined_vertices += joined_vertices();
  report.triangles += collapsed_triangles;
  report.zero_area_triangles += collapsed_triangles;
}

}  // namespace integral_invariant
