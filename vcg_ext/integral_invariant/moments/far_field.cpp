// SPDX-License-Identifier: GPL-3.0-or-later
// Surface engine: moments of large balls from what is known up to their rim and points beyond it.
#include "integral_invariant/moments/far_field.h"

#include <algorithm>
#include <cmath>

#include "integral_invariant/moments/sphere_cut.h"

namespace integral_invariant {

namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double rim_gap = 0.5, least_gain = 1.5;  // edges
constexpr std::uint32_t nowhere = ~0u;
constexpr std::uint8_t listed = 255;  // as least scale: the leaf is in the lists already

/// c₀, c₁, c₂ for the moments of degree 0, 1, 2.
MomentSums scaled(const MomentSums& m, double c0, double c1, double c2)
{
  return {m.volume * c0, m.first * c1, m.second * c2};
}

std::vector<double> with_rim(const ScaleSplit& split)
{
  std::vector<double> radii = split.far;
  radii.insert(radii.begin(), split.near.back());
  return radii;
}

}  // namespace

ScaleSplit ScaleSplit::of(const std::vector<double>& radii, double widest_near)
{
  if (radii.back() < widest_near + least_gain) return none(radii);
  const auto first_far = std::lower_bound(radii.begin(), radii.end(), widest_near);
  ScaleSplit split{{radii.begin(), first_far}, {first_far, radii.end()}};
  split.near.push_back(std::min(widest_near + rim_gap, *first_far));
  return split;
}

FarField::FarField(const SurfaceTree& tree, const ScaleSplit& split)
    : radii_(with_rim(split)), outside_(std::uint8_t(split.near.size())), far_(tree, radii_.back()),
      points_in_(radii_.size()), clusters_in_(radii_.size()), point_count_(radii_.size()), cluster_count_(radii_.size())
{
  for (const double r : radii_) squared_radii_.push_back(r * r);
}

void FarField::enter(const Neighbourhood& near)
{
  near_ = &near;
  far_.gather(near);
}

void FarField::narrow(std::uint32_t begin, std::uint32_t end)
{
  std::vector<Sphere> points;
  for (std::uint32_t i = begin; i < end; ++i) points.push_back({near_->point(i), 0});
  const Sphere around = bounding_sphere(points.data(), points.size());
  const auto choose = [&](const SphereColumns& from, std::vector<std::uint32_t>& chosen, SphereColumns& spheres) {
    least_.resize(std::max(least_.size(), from.x.size()));
    largest_.resize(least_.size());
    find_scale_ranges(from, around.centre, around.radius + position_rounding, radii_, least_.data(), largest_.data());
    chosen.clear();
    spheres.clear();
    for (std::uint32_t i = 0; i < from.size(); ++i) {
      if (largest_[i] == 0 || least_[i] == radii_.size()) continue;
      chosen.push_back(i);
      spheres.push({from.x[i], from.y[i], from.z[i]}, from.radius[i]);
    }
    spheres.pad();
  };
  choose(far_.point_spheres(), leaves_, leaf_spheres_);
  choose(far_.cluster_spheres(), clusters_, cluster_spheres_);
  place_of_leaf_.assign(far_.point_spheres().size(), nowhere);
  for (std::uint32_t i = 0; i < leaves_.size(); ++i) place_of_leaf_[leaves_[i]] = i;
}

const std::vector<BallMoments>& FarField::evaluate(const BallEvaluator& evaluator, const Vicinity& vicinity,
                                                   std::uint32_t centre, const BallMoments& rim_moments, bool is_border)
{
  const Vec3 apex = near_->point(centre);
  sort_leaves(vicinity, evaluator.first_scales(), apex);
  sort_clusters(apex);

  // total = cones within the rim + the rest of the rim's ball, grown to r + annulus.
  const MomentSums& cones = evaluator.rim_cones();
  const MomentSums sector = MomentSums{rim_moments.volume, rim_moments.first, rim_moments.second} - cones;
  ShellFlux annulus;
  moments_.resize(radii_.size() - 1);
  for (std::size_t k = 1; k < radii_.size(); ++k) {
    const double inner = k == 1 ? -1.0 : squared_radii_[k - 1], outer = squared_radii_[k];
    for (const ShellFlux& part :
         {flux_of_points(far_.points(), weights_.data(), points_in_[k].data(), point_count_[k], apex, inner, outer),
          flux_of_clusters(far_.clusters(), clusters_in_[k].data(), cluster_count_[k], apex, inner, outer)}) {
      annulus.plain += part.plain;
      annulus.inverse += part.inverse;
    }
    const double r = radii_[k], r3 = r * r * r, grown = r / radii_[0], grown3 = grown * grown * grown;
    const MomentSums flux = annulus.plain - scaled(annulus.inverse, r3, r3 * r, r3 * r * r);
    const MomentSums total = cones + scaled(sector, grown3, grown3 * grown, grown3 * grown * grown) +
                             scaled(flux, 1.0 / 3, 0.25, 0.2);
    moments_[k - 1] = {std::clamp(total.volume, 0.0, 4 * pi / 3 * r3), total.first, total.second, 1};
  }
  find_confidence(apex, evaluator.gap_angle(), is_border);
  return moments_;
}

