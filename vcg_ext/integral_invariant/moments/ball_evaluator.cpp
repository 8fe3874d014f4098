// SPDX-License-Identifier: GPL-3.0-or-later
// Surface engine: the moments of all balls about one point of a neighbourhood.
#include "integral_invariant/moments/ball_evaluator.h"

#include <algorithm>

#include "integral_invariant/moments/sphere_cut.h"

namespace integral_invariant {

BallEvaluator::BallEvaluator(const std::vector<double>& radii) : radii_(radii), scales_(std::uint32_t(radii.size())) {}

const std::vector<BallMoments>& BallEvaluator::evaluate(const Neighbourhood& near, std::uint32_t centre,
                                                        const Vec3& normal, bool)
{
  clear();
  centre_ = near.point(centre);
  // Off the normal by an odd angle: what is axis-aligned then does not meet the pole's opposite.
  pole_ = normalized(normal + Vec3{0.0471, 0.0333, 0.0189});
  place_points(near);
  for (std::uint32_t k = 0; k < scales_; ++k)
    if (near.has_far[k]) shells_[k] += cone_moments(near.far[k], -centre_);
  for (const LocalTriangle& triangle : near.triangles) add_triangle(triangle);
  for (const LocalFreeEdge& edge : near.free_edges) add_free_edge(edge);
  finish();
  return moments_;
}

void BallEvaluator::clear()
{
  shells_.assign(scales_, {});
  cuts_.assign(scales_, {});
  shell_arcs_.assign(scales_, {});
  cut_arcs_.assign(scales_, {});
}

void BallEvaluator::place_points(const Neighbourhood& near)
{
  points_.resize(near.x.size());
  scale_of_.resize(near.x.size());
  for (std::size_t i = 0; i < near.x.size(); ++i) {
    points_[i] = near.point(std::uint32_t(i)) - centre_;
    const double d2 = squared_norm(points_[i]);
    std::uint8_t scale = 0;
    for (const double r : radii_) scale = std::uint8_t(scale + (d2 > r * r));
    scale_of_[i] = scale;
  }
}

void BallEvaluator::add_triangle(const LocalTriangle& t)
{
  const std::uint32_t s[3] = {scale_of_[t.corner[0]], scale_of_[t.corner[1]], scale_of_[t.corner[2]]};
  const int nearest = s[0] <= s[1] ? (s[0] <= s[2] ? 0 : 2) : (s[1] <= s[2] ? 1 : 2);
  const int farthest = s[(nearest + 1) % 3] >= s[(nearest + 2) % 3] ? (nearest + 1) % 3 : (nearest + 2) % 3;
  const std::uint32_t median = s[3 - nearest - farthest];
  if (t.first_small_scale > 0) add_large(t, 0, std::min(s[nearest], t.first_small_scale));
  if (s[nearest] == scales_) return;

  if (median < scales_) {
    // From its second vertex's scale on the triangle counts as whole, less the corner that is still outside.
    const Vec3 y = t.centroid - centre_;
    const double det = dot(t.doubled_area, y);
    shells_[median] += {det / 6, y * (det / 8), t.spread * (det / 120) + outer(y) * (det / 10)};
  }
  for (std::uint32_t k = s[nearest]; k < s[farthest]; ++k)
    add_corner(t, k < median ? nearest : farthest, k, k < median);
}

void BallEvaluator::add_corner(const LocalTriangle& t, int lone, std::uint32_t k, bool lone_is_inside)
{
  const Vec3 &a = points_[t.corner[lone]], &b = points_[t.corner[(lone + 1) % 3]], &c = points_[t.corner[(lone + 2) % 3]];
  const double radius = radii_[k], sign = lone_is_inside ? 1 : -1;
  const Vec3 p = a + (b - a) * edge_crossing(a, b, radius), q = a + (c - a) * edge_crossing(a, c, radius);
  cuts_[k] += cone_moments(a, p, q) * sign;
  cut_arcs_[k].add(p * (1 / radius), q * (1 / radius), sign, pole_);
  if (k < t.first_small_scale)
    cuts_[k] += curved_excess({points_[t.corner[0]], points_[t.corner[1]], points_[t.corner[2]]}, radius, lone,
                              lone_is_inside, {p, q});
}

void BallEvaluator::add_large(const LocalTriangle& t, std::uint32_t first_scale, std::uint32_t end_scale)
{
  const std::array<Vec3, 3> corners = {points_[t.corner[0]], points_[t.corner[1]], points_[t.corner[2]]};
  for (std::uint32_t k = first_scale; k < end_scale; ++k) cuts_[k] += curved_excess(corners, radii_[k], -1, false, {});
}

void BallEvaluator::add_free_edge(const LocalFreeEdge& edge)
{
  const Vec3 &a = points_[edge.from], &b = points_[edge.to];
  const std::uint32_t from = scale_of_[edge.from], to = scale_of_[edge.to];
  if (squared_norm(a) == 0 || squared_norm(b) == 0) return;  // radial: no arc
  for (std::uint32_t k = std::min(from, to); k < std::max(from, to); ++k) {
    const Vec3 cut = a + (b - a) * (from < to ? edge_crossing(a, b, radii_[k]) : 1 - edge_crossing(b, a, radii_[k]));
    const Vec3 direction = normalized(cut);
    if (from < to)
      cut_arcs_[k].add(normalized(a), direction, edge.surplus, pole_);
    else
      cut_arcs_[k].add(direction, normalized(b), edge.surplus, pole_);
  }
  if (std::max(from, to) < scales_)
    shell_arcs_[std::max(from, to)].add(normalized(a), normalized(b), edge.surplus, pole_);
}

void BallEvaluator::finish()
{
  moments_.resize(scales_);
  MomentSums inside;
  ArcSums arcs;
  for (std::uint32_t k = 0; k < scales_; ++k) {
    inside += shells_[k];
    arcs += shell_arcs_[k];
    ArcSums all = arcs;
    all += cut_arcs_[k];
    moments_[k] = ball_moments(inside + cuts_[k], all, radii_[k]);
  }
}

}  // namespace integral_invariant
