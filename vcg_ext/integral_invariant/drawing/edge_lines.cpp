// SPDX-License-Identifier: GPL-3.0-or-later
// Chains of edges of the mesh. Cost: O(m).
#include "integral_invariant/drawing/edge_lines.h"

#include <algorithm>
#include <cmath>

#include "integral_invariant/support/pi.h"

namespace integral_invariant {

namespace {

struct MarkedEdge {
  std::int32_t a, b;
  double significance, strength;
};

/// Joins edges to lines that run through vertices with exactly two of them.
class EdgeChainer {
 public:
  EdgeChainer(const std::vector<MarkedEdge>& edges, const DifferentiatedField& field, const std::vector<Vec3>& place,
              LineKind kind)
      : edges_(edges), field_(field), place_(place), kind_(kind), at_(field.size()), used_(edges.size())
  {
    for (std::size_t e = 0; e < edges.size(); ++e)
      for (const std::int32_t v : {edges[e].a, edges[e].b}) at_[v].push_back(std::int32_t(e));
  }

  std::vector<SurfaceLine> lines()
  {
    std::vector<SurfaceLine> lines;
    for (std::size_t e = 0; e < edges_.size(); ++e)  // first those that begin at an end or a junction, then loops
      for (const std::int32_t v : {edges_[e].a, edges_[e].b})
        if (!used_[e] && at_[v].size() != 2) lines.push_back(line_from(v, std::int32_t(e)));
    for (std::size_t e = 0; e < edges_.size(); ++e)
      if (!used_[e]) lines.push_back(line_from(edges_[e].a, std::int32_t(e)));
    return lines;
  }

 private:
  SurfaceLine line_from(std::int32_t vertex, std::int32_t edge)
  {
    SurfaceLine line{kind_, {}, false};
    const std::int32_t start = vertex;
    line.points.push_back(point(vertex, edges_[edge]));
    while (edge >= 0) {
      used_[edge] = 1;
      vertex = edges_[edge].a == vertex ? edges_[edge].b : edges_[edge].a;
      line.points.push_back(point(vertex, edges_[edge]));
      std::int32_t next = -1;
      if (at_[vertex].size() == 2)
        for (const std::int32_t e : at_[vertex])
          if (!used_[e]) next = e;
      edge = next;
    }
    if (vertex == start && line.points.size() > 3) {
      line.points.pop_back();
      line.closed = true;
    }
    return line;
  }

  LinePoint point(std::int32_t v, const MarkedEdge& edge) const
  {
    return {place_[v], field_.curvature.normal[v], edge.significance, edge.strength};
  }

  const std::vector<MarkedEdge>& edges_;
  const DifferentiatedField& field_;
  const std::vector<Vec3>& place_;
  LineKind kind_;
  std::vector<std::vector<std::int32_t>> at_;  ///< marked edges of each vertex
  std::vector<char> used_;
};

std::vector<SurfaceLine> kept_lines(const std::vector<MarkedEdge>& edges, const DifferentiatedField& field,
                                    const std::vector<Vec3>& place, LineKind kind, const LineSelection& selection)
{
  std::vector<SurfaceLine> kept;
  for (const SurfaceLine& line : EdgeChainer(edges, field, place, kind).lines())
    keep_significant(line, selection, kept);
  return kept;
}

}  // namespace

std::vector<SurfaceLine> boundary_lines(const Surface& surface, const Topology& topology,
                                        const DifferentiatedField& field, const LineSelection& selection,
                                        Execution& execution)
{
  std::vector<char> count(topology.edge_count);
  for (const auto& sides : topology.edge)
    for (const std::int32_t e : sides) count[e] = char(std::min(3, count[e] + 1));
  std::vector<MarkedEdge> edges;
  for_each_in_order(surface.triangles().size(), execution, [&](std::size_t t) {
    for (int i = 0; i < 3; ++i)
      if (count[topology.edge[t][i]] == 1)
        edges.push_back({surface.triangles()[t][i], surface.triangles()[t][(i + 1) % 3], largest_significance, 0});
  });
  return kept_lines(edges, field, field.position, LineKind::boundary, selection);
}

std::vector<SurfaceLine> crease_lines(const Surface& surface, const Topology& topology,
                                      const DifferentiatedField& field, double angle, double noise,
                                      const LineSelection& selection, Execution& execution)
{
  // Two equilateral triangles with independent errors along the normal at their four vertices: the angle has the error
  // of (z₁ + z₂) / h − (z₃ + z₄) / h with the height h = √3/2.
  const double error = noise * 2 / std::sqrt(0.75);
  const double least = angle * pi / 180;
  std::vector<MarkedEdge> edges;
  for_each_in_order(surface.triangles().size(), execution, [&](std::size_t t) {
    for (int i = 0; i < 3; ++i) {
      const std::int32_t other = topology.across[t][i];
      if (other < std::int32_t(t)) continue;
      const TriangleFrame a(surface.triangles()[t], surface.positions());
      const TriangleFrame b(surface.triangles()[other], surface.positions());
      if (!(a.doubled_area > 0) || !(b.doubled_area > 0)) continue;
      const double bend = std::acos(std::clamp(dot(a.normal, b.normal), -1.0, 1.0));
      const double z = error > 0 ? std::min(bend / error, largest_significance) : largest_significance;
      if (bend > least && z > selection.significance)
        edges.push_back({surface.triangles()[t][i], surface.triangles()[t][(i + 1) % 3], z, bend});
    }
  });
  // On the vertices themselves: a fit would round the crease.
  return kept_lines(edges, field, surface.positions(), LineKind::crease, selection);
}

}  // namespace integral_invariant
