// SPDX-License-Identifier: GPL-3.0-or-later
// Checks a mesh and brings it to normalised coordinates. In: positions and triangles as the caller has them. Out: the
// triangles that bound the solid, neighbours, and what was found. Cost: O((n + m) log valence), about 0.2 µs a triangle.
#include "integral_invariant/surface.h"

#include <algorithm>
#include <cmath>
#include <string>

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

/// The same cyclic order, smallest index first.
Triangle canonical(Triangle t)
{
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return t;
}

std::vector<Triangle> without_repetitions(const std::vector<Triangle>& triangles, std::size_t vertices)
{
  std::vector<Triangle> key(triangles.size());
  std::transform(triangles.begin(), triangles.end(), key.begin(), canonical);
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

/// An undirected edge and how its triangles pass it.
struct Edge {
  std::uint32_t low, high;
  int forward, backward;  ///< passes from low to high, from high to low
};

/// Calls visit(Edge) once for each undirected edge, ordered by (low, high).
template <class Visit>
void for_each_edge(const std::vector<Triangle>& triangles, std::size_t vertices, const Visit& visit)
{
  const auto low_end = [&](std::size_t side) {
    const Triangle& t = triangles[side / 3];
    return std::min(t[side % 3], t[(side + 1) % 3]);
  };
  const Buckets b = bucket(3 * triangles.size(), vertices, low_end);
  struct Pass {
    std::uint32_t high;
    bool forward;
  };
  std::vector<Pass> passes;
  for (std::size_t v = 0; v < vertices; ++v) {
    passes.clear();
    for (std::uint32_t i = b.start[v]; i < b.start[v + 1]; ++i) {
      const Triangle& t = triangles[b.order[i] / 3];
      const std::uint32_t from = t[b.order[i] % 3], to = t[(b.order[i] + 1) % 3];
      passes.push_back({std::max(from, to), from < to});
    }
    std::sort(passes.begin(), passes.end(), [](const Pass& p, const Pass& q) { return p.high < q.high; });
    for (std::size_t i = 0; i < passes.size();) {
      Edge edge{std::uint32_t(v), passes[i].high, 0, 0};
      for (; i < passes.size() && passes[i].high == edge.high; ++i) ++(passes[i].forward ? edge.forward : edge.backward);
      visit(edge);
    }
  }
}

bool closes(const std::vector<Triangle>& triangles, std::size_t vertices)
{
  bool balanced = true;
  for_each_edge(triangles, vertices, [&](const Edge& e) { balanced = balanced && e.forward == e.backward; });
  return balanced;
}

bool is_finite(const Triangle& t, const std::vector<Vec3>& positions)
{
  return std::all_of(t.begin(), t.end(), [&](std::int32_t v) { return is_finite(positions[v]); });
}

struct Box {
  Vec3 low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};

  void add(const Vec3& p)
  {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
};

}  // namespace

Surface::Surface(const TriangleMesh& mesh)
{
  take_triangles(mesh);
  normalise(mesh);
  drop_repetitions();
  connect();
  turn_outward();
}

void Surface::take_triangles(const TriangleMesh& mesh)
{
  const auto n = std::int64_t(mesh.positions.size());
  report_.vertices = mesh.positions.size();
  report_.triangles = mesh.triangles.size();
  if (mesh.triangles.empty())
    throw InputError("The mesh has no faces. Curvature is measured on a surface: reconstruct one from the points first, "
                     "for example with \"Surface Reconstruction: Screened Poisson\".");
  for (const Vec3& p : mesh.positions) report_.nonfinite_vertices += !is_finite(p);

  triangles_.reserve(mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) {
    for (const std::int32_t v : t)
      if (v < 0 || v >= n)
        throw InputError("A face refers to vertex " + std::to_string(v) + ", but the mesh has " + std::to_string(n) +
                         " vertices. The mesh is damaged: load it anew or repair the file.");
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0] && is_finite(t, mesh.positions)) triangles_.push_back(t);
  }
  report_.left_out_triangles = mesh.triangles.size() - triangles_.size();
}

void Surface::normalise(const TriangleMesh& mesh)
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
  std::size_t edges = 0;
  for_each_edge(triangles_, positions_.size(), [&](const Edge& e) {
    length += norm(positions_[e.low] - positions_[e.high]);
    ++edges;
  });
  const double average = length / double(edges);
  // Under it, a coordinate has less than three digits within an edge.
  constexpr double smallest_edge = 1e-12;
  if (!(average >= smallest_edge))
    throw InputError("The faces of the mesh are too small for how far apart they are: a coordinate cannot hold both. Remove "
                     "the faces that lie far away, or measure the parts one by one.");
  for (Vec3& p : positions_) p *= 1 / average;
  unit_ = size * average;
  diagonal_ = norm({extent.x / size, extent.y / size, extent.z / size}) / average;
}

void Surface::drop_repetitions()
{
  std::vector<Triangle> kept = without_repetitions(triangles_, positions_.size());
  report_.duplicate_triangles = triangles_.size() - kept.size();
  if (kept.size() == triangles_.size()) return;
  if (closes(kept, positions_.size()) || !closes(triangles_, positions_.size())) triangles_ = std::move(kept);
}

void Surface::connect()
{
  const std::size_t n = positions_.size();
  std::vector<std::uint32_t> low, high;
  for_each_edge(triangles_, n, [&](const Edge& e) {
    low.push_back(e.low);
    high.push_back(e.high);
    report_.boundary_edges += e.forward + e.backward == 1;
    report_.inconsistent_edges += e.forward + e.backward > 1 && e.forward != e.backward;
  });
  neighbour_start_.assign(n + 1, 0);
  for (std::size_t e = 0; e < low.size(); ++e) {
    ++neighbour_start_[low[e] + 1];
    ++neighbour_start_[high[e] + 1];
  }
  for (std::size_t v = 0; v < n; ++v) {
    report_.unreferenced_vertices += neighbour_start_[v + 1] == 0;
    neighbour_start_[v + 1] += neighbour_start_[v];
  }
  // Edges come ordered by (low, high), so every list fills in increasing order.
  neighbours_.resize(2 * low.size());
  std::vector<std::uint32_t> next(neighbour_start_.begin(), neighbour_start_.end() - 1);
  for (std::size_t e = 0; e < low.size(); ++e) neighbours_[next[high[e]]++] = low[e];
  for (std::size_t e = 0; e < low.size(); ++e) neighbours_[next[low[e]]++] = high[e];
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
