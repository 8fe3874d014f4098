// SPDX-License-Identifier: GPL-3.0-or-later
// Checks a mesh and brings it to normalised coordinates. In: positions and triangles as the caller has them. Out: the
// triangles that bound the solid, neighbours, and what was found. Cost: O((n + m) log valence), about 0.2 µs a
// triangle.
#include "integral_invariant/surface.h"

#include <algorithm>
#include <cmath>

#include "integral_invariant/edge_list.h"
#include "integral_invariant/support/error.h"

namespace integral_invariant {

namespace {

/// Items of [0, keys.size()) in buckets by key: those of bucket k are order[start[k]] up to order[start[k + 1]].
struct Buckets {
  std::vector<std::uint32_t> start, order;
};

template <class KeyOf>
Buckets bucket(std::size_t items, std::size_t keys, const KeyOf& key_of)
{
  Buckets b;
  b.start.assign(keys + 1, 0);
  for (std::size_t i = 0; i < items; ++i) ++b.start[key_of(i) + 1];
  for (std::size_t k = 0; k < keys; ++k) b.start[k + 1] += b.start[k];
  b.order.resize(items);
  std::vector<std::uint32_t> next(b.start.begin(), b.start.end() - 1);
  for (std::size_t i = 0; i < items; ++i) b.order[next[key_of(i)]++] = std::uint32_t(i);
  return b;
}

std::vector<Triangle> without_repetitions(const std::vector<Triangle>& triangles, std::size_t vertices)
{
  std::vector<Triangle> key(triangles.size());
  std::transform(triangles.begin(), triangles.end(), key.begin(), smallest_first);
  Buckets b = bucket(triangles.size(), vertices, [&](std::size_t i) { return key[i][0]; });
  std::vector<char> repeated(triangles.size(), 0);
  for (std::size_t v = 0; v < vertices; ++v) {
    const auto begin = b.order.begin() + b.start[v], end = b.order.begin() + b.start[v + 1];
    std::sort(begin, end, [&](std::uint32_t i, std::uint32_t j) { return key[i] != key[j] ? key[i] < key[j] : i < j; });
    for (auto it = begin; it != end; ++it)
      if (it != begin && key[*it] == key[*(it - 1)]) repeated[*it] = 1;
  }
  std::vector<Triangle> kept;
  kept.reserve(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i)
    if (!repeated[i]) kept.push_back(triangles[i]);
  return kept;
}

bool closes(const std::vector<Edge>& edges)
{
  return std::all_of(edges.begin(), edges.end(), [](const Edge& e) { return e.forward == e.backward; });
}

}  // namespace

Surface::Surface(const TriangleMesh& mesh)
{
  Execution execution(1);
  *this = Surface(mesh, execution);
}

Surface::Surface(const TriangleMesh& mesh, Execution& execution)
{
  take_triangles(mesh);
  std::vector<Edge> edges = edge_list(triangles_, mesh.positions.size(), execution);
  normalise(mesh, edges);
  drop_repetitions(edges, execution);
  connect(edges);
  turn_outward();
}

void Surface::take_triangles(const TriangleMesh& mesh)
{
  report_.vertices = mesh.positions.size();
  report_.triangles = mesh.triangles.size();
  if (mesh.triangles.empty())
    throw InputError(
        "The mesh has no faces. Curvature is measured on a surface: reconstruct one from the points first, "
        "for example with \"Surface Reconstruction: Screened Poisson\".");
  for (const Vec3& p : mesh.positions) report_.nonfinite_vertices += !is_finite(p);

  require_valid_indices(mesh);
  triangles_.reserve(mesh.triangles.size());
  for (const Triangle& t : mesh.triangles)
    if (is_proper(t, mesh.positions)) triangles_.push_back(t);
  report_.left_out_triangles = mesh.triangles.size() - triangles_.size();
}

void Surface::normalise(const TriangleMesh& mesh, const std::vector<Edge>& edges)
{
  Box box;
  std::vector<char> used(mesh.positions.size(), 0);
  for (const Triangle& t : triangles_)
    for (const std::int32_t v : t) {
      used[v] = 1;
      box.add(mesh.positions[v]);
    }
  const Vec3 extent = box.high - box.low;
  const double size = std::max({extent.x, extent.y, extent.z});
  if (triangles_.empty() || size == 0)
    throw InputError("No face of the mesh has an area. Check the mesh, for example with \"Remove Zero Area Faces\".");
  // Within these, no result overflows: curvatures go with the inverse of the size, areas with its square.
  constexpr double smallest_size = 1e-100, largest_size = 1e100;
  if (!(size <= largest_size))
    throw InputError("The coordinates of the mesh are too large to compute with. Scale the mesh down first.");
  if (size < smallest_size)
    throw InputError("The coordinates of the mesh are too small to compute with. Scale the mesh up first.");

  // By the size first: the squares in a length cannot overflow then, nor underflow.
  const Vec3 centre = box.low + extent * 0.5;
  positions_.assign(mesh.positions.size(), Vec3{});
  for (std::size_t v = 0; v < positions_.size(); ++v)
    if (used[v]) {
      const Vec3 p = mesh.positions[v] - centre;
      positions_[v] = {p.x / size, p.y / size, p.z / size};
    }
  double length = 0;
  for (const Edge& e : edges) length += norm(positions_[e.low] - positions_[e.high]);
  const double average = length / double(edges.size());
  // Under it, a coordinate has less than three digits within an edge.
  constexpr double smallest_edge = 1e-12;
  if (!(average >= smallest_edge))
    throw InputError(
        "The faces of the mesh are too small for how far apart they are: a coordinate cannot hold both. Remove "
        "the faces that lie far away, or measure the parts one by one.");
  for (Vec3& p : positions_) p *= 1 / average;
  unit_ = size * average;
  diagonal_ = norm({extent.x / size, extent.y / size, extent.z / size}) / average;
}

void Surface::drop_repetitions(std::vector<Edge>& edges, Execution& execution)
{
  const auto repeats = [](const Edge& e) { return e.forward > 1 || e.backward > 1; };
  if (std::none_of(edges.begin(), edges.end(), repeats)) return;
  std::vector<Triangle> kept = without_repetitions(triangles_, positions_.size());
  report_.duplicate_triangles = triangles_.size() - kept.size();
  if (kept.size() == triangles_.size()) return;
  std::vector<Edge> kept_edges = edge_list(kept, positions_.size(), execution);
  if (!closes(kept_edges) && closes(edges)) return;
  triangles_ = std::move(kept);
  edges = std::move(kept_edges);
}

void Surface::connect(const std::vector<Edge>& edges)
{
  const std::size_t n = positions_.size();
  neighbour_start_.assign(n + 1, 0);
  for (const Edge& e : edges) {
    report_.boundary_edges += e.forward + e.backward == 1;
    report_.inconsistent_edges += e.forward + e.backward > 1 && e.forward != e.backward;
    ++neighbour_start_[e.low + 1];
    ++neighbour_start_[e.high + 1];
  }
  for (std::size_t v = 0; v < n; ++v) {
    report_.unreferenced_vertices += neighbour_start_[v + 1] == 0;
    neighbour_start_[v + 1] += neighbour_start_[v];
  }
  // Edges come ordered by (low, high), so every list fills in increasing order.
  neighbours_.resize(2 * edges.size());
  std::vector<std::uint32_t> next(neighbour_start_.begin(), neighbour_start_.end() - 1);
  for (const Edge& e : edges) neighbours_[next[e.high]++] = e.low;
  for (const Edge& e : edges) neighbours_[next[e.low]++] = e.high;
}

void Surface::turn_outward()
{
  double six_volumes = 0, area = 0;
  for (const Triangle& t : triangles_) {
    const Vec3 &a = positions_[t[0]], &b = positions_[t[1]], &c = positions_[t[2]];
    const Vec3 doubled_area = cross(b - a, c - a);
    report_.zero_area_triangles += squared_norm(doubled_area) == 0;
    six_volumes += dot(a, doubled_area);
    area += norm(doubled_area) / 2;
  }
  if (!(area > 0))
    throw InputError("No face of the mesh has an area. Check the mesh, for example with \"Remove Zero Area Faces\".");

  // A volume within rounding of zero, as of a sheet with two sides, has no inside.
  constexpr double rounding = 1e-10;
  report_.inside_out = is_closed() && six_volumes < -rounding * area * diagonal_;
  if (report_.inside_out)
    for (Triangle& t : triangles_) std::swap(t[1], t[2]);
}

}  // namespace integral_invariant
