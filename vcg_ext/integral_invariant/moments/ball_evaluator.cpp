// SPDX-License-Identifier: GPL-3.0-or-later
// Surface engine: the moments of all balls about one point of a neighbourhood.
#include "integral_invariant/moments/ball_evaluator.h"

#include <algorithm>

#include "integral_invariant/moments/sphere_cut.h"

namespace integral_invariant {

BallEvaluator::BallEvaluator(const std::vector<double>& radii)
    : radii_(radii), scales_(std::uint32_t(radii.size())), batches_(radii.size()), is_wide_(radii.size(), 0)
{
  for (const double r : radii) squared_radii_.push_back(r * r);
}

const std::vector<BallMoments>& BallEvaluator::evaluate(const Neighbourhood& near, std::uint32_t centre,
                                                        const Vec3& normal, bool)
{
  clear();
  centre_ = near.point(centre);
  // Off the normal by an odd angle: what is axis-aligned then does not meet the pole's opposite.
  pole_ = normalized(normal + Vec3{0.0471, 0.0333, 0.0189});
  place(near);
  for (std::uint32_t k = 0; k < scales_; ++k)
    if (near.has_far[k]) shells_[k] += cone_moments(near.far[k], -centre_);
  for (std::size_t i = 0; i < near.corners.size(); ++i) add_triangle(near.corners[i], near.triangles[i]);
  for (const std::uint32_t i : near.large) add_large(near.corners[i], near.triangles[i]);
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

void BallEvaluator::place(const Neighbourhood& near)
{
  const std::size_t size = near.x.size();
  x_.resize(size);
  y_.resize(size);
  z_.resize(size);
  scale_of_.resize(size);
  place_points(near.x.data(), near.y.data(), near.z.data(), size, centre_, squared_radii_, x_.data(), y_.data(),
               z_.data(), scale_of_.data());
}

void BallEvaluator::add_triangle(const LocalCorners& corners, const LocalTriangle& triangle)
{
  const std::uint32_t s[3] = {std::uint32_t(scale_of_[corners.corner[0]]), std::uint32_t(scale_of_[corners.corner[1]]),
                              std::uint32_t(scale_of_[corners.corner[2]])};
  const std::uint32_t least = std::min({s[0], s[1], s[2]}), most = std::max({s[0], s[1], s[2]});
  if (least == scales_) return;

  // From its second vertex's scale on the triangle counts as whole, less the corner that is still outside.
  const std::uint32_t median = s[0] + s[1] + s[2] - least - most;
  if (median < scales_) add_whole(triangle, median);
  if (least == most) return;
  const int nearest = s[0] == least ? 0 : s[1] == least ? 1 : 2;
  const int farthest = s[2] == most ? 2 : s[1] == most ? 1 : 0;
  for (std::uint32_t k = least; k < median; ++k) add_corner(corners, nearest, k, true);
  for (std::uint32_t k = median; k < most; ++k) add_corner(corners, farthest, k, false);
}

void BallEvaluator::add_whole(const LocalTriangle& t, std::uint32_t scale)
{
  const Vec3 y = t.centroid - centre_;
  const double det = dot(t.doubled_area, y);
  shells_[scale] += {det * (1.0 / 6), y * (det * 0.125), t.spread * (det * (1.0 / 120)) + outer(y) * (det * 0.1)};
}

void BallEvaluator::add_corner(const LocalCorners& t, int lone, std::uint32_t k, bool lone_is_inside)
{
  const int next = lone == 2 ? 0 : lone + 1, previous = lone == 0 ? 2 : lone - 1;
  const Vec3 a = point(t.corner[lone]), b = point(t.corner[next]), c = point(t.corner[previous]);
  batches_[k].push(a, b, c, lone_is_inside ? 1 : -1);
  if (k < t.first_narrow_scale) is_wide_[k] = 1;
  if (k < t.first_small_scale) {
    const double radius = radii_[k];
    const Vec3 p = a + (b - a) * edge_crossing(a, b, radius), q = a + (c - a) * edge_crossing(a, c, radius);
    cuts_[k].moments += curved_excess({a, b, c}, radius, 0, lone_is_inside, {p, q});
  }
  if (batches_[k].is_full()) flush(k);
}

void BallEvaluator::add_large(const LocalCorners& corners, const LocalTriangle& triangle)
{
  std::uint32_t end_scale = corners.first_small_scale;
  for (const std::uint32_t corner : corners.corner) end_scale = std::min(end_scale, std::uint32_t(scale_of_[corner]));
  if (end_scale == 0) return;
  // No point of a triangle is farther from its centroid than two thirds of the longest edge.
  const double distance = norm(triangle.centroid - centre_) - triangle.longest_edge * (2.0 / 3);
  for (std::uint32_t k = 0; k < end_scale; ++k)
    if (distance < radii_[k])
      cuts_[k].moments += curved_excess({point(corners.corner[0]), point(corners.corner[1]), point(corners.corner[2])},
                                        radii_[k], -1, false, {});
}

void BallEvaluator::flush(std::uint32_t scale)
{
  add_corners(batches_[scale], radii_[scale], pole_, is_wide_[scale] != 0, cuts_[scale]);
  is_wide_[scale] = 0;
}

void BallEvaluator::add_free_edge(const LocalFreeEdge& edge)
{
  const Vec3 a = point(edge.from), b = point(edge.to);
  const std::uint32_t from = std::uint32_t(scale_of_[edge.from]), to = std::uint32_t(scale_of_[edge.to]);
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
    flush(k);
    moments_[k] = ball_moments(inside + cuts_[k].moments, all.terms(), all.half_area() + cuts_[k].half_area, radii_[k]);
  }
}

}  // namespace integral_invariant
