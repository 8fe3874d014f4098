// SPDX-License-Identifier: GPL-3.0-or-later
// Surface engine: what boundary edges add to the balls about one point, and the point's own sheet.
//
// Where the surface ends inside the ball it is continued by rays away from the centre: such a wall has no flux, and on
// the sphere its trace is the edge's projection. At the centre itself the tangent plane closes the fan.
#include <algorithm>
#include <cmath>

#include "integral_invariant/moments/surface/ball_evaluator.h"
#include "integral_invariant/moments/surface/sphere_clip.h"

namespace integral_invariant {

void BallEvaluator::add_boundary_edges(const InteractionList& near)
{
  for (const LocalBoundaryEdge& edge : near.close_boundary_edges) {
    const Vec3 a = point(edge.from), b = point(edge.to);
    if (squared_norm(a) == 0 || squared_norm(b) == 0 || (is_border_ && passes_origin(a, b)))
      add_ray(edge);
    else if (edge.stands_for > 0 && std::min(scale_of_[edge.from], scale_of_[edge.to]) < scales_)
      add_boundary_edge(edge);
  }
  if (!rays_.empty()) close_surface();
}

void BallEvaluator::add_boundary_edge(const LocalBoundaryEdge& edge)
{
  const Vec3 a = point(edge.from), b = point(edge.to);
  const std::uint32_t from = scale_of_[edge.from], to = scale_of_[edge.to];
  const double sign = boundary_side(edge.surplus, a, b, point(edge.opposite)) * edge.stands_for;
  const double times = double(edge.surplus) * edge.stands_for;
  const auto add = [&](const Vec3& start, const Vec3& end, ArcSums& arcs, MissingArea& missing) {
    arcs.add(normalized(start), normalized(end), times, pole_);
    missing.add(start, end, sign);
  };
  for (std::uint32_t k = std::min(from, to); k < std::min(std::max(from, to), cut_scales_); ++k) {
    const Vec3 cut =
        from < to ? a + (b - a) * edge_crossing(a, b, radii_[k]) : b + (a - b) * edge_crossing(b, a, radii_[k]);
    add(from < to ? a : cut, from < to ? cut : b, cut_arcs_[k], cut_missing_[k]);
  }
  const std::uint32_t whole = std::max(from, to);
  if (whole < scales_) add(a, b, shell_arcs_[whole], shell_missing_[whole]);
}

void BallEvaluator::add_ray(const LocalBoundaryEdge& edge)
{
  const Vec3 a = point(edge.from), b = point(edge.to);
  const std::uint32_t first = std::min(scale_of_[edge.from], scale_of_[edge.to]);
  for (std::int32_t i = 0; i < edge.surplus; ++i) {
    if (squared_norm(a) > 0) rays_.push_back({{normalized(a), true}, first});
    if (squared_norm(b) > 0) rays_.push_back({{normalized(b), false}, first});
  }
}

void BallEvaluator::close_surface()
{
  std::vector<FanRay> rays;
  for (std::uint32_t k = 0; k < scales_; ++k) {
    rays.clear();
    for (const auto& ray : rays_)
      if (ray.second <= k) rays.push_back(ray.first);
    double gap = 0;
    for (const auto& arc : close_fans(rays, normal_, gap)) cut_arcs_[k].add(arc.first, arc.second, 1, pole_);
    cut_missing_[k].angle += gap;
  }
}

bool BallEvaluator::touches_centre(const std::array<Vec3, 3>& t) const
{
  const Vec3 normal = cross(t[1] - t[0], t[2] - t[0]);
  const double area2 = squared_norm(normal), edge2 = squared_norm(t[1] - t[0]) + squared_norm(t[2] - t[0]);
  const double height = dot(normal, t[0]);
  if (height * height > touching * touching * edge2 * area2) return false;
  for (int i = 0; i < 3; ++i)
    if (dot(normal, cross(t[i], t[(i + 1) % 3])) < -touching * area2) return false;
  return true;
}

void BallEvaluator::keep_own_sheet(const InteractionList& near, std::uint32_t centre)
{
  // A point is reached at the largest scale that any path to it along edges needs, over the path that needs least.
  own_scale_.assign(scale_of_.size(), std::uint8_t(scales_));
  queue_.resize(scales_);
  own_scale_[centre] = 0;
  queue_[0].assign(1, centre);
  for (std::uint32_t k = 0; k < scales_; ++k) {
    for (std::size_t i = 0; i < queue_[k].size(); ++i) {
      const std::uint32_t p = queue_[k][i];
      if (own_scale_[p] != k) continue;
      for (std::uint32_t n = near.neighbour_start[p]; n < near.neighbour_start[p + 1]; ++n) {
        const std::uint32_t q = near.neighbours[n];
        const std::uint8_t reached = std::max(std::uint8_t(k), scale_of_[q]);
        if (reached >= own_scale_[q]) continue;
        own_scale_[q] = reached;
        queue_[reached].push_back(q);
      }
    }
    queue_[k].clear();
  }
  scale_of_.swap(own_scale_);
  rim_scale_ = scale_of_;
  for (const LocalCorners& t : near.corners) {
    const std::uint8_t least = std::min({scale_of_[t.ring[0]], scale_of_[t.ring[1]], scale_of_[t.ring[2]]});
    for (int i = 0; i < 3; ++i) rim_scale_[t.ring[i]] = std::min(rim_scale_[t.ring[i]], least);
  }
}

}  // namespace integral_invariant