void FarField::sort_leaves(const Vicinity& vicinity, const std::vector<std::uint8_t>& first_scales, const Vec3& centre)
{
  least_.resize(std::max(least_.size(), leaf_spheres_.x.size()));
  largest_.resize(least_.size());
  find_scale_ranges(leaf_spheres_, centre, position_rounding, radii_, least_.data(), largest_.data());
  weights_.resize(1);
  std::fill_n(weights_[0].weight, kernel_lanes, 1.0);
  const std::size_t shells = radii_.size();
  for (std::size_t k = 1; k < shells; ++k) {
    points_in_[k].resize(std::max(points_in_[k].size(), leaves_.size() + 1));
    point_count_[k] = 0;
  }
  for (const std::uint32_t leaf : vicinity.leaves()) {
    const std::uint32_t place = place_of_leaf_[far_.of_near_leaf(leaf)];
    if (place == nowhere || largest_[place] == 0 || least_[place] > 0) continue;
    if (weigh_leaf(near_->leaves[leaf], first_scales))
      for (std::size_t k = 1; k < std::min<std::size_t>(largest_[place] + 1u, shells); ++k)
        points_in_[k][point_count_[k]++] = {leaves_[place], std::uint32_t(weights_.size() - 1)};
    least_[place] = listed;
  }
  for (std::uint32_t i = 0; i < leaves_.size(); ++i) {
    if (least_[i] > 0 || largest_[i] == 0) continue;
    // It touches the rim to the last bits.
    const Vec3 middle{leaf_spheres_.x[i], leaf_spheres_.y[i], leaf_spheres_.z[i]};
    least_[i] = squared_norm(middle - centre) < squared_radii_[0] ? listed : std::uint8_t(1);
  }
  for (std::size_t k = 1; k < shells; ++k) {
    // Written in any case and counted where it applies.
    WeighedGroup* end = points_in_[k].data() + point_count_[k];
    for (std::size_t i = 0; i < leaves_.size(); ++i) {
      *end = {leaves_[i], 0};
      end += (least_[i] <= k) & (k <= largest_[i]);
    }
    point_count_[k] = std::uint32_t(end - points_in_[k].data());
  }
}

/// Appends weights of 1 for the leaf's triangles that are not within the rim; false where all are.
bool FarField::weigh_leaf(const LocalLeaf& leaf, const std::vector<std::uint8_t>& first_scales)
{
  weights_.push_back(weights_[0]);
  double* weight = weights_.back().weight;
  const std::uint8_t *scale = first_scales.data(), *lane = near_->lanes.data();
  const LocalCorners* corners = near_->corners.data();
  bool has_outside = leaf.end - leaf.begin < kernel_lanes;
  for (std::uint32_t i = leaf.begin; i < leaf.end; ++i) {
    const std::array<std::uint32_t, 5>& p = corners[i].ring;
    // No vertex is farther than the first scale beyond the rim.
    const bool is_outside = (scale[p[0]] == outside_) | (scale[p[1]] == outside_) | (scale[p[2]] == outside_);
    weight[lane[i]] = is_outside;
    has_outside |= is_outside;
  }
  if (!has_outside) weights_.pop_back();
  return has_outside;
}

void FarField::sort_clusters(const Vec3& centre)
{
  least_.resize(std::max(least_.size(), cluster_spheres_.x.size()));
  largest_.resize(least_.size());
  find_scale_ranges(cluster_spheres_, centre, position_rounding, radii_, least_.data(), largest_.data());
  for (std::size_t k = 1; k < radii_.size(); ++k) {
    if (clusters_in_[k].size() <= clusters_.size()) clusters_in_[k].resize(clusters_.size() + 1);
    std::uint32_t* end = clusters_in_[k].data();
    for (std::size_t i = 0; i < clusters_.size(); ++i) {
      *end = clusters_[i];
      end += (least_[i] <= k) & (k <= largest_[i]);
    }
    cluster_count_[k] = std::uint32_t(end - clusters_in_[k].data());
  }
}

void FarField::find_confidence(const Vec3& centre, double gap_angle, bool is_border)
{
  if (near_->free_edges.empty()) return;
  missing_.assign(radii_.size(), {gap_angle, 0});
  for (const LocalFreeEdge& edge : near_->free_edges) {
    Vec3 a = near_->point(edge.from) - centre, b = near_->point(edge.to) - centre;
    if (squared_norm(a) == 0 || squared_norm(b) == 0 || (is_border && passes_origin(a, b))) continue;
    const double sign = free_edge_side(edge.surplus, a, b, near_->point(edge.opposite) - centre);
    if (squared_norm(a) > squared_norm(b)) std::swap(a, b);
    for (std::size_t k = 1; k < radii_.size(); ++k) {
      if (squared_norm(a) > squared_radii_[k]) continue;
      const bool is_whole = squared_norm(b) <= squared_radii_[k];
      missing_[k].add(a, is_whole ? b : a + (b - a) * edge_crossing(a, b, radii_[k]), sign);
    }
  }
  for (std::size_t k = 1; k < radii_.size(); ++k) moments_[k - 1].confidence = confidence(missing_[k], squared_radii_[k]);
}

}  // namespace integral_invariant
