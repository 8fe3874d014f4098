// SPDX-License-Identifier: GPL-3.0-or-later
// Surface engine: the moments of all balls about one point of a neighbourhood.
#include "integral_invariant/moments/surface/ball_evaluator.h"

#include <algorithm>

#include "integral_invariant/moments/surface/sphere_clip.h"

namespace integral_invariant {

BallEvaluator::BallEvaluator(const std::vector<double>& radii, bool same_sheet, LastRadius last_radius)
    : radii_(radii),
      scales_(std::uint32_t(radii.size())),
      cut_scales_(last_radius == LastRadius::rim ? scales_ - 1 : scales_),
      same_sheet_(same_sheet),
      whole_count_(radii.size() + 1, 0),
      corners_(radii.size() + 2),
      corner_count_(radii.size(), 0)
{
  for (const double r : radii) squared_radii_.push_back(r * r);
  tabulate_scales();
}

void BallEvaluator::tabulate_scales()
{
  for (std::uint32_t a = 0; a <= scales_; ++a)
    for (std::uint32_t b = 0; b <= scales_; ++b)
      for (std::uint32_t c = 0; c <= scales_; ++c) {
        const std::uint32_t scale[3] = {a, b, c};
        std::uint32_t vertex[3] = {0, 1, 2};
        std::stable_sort(vertex, vertex + 3, [&](std::uint32_t i, std::uint32_t j) { return scale[i] < scale[j]; });
        const std::uint32_t least = scale[vertex[0]], median = scale[vertex[1]], most = scale[vertex[2]];
        const auto corner = [&](std::uint32_t k) {
          return std::uint8_t(k < median ? 2 * vertex[0] : 2 * vertex[2] + 1);
        };
        scales_table_.push_back({std::uint8_t(least), std::uint8_t(median), std::uint8_t(most), corner(least),
                                 corner(least + 1), least < most, least + 1 < most, corner(scales_)});
      }
}

const std::vector<BallMoments>& BallEvaluator::evaluate(const InteractionList& near, CulledInteractions& vicinity,
                                                        std::uint32_t centre, const Vec3& normal, bool is_border)
{
  clear();
  is_border_ = is_border;
  normal_ = normal;
  centre_ = near.point(centre);
  // Off the normal by an odd angle: what is axis-aligned then does not meet the pole's opposite.
  pole_ = normalized(normal + Vec3{0.0471, 0.0333, 0.0189});
  near_ = &near;
  vicinity.centre_on(centre, scale_of_);
  if (same_sheet_) keep_own_sheet(near, centre);
  for (std::uint32_t k = 0; k < scales_; ++k)
    if (vicinity.has_far(k)) shells_[k] += cone_moments(vicinity.far(k), -centre_);
  find_triangle_scales(near, vicinity);
  sort_triangles();
  add_whole_triangles(near);
  for (std::uint32_t k = 0; k < cut_scales_; ++k) add_listed_corners(near, k);
  if (cut_scales_ < scales_) add_rim(near);
  for (const std::uint32_t i : vicinity.large()) add_large(near.corners[i], near.longest_edges[i]);
  add_boundary_edges(near);
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
  gap_angle_ = 0;
}

void BallEvaluator::find_triangle_scales(const InteractionList& near, const CulledInteractions& vicinity)
{
  if (touched_.size() <= near.corners.size()) touched_.resize(near.corners.size() + 1);
  if (outermost_.size() < near.corners.size()) outermost_.resize(near.corners.size());
  const std::uint8_t* scale = scale_of_.data();
  const TriangleScales* table = scales_table_.data();
  const LocalCorners* corners = near.corners.data();
  std::uint8_t* outermost = outermost_.data();
  const std::size_t stride = scales_ + 1;
  const std::uint8_t beyond = std::uint8_t(scales_);
  TouchedTriangle* end = touched_.data();
  for (const std::uint32_t leaf : vicinity.leaves()) {
    const LocalLeaf range = near.leaves[leaf];
    for (std::uint32_t i = range.begin; i < range.end; ++i) {
      const std::array<std::uint32_t, 5>& p = corners[i].ring;
      const TriangleScales t = table[(scale[p[0]] * stride + scale[p[1]]) * stride + scale[p[2]]];
      // Written in any case and counted where a vertex is inside the largest ball: a leaf may reach far beyond it.
      *end = {i, t};
      outermost[i] = t.most;
      end += t.least < beyond;
    }
  }
  touched_count_ = std::size_t(end - touched_.data());
}

void BallEvaluator::sort_triangles()
{
  whole_.resize(scales_ + 1);
  std::array<std::uint32_t*, limits::max_scales + 1> whole;
  for (std::uint32_t k = 0; k <= scales_; ++k) {
    if (whole_[k].size() < touched_count_) whole_[k].resize(touched_count_);
    whole[k] = whole_[k].data();
  }
  std::array<LocalCorner*, limits::max_scales + 2> end;
  for (std::uint32_t k = 0; k < scales_ + 2; ++k) {
    if (corners_[k].size() <= touched_count_) corners_[k].resize(touched_count_ + 1);
    end[k] = corners_[k].data();
  }
  for (std::size_t j = 0; j < touched_count_; ++j) {
    const TriangleScales t = touched_[j].scales;
    const std::uint32_t i = touched_[j].triangle;
    *whole[t.median]++ = i;
    // One or two scales as a rule, as good as at random: written in any case and counted where it applies.
    *end[t.least] = {i, t.corner_at_least};
    end[t.least] += t.is_cut;
    *end[t.least + 1] = {i, t.corner_after};
    end[t.least + 1] += t.is_cut_again;
    for (std::uint32_t k = t.least + 2u; k < t.most; ++k)
      *end[k]++ = {i, k < t.median ? t.corner_at_least : t.last_corner};
  }
  for (std::uint32_t k = 0; k < scales_; ++k) {
    whole_count_[k] = std::uint32_t(whole[k] - whole_[k].data());
    corner_count_[k] = std::uint32_t(end[k] - corners_[k].data());
  }
}

void BallEvaluator::add_whole_triangles(const InteractionList& near)
{
  // From its second vertex's scale on a triangle counts as whole, less the corner that is still outside.
  for (std::uint32_t k = 0; k < scales_; ++k)
    shells_[k] += whole_triangles(near.triangles.data(), whole_[k].data(), whole_count_[k], centre_);
}

void BallEvaluator::add_listed_corners(const InteractionList& near, std::uint32_t k)
{
  const LocalCorner* list = corners_[k].data();
  for (std::uint32_t i = 0; i < corner_count_[k]; ++i) {
    const std::uint32_t* ring = near.corners[list[i].triangle()].ring.data() + list[i].vertex();
    batch_.push(near.point(ring[0]), near.point(ring[1]), near.point(ring[2]), list[i].sign());
    if (batch_.is_full()) add_corners(batch_, centre_, radii_[k], pole_, near.longest_edge, cuts_[k]);
  }
  add_corners(batch_, centre_, radii_[k], pole_, near.longest_edge, cuts_[k]);
  if (k >= near.all_small_scale) return;
  for (std::uint32_t i = 0; i < corner_count_[k]; ++i) {
    const LocalCorners& corners = near.corners[list[i].triangle()];
    if (k < corners.first_small_scale) add_curved_corner(corners, list[i], k);
  }
}

void BallEvaluator::add_rim(const InteractionList& near)
{
  // Triangles with a vertex beyond the rim are left out. Where two of their vertices are inside, the edge between these
  // bounds what is left, or cancels against the same edge of the triangle next to it.
  const std::uint32_t rim = cut_scales_;
  rim_list_.clear();
  for (std::uint32_t i = 0; i < corner_count_[rim]; ++i) {
    const LocalCorner corner = corners_[rim][i];
    if (!corner.is_outside()) continue;
    const std::uint32_t* ring = near.corners[corner.triangle()].ring.data() + corner.vertex();
    rim_list_.push_back(corner.triangle());
    arc_batch_.push(near.point(ring[2]), near.point(ring[1]));
    if (arc_batch_.is_full()) arc_batch_.add_to(cut_arcs_[rim], centre_, pole_);
  }
  arc_batch_.add_to(cut_arcs_[rim], centre_, pole_);
  cuts_[rim].moments = whole_triangles(near.triangles.data(), rim_list_.data(), rim_list_.size(), centre_) * -1.0;
}

void BallEvaluator::add_curved_corner(const LocalCorners& corners, LocalCorner corner, std::uint32_t k)
{
  const std::uint32_t* ring = corners.ring.data() + corner.vertex();
  const Vec3 a = point(ring[0]), b = point(ring[1]), c = point(ring[2]);
  const double radius = radii_[k];
  const Vec3 p = a + (b - a) * edge_crossing(a, b, radius), q = a + (c - a) * edge_crossing(a, c, radius);
  cuts_[k].moments += curved_excess({a, b, c}, radius, 0, !corner.is_outside(), {p, q});
}

void BallEvaluator::add_large(const LocalCorners& corners, double longest_edge)
{
  std::uint32_t end_scale = corners.first_small_scale;
  for (int i = 0; i < 3; ++i) end_scale = std::min<std::uint32_t>(end_scale, scale_of_[corners.ring[i]]);
  if (end_scale == 0) return;
  // No point of a triangle is farther from its centroid than two thirds of the longest edge.
  const std::array<Vec3, 3> v = {point(corners.ring[0]), point(corners.ring[1]), point(corners.ring[2])};
  const double distance = norm((v[0] + v[1] + v[2]) * (1.0 / 3)) - longest_edge * (2.0 / 3);
  if (distance >= radii_[end_scale - 1] || (is_border_ && touches_centre(v))) return;
  std::uint32_t first_scale = 0;
  if (same_sheet_) {
    // The triangle belongs to the sheet where it shares an edge with a triangle that does.
    std::uint8_t rim[3] = {rim_scale_[corners.ring[0]], rim_scale_[corners.ring[1]], rim_scale_[corners.ring[2]]};
    std::sort(rim, rim + 3);
    first_scale = rim[1];
  }
  for (std::uint32_t k = first_scale; k < end_scale; ++k)
    if (distance < radii_[k]) cuts_[k].moments += curved_excess(v, radii_[k], -1, false, {});
}

void BallEvaluator::finish()
{
  moments_.resize(scales_);
  SolidMoments inside;
  MissingArea missing;
  ArcSums arcs;
  for (std::uint32_t k = 0; k < scales_; ++k) {
    inside += shells_[k];
    arcs += shell_arcs_[k];
    ArcSums all = arcs;
    all += cut_arcs_[k];
    missing += shell_missing_[k];
    moments_[k] = ball_moments(inside + cuts_[k].moments, all.terms(), all.half_area() + cuts_[k].half_area, radii_[k]);
    MissingArea all_missing = missing;
    all_missing += cut_missing_[k];
    moments_[k].confidence = confidence(all_missing, squared_radii_[k]);
  }
  rim_cones_ = inside + cuts_.back().moments;
  gap_angle_ = cut_missing_.back().angle;
}

}  // namespace integral_invariant
