// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/mesh_processing.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "integral_invariant/support/pi.h"

namespace accuracy {

using namespace integral_invariant;

namespace {

struct SharedEdge {
  int a = 0, b = 0, middle = 0;
  std::vector<int> opposite;  ///< corners across it: one on a rim
};

using Edges = std::map<std::pair<int, int>, SharedEdge>;

std::pair<int, int> key(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

/// Every edge, with the number that its middle has after subdivision.
Edges edges_of(const TriangleMesh& mesh)
{
  Edges edges;
  int next = int(mesh.positions.size());
  for (const Triangle& t : mesh.triangles)
    for (std::size_t c = 0; c < 3; ++c) {
      const auto [it, is_new] = edges.try_emplace(key(t[c], t[(c + 1) % 3]));
      if (is_new) it->second = {it->first.first, it->first.second, next++, {}};
      it->second.opposite.push_back(t[(c + 2) % 3]);
    }
  return edges;
}

bool is_rim(const SharedEdge& edge) { return edge.opposite.size() != 2; }

std::vector<bool> rim_vertices(const TriangleMesh& mesh, const Edges& edges)
{
  std::vector<bool> on_rim(mesh.positions.size());
  for (const auto& entry : edges)
    if (is_rim(entry.second)) on_rim[std::size_t(entry.second.a)] = on_rim[std::size_t(entry.second.b)] = true;
  return on_rim;
}

std::vector<Triangle> quartered(const TriangleMesh& mesh, const Edges& edges)
{
  std::vector<Triangle> triangles;
  for (const Triangle& t : mesh.triangles) {
    const int a = edges.at(key(t[0], t[1])).middle, b = edges.at(key(t[1], t[2])).middle,
              c = edges.at(key(t[2], t[0])).middle;
    triangles.insert(triangles.end(), {{t[0], a, c}, {a, t[1], b}, {c, b, t[2]}, {a, b, c}});
  }
  return triangles;
}

/// Sum and number of the neighbours of every vertex; boundary vertices only count neighbours along the boundary.
struct NeighbourSums {
  std::vector<Vec3> sum;
  std::vector<int> count;
};

NeighbourSums neighbour_sums(const TriangleMesh& mesh, const Edges& edges, const std::vector<bool>& on_rim)
{
  const std::size_t n = mesh.positions.size();
  NeighbourSums sums{std::vector<Vec3>(n), std::vector<int>(n)};
  const auto add = [&](int to, int from, bool along_rim) {
    if (on_rim[std::size_t(to)] && !along_rim) return;
    sums.sum[std::size_t(to)] += mesh.positions[std::size_t(from)];
    ++sums.count[std::size_t(to)];
  };
  for (const auto& entry : edges) {
    const SharedEdge& e = entry.second;
    add(e.a, e.b, is_rim(e));
    add(e.b, e.a, is_rim(e));
  }
  return sums;
}

/// Each triangle into four; the new vertices are the edges' middles.
TriangleMesh quartered_at_midpoints(const TriangleMesh& mesh, const Edges& edges)
{
  TriangleMesh fine{mesh.positions, quartered(mesh, edges)};
  fine.positions.resize(mesh.positions.size() + edges.size());
  for (const auto& entry : edges) {
    const SharedEdge& e = entry.second;
    fine.positions[std::size_t(e.middle)] = (mesh.positions[std::size_t(e.a)] + mesh.positions[std::size_t(e.b)]) * 0.5;
  }
  return fine;
}

}  // namespace

void smooth(TriangleMesh& mesh, double factor)
{
  const Edges edges = edges_of(mesh);
  const std::vector<bool> on_rim = rim_vertices(mesh, edges);
  const NeighbourSums sums = neighbour_sums(mesh, edges, on_rim);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    if (!on_rim[v] && sums.count[v] > 0)
      mesh.positions[v] += (sums.sum[v] * (1.0 / sums.count[v]) - mesh.positions[v]) * factor;
}

TriangleMesh midpoint_subdivided(const TriangleMesh& mesh) { return quartered_at_midpoints(mesh, edges_of(mesh)); }

TriangleMesh loop_subdivided(const TriangleMesh& mesh)
{
  const Edges edges = edges_of(mesh);
  TriangleMesh fine = quartered_at_midpoints(mesh, edges);
  for (const auto& entry : edges) {
    const SharedEdge& e = entry.second;
    if (is_rim(e)) continue;
    Vec3& middle = fine.positions[std::size_t(e.middle)];
    middle = middle * (3.0 / 4) +
             (mesh.positions[std::size_t(e.opposite[0])] + mesh.positions[std::size_t(e.opposite[1])]) * (1.0 / 8);
  }
  const std::vector<bool> on_rim = rim_vertices(mesh, edges);
  const NeighbourSums sums = neighbour_sums(mesh, edges, on_rim);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const int n = sums.count[v];
    if (n == 0) continue;
    const double loop = std::pow(3.0 / 8 + std::cos(2 * pi / n) / 4, 2);
    const double all_neighbours = on_rim[v] ? 1.0 / 4 : 5.0 / 8 - loop;
    fine.positions[v] = mesh.positions[v] * (1 - all_neighbours) + sums.sum[v] * (all_neighbours / n);
  }
  return fine;
}

}  // namespace accuracy
