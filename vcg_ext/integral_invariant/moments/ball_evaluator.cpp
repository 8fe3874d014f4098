// SPDX-License-Identifier: GPL-3.0-or-later
// Surface engine: the moments of all balls about one point of a neighbourhood.
#include "integral_invariant/moments/ball_evaluator.h"

#include <algorithm>

#include "integral_invariant/moments/sphere_cut.h"

namespace integral_invariant {

namespace {

constexpr double pi = 3.14159265358979323846;

/// Indices of a, b, c in increasing order, without a branch: comparisons of scales are as good as random.
inline const std::uint8_t* order_of(std::int64_t a, std::int64_t b, std::int64_t c)
{
  static constexpr std::uint8_t orders[8][4] = {{2, 1, 0}, {2, 0, 1}, {1, 2, 0}, {0, 1, 2},
                                                {0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {0, 1, 2}};
  return orders[unsigned(a <= b) | unsigned(b <= c) << 1 | unsigned(a <= c) << 2];
}

}  // namespace

BallEvaluator::BallEvaluator(const std::vector<double>& radii, bool same_sheet)
    : radii_(radii), scales_(std::uint32_t(radii.size())), same_sheet_(same_sheet), whole_count_(radii.size() + 1, 0),
      corners_(radii.size() + 1), corner_count_(radii.size(), 0)
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
  list_corners(near);
  for (std::uint32_t k = 0; k < scales_; ++k) add_listed_corners(near, k);
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
  std::array<std::uint32_t*, limits::max_scales + 1> whole;
  for (std::uint32_t k = 0; k <= scales_; ++k) whole[k] = whole_[k].data();
  const std::int64_t* scale = scale_of_.data();
  std::uint32_t *cut = cut_.data(), *count = whole_count_.data();
  std::size_t cut_count = 0;
  for (const LocalLeaf& leaf : near.leaves) {
    const double reach = radii_.back() + leaf.sphere.radius;
    if (squared_norm(leaf.sphere.centre - centre_) > reach * reach) continue;
    for (std::uint32_t i = leaf.begin; i < leaf.end; ++i) {
      const std::array<std::uint32_t, 3>& corner = near.corners[i].corner;
      const std::int64_t a = scale[corner[0]], b = scale[corner[1]], c = scale[corner[2]];
      const std::int64_t low = std::min(a, b), high = std::max(a, b);
      // Written in any case and counted where it applies: whether it does is as good as random.
      const std::int64_t median = std::max(low, std::min(high, c));
      whole[std::size_t(median)][count[std::size_t(median)]++] = i;
      cut[cut_count] = i;
      cut_count += (low != c) | (high != c);
    }
  }
  cut_count_ = cut_count;
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

void BallEvaluator::list_corners(const Neighbourhood& near)
{
  static constexpr std::uint32_t next[3] = {1, 2, 0}, previous[3] = {2, 0, 1};
  for (std::vector<LocalCorner>& list : corners_)
    if (list.size() <= cut_count_) list.resize(cut_count_ + 1);
  std::array<LocalCorner*, limits::max_scales + 1> end;
  for (std::uint32_t k = 0; k <= scales_; ++k) end[k] = corners_[k].data();
  const std::int64_t* scale = scale_of_.data();
  for (std::size_t i = 0; i < cut_count_; ++i) {
    const std::uint32_t triangle = cut_[i];
    const std::array<std::uint32_t, 3>& p = near.corners[triangle].corner;
    const std::int64_t s[3] = {scale[p[0]], scale[p[1]], scale[p[2]]};
    const std::uint8_t* order = order_of(s[0], s[1], s[2]);
    const std::int64_t least = s[order[0]], median = s[order[1]], most = s[order[2]];
    const auto list = [&](std::int64_t k) {
      const std::int32_t is_outside = k >= median;
      const std::uint32_t lone = order[2 * is_outside];
      *end[std::size_t(k)] = {p[lone], p[next[lone]], p[previous[lone]], 1 - 2 * is_outside, triangle};
      end[std::size_t(k)] += k < most ? 1 : 0;
    };
    // One or two scales as a rule, as good as at random: the second is written in any case and counted where it applies.
    list(least);
    list(least + 1);
    for (std::int64_t k = least + 2; k < most; ++k) list(k);
  }
  for (std::uint32_t k = 0; k < scales_; ++k) corner_count_[k] = std::uint32_t(end[k] - corners_[k].data());
}

void BallEvaluator::add_listed_corners(const Neighbourhood& near, std::uint32_t k)
{
  const bool is_wide = k < near.all_narrow_scale;
  const std::vector<LocalCorner>& list = corners_[k];
  for (std::uint32_t i = 0; i < corner_count_[k]; ++i) {
    batch_.push(point(list[i].lone), point(list[i].next), point(list[i].previous), list[i].sign);
    if (batch_.is_full()) add_corners(batch_, radii_[k], pole_, is_wide, cuts_[k]);
  }
  add_corners(batch_, radii_[k], pole_, is_wide, cuts_[k]);
  if (k >= near.all_small_scale) return;
  for (std::uint32_t i = 0; i < corner_count_[k]; ++i)
    if (k < near.corners[list[i].triangle].first_small_scale) add_curved_corner(list[i], k);
}

void BallEvaluator::add_curved_corner(const LocalCorner& corner, std::uint32_t k)
{
  const Vec3 a = point(corner.lone), b = point(corner.next), c = point(corner.previous);
  const double radius = radii_[k];
  const Vec3 p = a + (b - a) * edge_crossing(a, b, radius), q = a + (c - a) * edge_crossing(a, c, radius);
  cuts_[k].moments += curved_excess({a, b, c}, radius, 0, corner.sign > 0, {p, q});
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
    missing.angle += shell_missing_[k].angle;
    missing.moment += shell_missing_[k].moment;
    moments_[k] = ball_moments(inside + cuts_[k].moments, all.terms(), all.half_area() + cuts_[k].half_area, radii_[k]);
    const double area = squared_radii_[k] * (missing.angle + cut_missing_[k].angle) - missing.moment - cut_missing_[k].moment;
    moments_[k].confidence = std::clamp(1 - area / (2 * pi * squared_radii_[k]), 0.0, 1.0);
  }
}

}  // namespace integral_invariant
