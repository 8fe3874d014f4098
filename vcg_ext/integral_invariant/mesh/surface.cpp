// SPDX-License-Identifier: GPL-3.0-or-later
// Checks a mesh and brings it to normalised coordinates. In: positions and triangles as the caller has them. Out: the
// triangles that bound the solid, neighbours, and what was found. Cost: O((n + m) log valence), about 0.2 µs a
// triangle.
#include "integral_invariant/mesh/surface.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "integral_invariant/error.h"
#include "integral_invariant/mesh/coordinate_step.h"
#include "integral_invariant/mesh/edges.h"
#include "integral_invariant/support/buckets.h"
#include "integral_invariant/support/large_pages.h"

namespace integral_invariant {

namespace {

/// A triangle from its smallest vertex on, and its number.
struct NumberedTriangle {
  Triangle triangle;
  std::uint32_t number;
};

std::vector<Triangle> without_repetitions(const std::vector<Triangle>& triangles, std::size_t vertices,
                                          Execution& execution)
{
  Buckets<NumberedTriangle> buckets =
      in_buckets<NumberedTriangle>(triangles.size(), vertices, execution, [&](std::size_t i, const auto& put) {
        const Triangle t = smallest_first(triangles[i]);
        put(std::size_t(t[0]), NumberedTriangle{t, std::uint32_t(i)});
      });
  std::vector<char> repeated(triangles.size(), 0);
  for_each_index(vertices, execution, [&](std::size_t v) {
    NumberedTriangle *const begin = buckets.begin(v), *const end = buckets.end(v);
    std::sort(begin, end, [](const NumberedTriangle& a, const NumberedTriangle& b) {
      return a.triangle != b.triangle ? a.triangle < b.triangle : a.number < b.number;
    });
    for (NumberedTriangle* t = begin; t != end; ++t)
      if (t != begin && t->triangle == (t - 1)->triangle) repeated[t->number] = 1;
  });
  std::vector<Triangle> kept;
  reserve_large(kept, triangles.size());
  for_each_in_order(triangles.size(), execution, [&](std::size_t i) {
    if (!repeated[i]) kept.push_back(triangles[i]);
  });
  return kept;
}

bool closes(const std::vector<Edge>& edges, Execution& execution)
{
  bool closes = true;
  for_each_in_order(edges.size(), execution,
                    [&](std::size_t i) { closes = closes && edges[i].forward == edges[i].backward; });
  return closes;
}

bool repeats(const std::vector<Edge>& edges, Execution& execution)
{
  bool repeats = false;
  for_each_in_order(edges.size(), execution,
                    [&](std::size_t i) { repeats = repeats || edges[i].forward > 1 || edges[i].backward > 1; });
  return repeats;
}

}  // namespace

Surface::Surface(const TriangleMesh& mesh)
{
  Execution execution(1);
  *this = Surface(mesh, execution);
}

Surface::Surface(const TriangleMesh& mesh, Execution& execution)
{
  take_triangles(mesh, execution);
  std::vector<Edge> edges = list_edges(triangles_, mesh.positions.size(), execution);
  normalise(mesh, edges, execution);
  drop_repetitions(edges, execution);
  connect(edges, execution);
  turn_outward(execution);
}

void Surface::turn_to(const Axes& axes, Execution& execution)
{
  Box box;
  for_each_in_order(positions_.size(), execution, [&](std::size_t v) {
    if (!is_referenced(v)) return;
    positions_[v] = axes.coordinates_of(positions_[v]);
    box.add(positions_[v]);
  });
  const Vec3 centre = box.low + (box.high - box.low) * 0.5;
  for_each_index(positions_.size(), execution, [&](std::size_t v) {
    if (is_referenced(v)) positions_[v] -= centre;
  });
}

void Surface::take_triangles(const TriangleMesh& mesh, Execution& execution)
{
  report_.vertices = mesh.positions.size();
  report_.triangles = mesh.triangles.size();
  if (mesh.triangles.empty())
    throw InputError(
        "The mesh has no faces. Curvature is measured on a surface: reconstruct one from the points first, "
        "for example with \"Surface Reconstruction: Screened Poisson\".");
  for_each_in_order(mesh.positions.size(), execution,
                    [&](std::size_t v) { report_.nonfinite_vertices += !is_finite(mesh.positions[v]); });

  require_valid_indices(mesh);
  reserve_large(triangles_, mesh.triangles.size());
  for_each_in_order(mesh.triangles.size(), execution, [&](std::size_t i) {
    if (is_proper(mesh.triangles[i], mesh.positions)) triangles_.push_back(mesh.triangles[i]);
  });
  report_.left_out_triangles = mesh.triangles.size() - triangles_.size();
}

void Surface::normalise(const TriangleMesh& mesh, const std::vector<Edge>& edges, Execution& execution)
{
  Box box;
  std::vector<char> used(mesh.positions.size(), 0);
  for_each_in_order(triangles_.size(), execution, [&](std::size_t i) {
    for (const std::int32_t v : triangles_[i]) {
      used[v] = 1;
      box.add(mesh.positions[v]);
    }
  });
  const Vec3 extent = box.high - box.low;
  const double size = std::max({extent.x, extent.y, extent.z});
  if (triangles_.empty() || size == 0) refuse_without_area();
  // Within these, no result overflows: curvatures go with the inverse of the size, areas with its square.
  constexpr double smallest_size = 1e-100, largest_size = 1e100;
  if (!(size <= largest_size))
    throw InputError("The coordinates of the mesh are too large to compute with. Scale the mesh down first.");
  if (size < smallest_size)
    throw InputError("The coordinates of the mesh are too small to compute with. Scale the mesh up first.");

  // By the size first: the squares in a length cannot overflow then, nor underflow.
  const Vec3 centre = box.low + extent * 0.5;
  resize_in_steps(positions_, mesh.positions.size(), execution);
  for_each_index(positions_.size(), execution, [&](std::size_t v) {
    if (!used[v]) return;
    const Vec3 p = mesh.positions[v] - centre;
    positions_[v] = {p.x / size, p.y / size, p.z / size};
  });
  double length = 0;
  for_each_in_order(edges.size(), execution,
                    [&](std::size_t i) { length += norm(positions_[edges[i].low] - positions_[edges[i].high]); });
  const double average = length / double(edges.size());
  // Under it, a coordinate has less than three digits within an edge.
  constexpr double smallest_edge = 1e-12;
  if (!(average >= smallest_edge))
    throw InputError(
        "The faces of the mesh are too small for how far apart they are: a coordinate cannot hold both. Remove "
        "the faces that lie far away, or measure the parts one by one.");
  for_each_index(positions_.size(), execution, [&](std::size_t v) { positions_[v] *= 1 / average; });
  unit_ = size * average;
  require_shape(mesh, used, execution);
  diagonal_ = norm({extent.x / size, extent.y / size, extent.z / size}) / average;
}

/// Far from the origin, neighbouring values of a coordinate may be farther apart than vertices are.
void Surface::require_shape(const TriangleMesh& mesh, const std::vector<char>& used, Execution& execution)
{
  std::vector<Vec3> points;
  reserve_large(points, mesh.positions.size());
  for_each_in_order(mesh.positions.size(), execution, [&](std::size_t v) {
    if (used[v]) points.push_back(mesh.positions[v]);
  });
  report_.coordinate_step = binary_step(points);
  // Rounding is noise then, of a tenth of an edge and more, and neighbours fall into one place.
  constexpr double largest_step = 1.0 / 3;  // average edges
  if (report_.coordinate_step <= largest_step * unit_) return;
  std::ostringstream text;
  text << "The coordinates of the mesh have lost its shape: as far from the origin as it lies they come in steps of "
       << report_.coordinate_step << ", but its average edge length is " << unit_
       << ". Move the mesh to the origin before it is stored, or open it in a host that computes in double precision, "
          "such as PyMeshLab.";
  throw InputError(text.str());
}

void Surface::drop_repetitions(std::vector<Edge>& edges, Execution& execution)
{
  if (!repeats(edges, execution)) return;
  std::vector<Triangle> kept = without_repetitions(triangles_, positions_.size(), execution);
  report_.duplicate_triangles = triangles_.size() - kept.size();
  if (kept.size() == triangles_.size()) return;
  std::vector<Edge> kept_edges = list_edges(kept, positions_.size(), execution);
  if (!closes(kept_edges, execution) && closes(edges, execution)) return;
  triangles_ = std::move(kept);
  edges = std::move(kept_edges);
}

void Surface::connect(const std::vector<Edge>& edges, Execution& execution)
{
  const std::size_t n = positions_.size();
  neighbour_start_.assign(n + 1, 0);
  for_each_in_order(edges.size(), execution, [&](std::size_t i) {
    const Edge& e = edges[i];
    report_.boundary_edges += e.forward + e.backward == 1;
    report_.inconsistent_edges += e.forward + e.backward > 1 && e.forward != e.backward;
    ++neighbour_start_[e.low + 1];
    ++neighbour_start_[e.high + 1];
  });
  for_each_in_order(n, execution, [&](std::size_t v) {
    report_.unreferenced_vertices += neighbour_start_[v + 1] == 0;
    neighbour_start_[v + 1] += neighbour_start_[v];
  });
  // Edges come ordered by (low, high), so every list fills in increasing order.
  resize_in_steps(neighbours_, 2 * edges.size(), execution);
  std::vector<std::uint32_t> next(neighbour_start_.begin(), neighbour_start_.end() - 1);
  for_each_in_order(edges.size(), execution, [&](std::size_t i) { neighbours_[next[edges[i].high]++] = edges[i].low; });
  for_each_in_order(edges.size(), execution, [&](std::size_t i) { neighbours_[next[edges[i].low]++] = edges[i].high; });
}

void Surface::turn_outward(Execution& execution)
{
  double six_volumes = 0, area = 0;
  for_each_in_order(triangles_.size(), execution, [&](std::size_t i) {
    const Triangle& t = triangles_[i];
    const Vec3 &a = positions_[t[0]], &b = positions_[t[1]], &c = positions_[t[2]];
    const Vec3 doubled_area = cross(b - a, c - a);
    report_.zero_area_triangles += squared_norm(doubled_area) == 0;
    six_volumes += dot(a, doubled_area);
    area += norm(doubled_area) / 2;
  });
  if (!(area > 0)) refuse_without_area();

  // A volume within rounding of zero, as of a sheet with two sides, has no inside.
  constexpr double rounding = 1e-10;
  report_.inside_out = is_closed() && six_volumes < -rounding * area * diagonal_;
  if (!report_.inside_out) return;
  for_each_index(triangles_.size(), execution, [&](std::size_t i) { std::swap(triangles_[i][1], triangles_[i][2]); });
}

}  // namespace integral_invariant
