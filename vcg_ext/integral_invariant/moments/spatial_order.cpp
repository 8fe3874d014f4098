// SPDX-License-Identifier: GPL-3.0-or-later
// Surface engine: the mesh in an order in which neighbours in space are neighbours in memory.
#include "integral_invariant/moments/spatial_order.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "integral_invariant/moments/compact_order.h"
#include "integral_invariant/support/hilbert_curve.h"

namespace integral_invariant {

namespace {

struct Key {
  std::uint64_t index;
  std::uint32_t vertex;
};

std::vector<Key> sorted_keys(const Surface& surface, Execution& execution)
{
  const std::vector<Vec3>& positions = surface.positions();
  // The box is centred at 0 and no longer than its diagonal.
  const std::vector<std::uint64_t> along = HilbertCurve({}, 0.5 * surface.diagonal()).indices(positions, execution);
  std::vector<Key> keys;
  keys.reserve(positions.size());
  for (std::size_t v = 0; v < positions.size(); ++v)
    if (surface.is_referenced(v)) keys.push_back({along[v], std::uint32_t(v)});
  const auto less = [&](const Key& a, const Key& b) {
    return a.index != b.index ? a.index < b.index : precedes(a.vertex, b.vertex, positions);
  };
  // A mesh in canonical order is sorted but for rounding.
  if (!std::is_sorted(keys.begin(), keys.end(), less)) std::sort(keys.begin(), keys.end(), less);
  return keys;
}

/// Where a cell of about an edge's length holds more vertices than this, they are merged over cells of 1/32 of it: no
/// ball sees such detail, and without a bound on the density a fan of n triangles costs n².
constexpr std::size_t dense_cell = 1000;
constexpr int merged_levels = 5;

/// Per key, how many low bits of the curve's index are ignored when vertices are merged.
std::vector<int> merged_bits(const Surface& surface, const std::vector<Key>& keys)
{
  const double edges_across = std::max(1.0, surface.diagonal());  // the average edge is 1
  const int level = std::clamp(int(std::log2(edges_across)), 0, HilbertCurve::bits - merged_levels);
  const int cell_bits = 3 * (HilbertCurve::bits - level);
  std::vector<int> bits(keys.size(), 0);
  for (std::size_t begin = 0, end = 0; begin < keys.size(); begin = end) {
    while (end < keys.size() && keys[end].index >> cell_bits == keys[begin].index >> cell_bits) ++end;
    if (end - begin > dense_cell)
      std::fill(bits.begin() + std::ptrdiff_t(begin), bits.begin() + std::ptrdiff_t(end),
                cell_bits - 3 * merged_levels);
  }
  return bits;
}

/// Fills points and vertices; returns the point of every vertex.
std::vector<std::uint32_t> merge_places(const Surface& surface, bool merge_dense, SpatialOrder& order,
                                        Execution& execution)
{
  const std::vector<Key> keys = sorted_keys(surface, execution);
  const std::vector<int> bits = merge_dense ? merged_bits(surface, keys) : std::vector<int>(keys.size(), 0);
  std::vector<std::uint32_t> point_of(surface.vertex_count(), 0);
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const Vec3& position = surface.positions()[keys[i].vertex];
    const bool is_same_cell = i > 0 && bits[i] > 0 && keys[i].index >> bits[i] == keys[i - 1].index >> bits[i];
    if (i == 0 || !(is_same_cell || order.points.back() == position)) {
      order.points.push_back(position);
      order.vertex_start.push_back(std::uint32_t(order.vertices.size()));
    }
    order.vertices.push_back(keys[i].vertex);
    point_of[keys[i].vertex] = std::uint32_t(order.points.size() - 1);
  }
  order.vertex_start.push_back(std::uint32_t(order.vertices.size()));
  return point_of;
}

PlacedItem placed(const Vec3& p, std::size_t index)
{
  return {{float(p.x), float(p.y), float(p.z)}, std::uint32_t(index)};
}

/// Gives the points the order in which runs are compact, and `point_of` their new numbers.
void order_points(SpatialOrder& order, std::vector<std::uint32_t>& point_of, Execution& execution)
{
  std::vector<PlacedItem> items;
  items.reserve(order.points.size());
  for (std::size_t i = 0; i < order.points.size(); ++i) items.push_back(placed(order.points[i], i));
  order_compactly(items, SpatialOrder::run, execution);
  std::vector<std::uint32_t> start, vertices, number(order.points.size());
  std::vector<Vec3> points;
  start.reserve(order.vertex_start.size());
  vertices.reserve(order.vertices.size());
  points.reserve(order.points.size());
  for (const PlacedItem& item : items) {
    number[item.index] = std::uint32_t(points.size());
    points.push_back(order.points[item.index]);
    start.push_back(std::uint32_t(vertices.size()));
    for (std::uint32_t v = order.vertex_start[item.index]; v < order.vertex_start[item.index + 1]; ++v)
      vertices.push_back(order.vertices[v]);
  }
  start.push_back(std::uint32_t(vertices.size()));
  for (const std::uint32_t v : vertices) point_of[v] = number[point_of[v]];
  order.points.swap(points);
  order.vertices.swap(vertices);
  order.vertex_start.swap(start);
}

void order_triangles(const Surface& surface, const std::vector<std::uint32_t>& point_of, SpatialOrder& order,
                     Execution& execution)
{
  std::vector<Triangle> kept;
  std::vector<PlacedItem> items;
  kept.reserve(surface.triangles().size());
  items.reserve(surface.triangles().size());
  for (const Triangle& triangle : surface.triangles()) {
    const Triangle t = smallest_first({std::int32_t(point_of[std::size_t(triangle[0])]),
                                       std::int32_t(point_of[std::size_t(triangle[1])]),
                                       std::int32_t(point_of[std::size_t(triangle[2])])});
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
    const Vec3 sum =
        order.points[std::size_t(t[0])] + order.points[std::size_t(t[1])] + order.points[std::size_t(t[2])];
    items.push_back(placed(sum, kept.size()));
    kept.push_back(t);
  }
  order_compactly(items, SpatialOrder::run, execution);
  order.triangles.resize(kept.size());
  for_each_index(kept.size(), execution, [&](std::size_t i) { order.triangles[i] = kept[items[i].index]; });
}

void find_normals(SpatialOrder& order)
{
  order.normals.assign(order.points.size(), {});
  for (const Triangle& t : order.triangles) {
    const Vec3 &a = order.points[std::size_t(t[0])], &b = order.points[std::size_t(t[1])],
               &c = order.points[std::size_t(t[2])];
    const Vec3 area = cross(b - a, c - a);
    for (const std::int32_t i : t) order.normals[std::size_t(i)] += area;
  }
  for (Vec3& normal : order.normals) normal = normalized(normal);
}

struct DirectedEdge {
  std::uint32_t low, high, opposite;
  bool up;  ///< passed from low to high
};

void add_free_edge(const DirectedEdge* begin, const DirectedEdge* end, std::vector<FreeEdge>& free_edges)
{
  std::int32_t surplus = 0;
  for (const DirectedEdge* e = begin; e != end; ++e) surplus += e->up ? 1 : -1;
  if (surplus == 0) return;
  const DirectedEdge* e = std::find_if(begin, end, [&](const DirectedEdge& d) { return d.up == (surplus > 0); });
  if (surplus > 0)
    free_edges.push_back({e->low, e->high, surplus, e->opposite});
  else
    free_edges.push_back({e->high, e->low, -surplus, e->opposite});
}

/// All edges in buckets by their smaller point: those are short and stay in the cache.
struct EdgeBuckets {
  std::vector<DirectedEdge> edges;
  std::vector<std::uint32_t> end;  ///< of the bucket of each point
};

EdgeBuckets bucket_edges(const SpatialOrder& order)
{
  std::vector<std::uint32_t> start(order.points.size() + 1, 0);
  for (const Triangle& t : order.triangles)
    for (int i = 0; i < 3; ++i) ++start[std::size_t(std::min(t[i], t[(i + 1) % 3])) + 1];
  std::partial_sum(start.begin(), start.end(), start.begin());
  std::vector<DirectedEdge> edges(start.back());
  for (const Triangle& t : order.triangles)
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t a = std::uint32_t(t[i]), b = std::uint32_t(t[(i + 1) % 3]), c = std::uint32_t(t[(i + 2) % 3]);
      edges[start[std::min(a, b)]++] = {std::min(a, b), std::max(a, b), c, a < b};
    }
  return {std::move(edges), std::move(start)};  // filled, a bucket ends where its start has moved to
}

