// SPDX-License-Identifier: GPL-3.0-or-later
// Before the first stage: seams whose sides are off each other by rounding. In: a mesh with one vertex a place. Out:
// which vertices are meant to be one. Cost: that of the list of edges, and O(1) a vertex on an open edge.
#include "integral_invariant/mesh/coincident_border.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <unordered_map>

#include "integral_invariant/mesh/coordinate_step.h"
#include "integral_invariant/mesh/edges.h"

namespace integral_invariant {

namespace {

/// What two sides of a seam may be apart, in steps: copies that went through the same few operations, each rounded.
constexpr double rounding_steps = 4;
/// A vertex is joined only where its shortest edge is this many times as long as what may be apart.
constexpr double edges_per_rounding = 32;

/// A vertex on an open edge, and its shortest edge.
struct BorderVertices {
  std::vector<std::uint32_t> vertices;
  std::vector<double> shortest_edge;  ///< of each vertex of the mesh
};

BorderVertices border_of(const TriangleMesh& mesh, Execution& execution)
{
  std::vector<Triangle> proper;
  for_each_in_order(mesh.triangles.size(), execution, [&](std::size_t i) {
    if (is_proper(mesh.triangles[i], mesh.positions)) proper.push_back(mesh.triangles[i]);
  });
  const std::vector<Edge> edges = list_edges(proper, mesh.positions.size(), execution);
  std::vector<char> on_border(mesh.positions.size(), 0);
  bool is_open = false;
  for_each_in_order(edges.size(), execution, [&](std::size_t i) {
    if (edges[i].forward == edges[i].backward) return;
    on_border[edges[i].low] = on_border[edges[i].high] = 1;
    is_open = true;
  });
  if (!is_open) return {};
  BorderVertices border{{}, std::vector<double>(mesh.positions.size(), std::numeric_limits<double>::infinity())};
  for_each_in_order(edges.size(), execution, [&](std::size_t i) {
    const double length = norm(mesh.positions[edges[i].high] - mesh.positions[edges[i].low]);
    for (const std::uint32_t v : {edges[i].low, edges[i].high})
      border.shortest_edge[v] = std::min(border.shortest_edge[v], length);
  });
  for_each_in_order(on_border.size(), execution, [&](std::size_t v) {
    if (on_border[v]) border.vertices.push_back(std::uint32_t(v));
  });
  return border;
}

/// Points in cells as wide as what may be apart, so that a place can only be in a point's own cell or one beside it.
class PlaceGrid {
 public:
  PlaceGrid(const std::vector<Vec3>& positions, double apart) : positions_(positions), apart_(apart) {}

  void add(std::uint32_t v) { cells_[key(positions_[v], 0, 0, 0)].push_back(v); }

  /// The first point added that is at the place of v, or v.
  std::uint32_t at_place_of(std::uint32_t v) const
  {
    std::uint32_t first = v;
    for (int dx = -1; dx <= 1; ++dx)
      for (int dy = -1; dy <= 1; ++dy)
        for (int dz = -1; dz <= 1; ++dz) first = std::min(first, at_place_in(key(positions_[v], dx, dy, dz), v));
    return first;
  }

 private:
  std::uint32_t at_place_in(std::uint64_t cell, std::uint32_t v) const
  {
    const auto found = cells_.find(cell);
    if (found == cells_.end()) return v;
    for (const std::uint32_t other : found->second) {
      const Vec3 d = positions_[other] - positions_[v];
      if (std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)}) <= apart_) return other;
    }
    return v;
  }

  /// 21 bits an axis; what wraps around is told apart by its distance.
  std::uint64_t key(const Vec3& p, int dx, int dy, int dz) const
  {
    constexpr double period = 0x200000;
    const auto part = [&](double x, int by) {
      const double cell = std::floor(x / apart_) + by;
      return std::uint64_t(cell - std::floor(cell / period) * period);
    };
    return part(p.x, dx) << 42 | part(p.y, dy) << 21 | part(p.z, dz);
  }

  const std::vector<Vec3>& positions_;
  const double apart_;
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> cells_;
};

}  // namespace

std::vector<std::uint32_t> coincident_border(const TriangleMesh& mesh, Execution& execution)
{
  const BorderVertices border = border_of(mesh, execution);
  std::vector<Vec3> points;
  points.reserve(border.vertices.size());
  for (const std::uint32_t v : border.vertices) points.push_back(mesh.positions[v]);
  const double apart = rounding_steps * coordinate_step(points);
  if (!(apart > 0)) return {};

  PlaceGrid places(mesh.positions, apart);
  std::vector<std::uint32_t> first;
  for_each_in_order(border.vertices.size(), execution, [&](std::size_t i) {
    const std::uint32_t v = border.vertices[i];
    if (border.shortest_edge[v] < edges_per_rounding * apart) return;
    const std::uint32_t other = places.at_place_of(v);
    if (other == v) return places.add(v);
    if (first.empty()) {
      first.resize(mesh.positions.size());
      std::iota(first.begin(), first.end(), 0u);
    }
    first[v] = other;
  });
  return first;
}

}  // namespace integral_invariant
