// SPDX-License-Identifier: GPL-3.0-or-later
// Surface engine: the moments of all balls about one point of a neighbourhood.
#include "integral_invariant/moments/ball_evaluator.h"

#include <algorithm>

#include "integral_invariant/moments/sphere_cut.h"

namespace integral_invariant {

namespace {

constexpr double pi = 3.14159265358979323846;

}  // namespace

BallEvaluator::BallEvaluator(const std::vector<double>& radii, bool same_sheet)
    : radii_(radii), scales_(std::uint32_t(radii.size())), same_sheet_(same_sheet), whole_count_(radii.size() + 1, 0),
      batches_(radii.size()), is_wide_(radii.size(), 0)
{
  for (const double r : radii) squared_radii_.push_back(r * r);
}

const std::vector<BallMoments>& BallEvaluator::evaluate(const Neighbourhood& near, std::uint32_t centre,
                                                        const Vec3& normal, bool is_border)
{
  clear();
  is_border_ = is_border;
  normal_ = normal;
  centre_ = near.point(centre);
  // Off the normal by an odd angle: what is axis-aligned then does not meet the pole's opposite.
  pole_ = normalized(normal + Vec3{0.0471, 0.0333, 0.0189});
  place(near);
  if (same_sheet_) keep_own_sheet(near, centre);
  for (std::uint32_t k = 0; k < scales_; ++k)
    if (near.has_far[k]) shells_[k] += cone_moments(near.far[k], -centre_);
  sort_triangles(near);
  add_whole_triangles(near);
  for (std::size_t i = 0; i < cut_count_; ++i) add_cut(near.corners[cut_[i]]);
  for (const std::uint32_t i : near.large) add_large(near.corners[i], near.triangles[i]);
  add_free_edges(near);
  finish();
  return moments_;
}

void BallEvaluator::clear()
{
  shells_.assign(scales_, {});
  cuts_.assign(scales_, {});
  shell_arcs_.assign(scales_, {});
  cut_arcs_.assign(scales_, {});
  shell_missing_.assign(scales_, {});
  cut_missing_.assign(scales_, {});
  rays_.clear();
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

void BallEvaluator::sort_triangles(const Neighbourhood& near)
{
  const std::size_t size = near.corners.size();
  whole_.resize(scales_ + 1);
  for (std::vector<std::uint32_t>& list : whole_)
    if (list.size() < size) list.resize(size);
  if (cut_.size() < size) cut_.resize(size);
  std::fill(whole_count_.begin(), whole_count_.end(), 0);
  cut_count_ = 0;
  for (const LocalLeaf& leaf : near.leaves) {
    const double reach = radii_.back() + leaf.sphere.radius;
    if (squared_norm(leaf.sphere.centre - centre_) > reach * reach) continue;
    for (std::uint32_t i = leaf.begin; i < leaf.end; ++i) {
      const std::array<std::uint32_t, 3>& corner = near.corners[i].corner;
      const std::int64_t a = scale_of_[corner[0]], b = scale_of_[corner[1]], c = scale_of_[corner[2]];
      const std::int64_t low = std::min(a, b), high = std::max(a, b);
      // Written in any case and counted where it applies: whether it does is as good as random.
      const std::int64_t median = std::max(low, std::min(high, c));
      whole_[std::size_t(median)][whole_count_[std::size_t(median)]++] = i;
      cut_[cut_count_] = i;
      cut_count_ += (low != c) | (high != c);
    }
  }
}

void BallEvaluator::add_whole_triangles(const Neighbourhood& near)
{
  for (std::uint32_t k = 0; k < scales_; ++k) {
    // From its second vertex's scale on a triangle counts as whole, less the corner that is still outside.
    MomentSums sum;
    for (std::uint32_t i = 0; i < whole_count_[k]; ++i) {
      const LocalTriangle& t = near.triangles[whole_[k][i]];
      const Vec3 y = t.centroid - centre_;
      const double det = dot(t.doubled_area, y);
      sum.volume += det;
      sum.first += y * det;
      sum.second += (t.spread + outer(y)) * det;
    }
    shells_[k] += {sum.volume * (1.0 / 6), sum.first * 0.125, sum.second * 0.1};
  }
}

void BallEvaluator::add_cut(const LocalCorners& corners)
{
  const std::uint32_t s[3] = {std::uint32_t(scale_of_[corners.corner[0]]), std::uint32_t(scale_of_[corners.corner[1]]),
                              std::uint32_t(scale_of_[corners.corner[2]])};
  const std::uint32_t least = std::min({s[0], s[1], s[2]}), most = std::max({s[0], s[1], s[2]});
  const std::uint32_t median = s[0] + s[1] + s[2] - least - most;
  const int nearest = s[0] == least ? 0 : s[1] == least ? 1 : 2;
  const int farthest = s[2] == most ? 2 : s[1] == most ? 1 : 0;
  for (std::uint32_t k = least; k < median; ++k) add_corner(corners, nearest, k, true);
  for (std::uint32_t k = median; k < most; ++k) add_corner(corners, farthest, k, false);
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
  const std::array<Vec3, 3> v = {point(corners.corner[0]), point(corners.corner[1]), point(corners.corner[2])};
  if (distance >= radii_[end_scale - 1] || (is_border_ && touches_centre(v))) return;
  std::int64_t first_scale = 0;
  if (same_sheet_) {
    // The triangle belongs to the sheet where it shares an edge with a triangle that does.
    std::int64_t rim[3] = {rim_scale_[corners.corner[0]], rim_scale_[corners.corner[1]], rim_scale_[corners.corner[2]]};
    std::sort(rim, rim + 3);
    first_scale = rim[1];
  }
  for (std::uint32_t k = std::uint32_t(first_scale); k < end_scale; ++k)
    if (distance < radii_[k]) cuts_[k].moments += curved_excess(v, radii_[k], -1, false, {});
}

void BallEvaluator::flush(std::uint32_t scale)
{
  add_corners(batches_[scale], radii_[scale], pole_, is_wide_[scale] != 0, cuts_[scale]);
  is_wide_[scale] = 0;
}

void BallEvaluator::finish()
{
  moments_.resize(scales_);
  MomentSums inside;
  MissingSurface missing;
  ArcSums arcs;
  for (std::uint32_t k = 0; k < scales_; ++k) {
    inside += shells_[k];
    arcs += shell_arcs_[k];
    ArcSums all = arcs;
    all += cut_arcs_[k];
    flush(k);
    missing.angle += shell_missing_[k].angle;
    missing.moment += shell_missing_[k].moment;
    moments_[k] = ball_moments(inside + cuts_[k].moments, all.terms(), all.half_area() + cuts_[k].half_area, radii_[k]);
    const double area = squared_radii_[k] * (missing.angle + cut_missing_[k].angle) - missing.moment - cut_missing_[k].moment;
    moments_[k].confidence = std::clamp(1 - area / (2 * pi * squared_radii_[k]), 0.0, 1.0);
  }
}

}  // namespace integral_invariant
