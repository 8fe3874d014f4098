// SPDX-License-Identifier: GPL-3.0-or-later
// Surface engine: the mesh in an order in which neighbours in space are neighbours in memory.
#include "integral_invariant/moments/surface/prepared_mesh.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "integral_invariant/mesh/hilbert_sort.h"
#include "integral_invariant/mesh/kd_sort.h"
#include "integral_invariant/support/buckets.h"
#include "integral_invariant/support/large_pages.h"

namespace integral_invariant {

namespace {

/// Where a cell of about an edge's length holds more vertices than this, they are merged over cells of 1/32 of it: no
/// ball sees such detail, and without a bound on the density a fan of n triangles costs n².
constexpr std::size_t dense_cell = 1000;
constexpr int merged_levels = 5;

/// Per place, how many low bits of its cell are ignored when vertices are merged.
std::vector<int> merged_bits(const Surface& surface, const std::vector<CurveCell>& places)
{
  const double edges_across = std::max(1.0, surface.diagonal());  // the average edge is 1
  const int level = std::clamp(int(std::log2(edges_across)), 0, HilbertCurve::bits - merged_levels);
  const int cell_bits = 3 * (HilbertCurve::bits - level);
  std::vector<int> bits(places.size(), 0);
  for (std::size_t begin = 0, end = 0; begin < places.size(); begin = end) {
    while (end < places.size() && places[end].cell >> cell_bits == places[begin].cell >> cell_bits) ++end;
    if (end - begin > dense_cell)
      std::fill(bits.begin() + std::ptrdiff_t(begin), bits.begin() + std::ptrdiff_t(end),
                cell_bits - 3 * merged_levels);
  }
  return bits;
}

/// Fills points and vertices; returns the point of every vertex.
std::vector<std::uint32_t> merge_places(const Surface& surface, bool merge_dense, PreparedMesh& order,
                                        Execution& execution)
{
  // The box is centred at 0 and no longer than its diagonal.
  const HilbertCurve curve({}, 0.5 * surface.diagonal());
  const std::vector<CurveCell> places = hilbert_sort(
      curve, surface.positions(), [&](std::size_t v) { return surface.is_referenced(v); }, execution);
  const std::vector<int> bits = merge_dense ? merged_bits(surface, places) : std::vector<int>(places.size(), 0);
  std::vector<std::uint32_t> point_of(surface.vertex_count(), 0);
  reserve_large(order.points, places.size());
  reserve_large(order.vertices, places.size());
  reserve_large(order.vertex_start, places.size() + 1);
  for_each_in_order(places.size(), execution, [&](std::size_t i) {
    const Vec3& position = surface.positions()[places[i].vertex];
    const bool is_same_cell = i > 0 && bits[i] > 0 && places[i].cell >> bits[i] == places[i - 1].cell >> bits[i];
    if (i == 0 || !(is_same_cell || order.points.back() == position)) {
      order.points.push_back(position);
      order.vertex_start.push_back(std::uint32_t(order.vertices.size()));
    }
    order.vertices.push_back(places[i].vertex);
    point_of[places[i].vertex] = std::uint32_t(order.points.size() - 1);
  });
  order.vertex_start.push_back(std::uint32_t(order.vertices.size()));
  return point_of;
}

SortItem placed(const Vec3& p, std::size_t index)
{
  return {{float(p.x), float(p.y), float(p.z)}, std::uint32_t(index)};
}

/// Gives the points the order in which runs are compact, and `point_of` their new numbers.
void order_points(PreparedMesh& order, std::vector<std::uint32_t>& point_of, Execution& execution)
{
  std::vector<SortItem> items;
  reserve_large(items, order.points.size());
  for_each_in_order(order.points.size(), execution,
                    [&](std::size_t i) { items.push_back(placed(order.points[i], i)); });
  kd_sort(items, PreparedMesh::run, execution);
  std::vector<std::uint32_t> start, vertices, number(order.points.size());
  std::vector<Vec3> points;
  reserve_large(start, order.vertex_start.size());
  reserve_large(vertices, order.vertices.size());
  reserve_large(points, order.points.size());
  for_each_in_order(items.size(), execution, [&](std::size_t i) {
    const std::uint32_t point = items[i].index;
    number[point] = std::uint32_t(points.size());
    points.push_back(order.points[point]);
    start.push_back(std::uint32_t(vertices.size()));
    for (std::uint32_t v = order.vertex_start[point]; v < order.vertex_start[point + 1]; ++v)
      vertices.push_back(order.vertices[v]);
  });
  start.push_back(std::uint32_t(vertices.size()));
  for_each_index(vertices.size(), execution,
                 [&](std::size_t i) { point_of[vertices[i]] = number[point_of[vertices[i]]]; });
  order.points.swap(points);
  order.vertices.swap(vertices);
  order.vertex_start.swap(start);
}

void order_triangles(const Surface& surface, const std::vector<std::uint32_t>& point_of, PreparedMesh& order,
                     Execution& execution)
{
  std::vector<Triangle> kept;
  std::vector<SortItem> items;
  reserve_large(kept, surface.triangles().size());
  reserve_large(items, surface.triangles().size());
  for_each_in_order(surface.triangles().size(), execution, [&](std::size_t i) {
    const Triangle& triangle = surface.triangles()[i];
    const Triangle t = smallest_first({std::int32_t(point_of[std::size_t(triangle[0])]),
                                       std::int32_t(point_of[std::size_t(triangle[1])]),
                                       std::int32_t(point_of[std::size_t(triangle[2])])});
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) return;
    const Vec3 sum =
        order.points[std::size_t(t[0])] + order.points[std::size_t(t[1])] + order.points[std::size_t(t[2])];
    items.push_back(placed(sum, kept.size()));
    kept.push_back(t);
  });
  kd_sort(items, PreparedMesh::run, execution);
  resize_in_steps(order.triangles, kept.size(), execution);
  for_each_index(kept.size(), execution, [&](std::size_t i) { order.triangles[i] = kept[items[i].index]; });
}

void find_normals(PreparedMesh& order, Execution& execution)
{
  resize_in_steps(order.normals, order.points.size(), execution);
  for_each_in_order(order.triangles.size(), execution, [&](std::size_t triangle) {
    const Triangle& t = order.triangles[triangle];
    const Vec3 &a = order.points[std::size_t(t[0])], &b = order.points[std::size_t(t[1])],
               &c = order.points[std::size_t(t[2])];
    const Vec3 area = cross(b - a, c - a);
    for (const std::int32_t i : t) order.normals[std::size_t(i)] += area;
  });
  for_each_index(order.normals.size(), execution,
                 [&](std::size_t i) { order.normals[i] = normalized(order.normals[i]); });
}

struct DirectedEdge {
  std::uint32_t low, high, opposite;
  bool up;  ///< passed from low to high
};

void add_boundary_edge(const DirectedEdge* begin, const DirectedEdge* end, std::vector<BoundaryEdge>& boundary_edges)
{
  std::int32_t surplus = 0;
  for (const DirectedEdge* e = begin; e != end; ++e) surplus += e->up ? 1 : -1;
  if (surplus == 0) return;
  const DirectedEdge* e = std::find_if(begin, end, [&](const DirectedEdge& d) { return d.up == (surplus > 0); });
  if (surplus > 0)
    boundary_edges.push_back({e->low, e->high, surplus, e->opposite});
  else
    boundary_edges.push_back({e->high, e->low, -surplus, e->opposite});
}

void find_free_edges(PreparedMesh& order, Execution& execution)
{
  // By their smaller point: those buckets are short and stay in the cache.
  Buckets<DirectedEdge> edges = in_buckets<DirectedEdge>(
      order.triangles.size(), order.points.size(), execution, [&](std::size_t triangle, const auto& put) {
        const Triangle& t = order.triangles[triangle];
        for (std::size_t i = 0; i < 3; ++i) {
          const auto a = std::uint32_t(t[i]), b = std::uint32_t(t[(i + 1) % 3]), c = std::uint32_t(t[(i + 2) % 3]);
          put(std::min(a, b), DirectedEdge{std::min(a, b), std::max(a, b), c, a < b});
        }
      });
  const auto less = [](const DirectedEdge& a, const DirectedEdge& b) {
    return std::make_pair(a.high, a.opposite) < std::make_pair(b.high, b.opposite);
  };
  for_each_index(edges.count(), execution,
                 [&](std::size_t point) { std::sort(edges.begin(point), edges.end(point), less); });
  for_each_in_order(edges.count(), execution, [&](std::size_t point) {
    for (const DirectedEdge *edge = edges.begin(point), *end = edges.end(point), *next = edge; edge != end;
         edge = next) {
      while (next != end && next->high == edge->high) ++next;
      add_boundary_edge(edge, next, order.boundary_edges);
    }
  });
}

}  // namespace

PreparedMesh prepare_mesh(const Surface& surface, bool merge_dense, Execution& execution)
{
  PreparedMesh order;
  std::vector<std::uint32_t> point_of = merge_places(surface, merge_dense, order, execution);
  order_points(order, point_of, execution);
  order_triangles(surface, point_of, order, execution);
  find_normals(order, execution);
  find_free_edges(order, execution);
  return order;
}

}  // namespace integral_invariant