void find_free_edges(EdgeBuckets buckets, SpatialOrder& order, Execution& execution)
{
  std::vector<DirectedEdge>& edges = buckets.edges;
  const auto less = [](const DirectedEdge& a, const DirectedEdge& b) {
    return std::make_pair(a.high, a.opposite) < std::make_pair(b.high, b.opposite);
  };
  parallel_step(order.points.size(), 8192, execution, [&](std::size_t begin, std::size_t end, int) {
    for (std::size_t point = begin; point < end; ++point)
      std::sort(edges.begin() + std::ptrdiff_t(point == 0 ? 0 : buckets.end[point - 1]),
                edges.begin() + std::ptrdiff_t(buckets.end[point]), less);
  });
  for (std::size_t i = 0, j = 0; i < edges.size(); i = j) {
    while (j < edges.size() && edges[j].low == edges[i].low && edges[j].high == edges[i].high) ++j;
    add_free_edge(edges.data() + i, edges.data() + j, order.free_edges);
  }
}

}  // namespace

SpatialOrder order_in_space(const Surface& surface, bool merge_dense, Execution& execution)
{
  SpatialOrder order;
  std::vector<std::uint32_t> point_of = merge_places(surface, merge_dense, order, execution);
  order_points(order, point_of, execution);
  execution.check();
  order_triangles(surface, point_of, order, execution);
  execution.check();
  EdgeBuckets buckets;
  parallel_step(2, 1, execution, [&](std::size_t begin, std::size_t end, int) {
    for (std::size_t task = begin; task < end; ++task)
      if (task == 0)
        buckets = bucket_edges(order);
      else
        find_normals(order);
  });
  find_free_edges(std::move(buckets), order, execution);
  return order;
}

}  // namespace integral_invariant
