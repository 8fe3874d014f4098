// SPDX-License-Identifier: GPL-3.0-or-later
// Surface engine: moments of large balls from what is known up to their rim and points beyond it.
#include "integral_invariant/moments/surface/far_field.h"

#include <algorithm>
#include <cmath>

#include "integral_invariant/moments/surface/sphere_clip.h"
#include "integral_invariant/support/pi.h"

namespace integral_invariant {

namespace {

// In edges, measured (docs/surface_engine.md): what is in closed form, the rim beyond it, what is worth one.
constexpr double widest_near = 3.05, rim_gap = 0.3, least_gain = 1.5;
constexpr std::uint32_t none = ~0u;
constexpr std::uint8_t no_shell = 255;

/// c₀, c₁, c₂ for the moments of degree 0, 1, 2.
SolidMoments scaled(const SolidMoments& m, double c0, double c1, double c2)
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

ScaleSplit ScaleSplit::of(const std::vector<double>& radii)
{
  if (radii.back() < widest_near + least_gain) return none(radii);
  const auto first_far = std::lower_bound(radii.begin(), radii.end(), widest_near);
  ScaleSplit split{{radii.begin(), first_far}, {first_far, radii.end()}};
  split.near.push_back(std::min(widest_near + rim_gap, *first_far));
  return split;
}

FarField::FarField(const SurfaceTree& tree, const ScaleSplit& split, const FarDetail& detail)
    : radii_(with_rim(split)),
      rim_{radii_.front()},
      detail_(detail),
      outside_(std::uint8_t(split.near.size())),
      far_(tree, radii_.back()),
      points_in_(radii_.size()),
      points_at_(radii_.size()),
      clusters_in_(radii_.size()),
      point_count_(radii_.size()),
      kink_count_(radii_.size()),
      cluster_count_(radii_.size())
{
  for (const double r : radii_) squared_radii_.push_back(r * r);
}

void FarField::enter(const InteractionList& near)
{
  near_ = &near;
  far_.gather(near);
}

void FarField::narrow(std::uint32_t begin, std::uint32_t end)
{
  std::vector<Sphere> points;
  for (std::uint32_t i = begin; i < end; ++i) points.push_back({near_->point(i), 0});
  const Sphere around = bounding_sphere(points.data(), points.size());
  const double extent = around.radius + position_rounding;

  const SphereColumns& triangles = far_.triangle_spheres();
  find_ranges(triangles, around.centre, extent);
  leaves_.clear();
  rim_leaves_ = 0;
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    if (largest_[i] == 0 || least_[i] == radii_.size()) continue;
    leaves_.push_back(i);
    if (least_[i] == 0) std::swap(leaves_.back(), leaves_[rim_leaves_++]);
  }
  triangle_spheres_.take(triangles, leaves_.data(), rim_leaves_);
  point_spheres_.take(far_.point_spheres(), leaves_.data(), leaves_.size());

  const SphereColumns& clusters = far_.cluster_spheres();
  find_ranges(clusters, around.centre, extent);
  clusters_.clear();
  for (std::uint32_t i = 0; i < clusters.size(); ++i)
    if (largest_[i] > 0 && least_[i] < radii_.size()) clusters_.push_back(i);
  cluster_spheres_.take(clusters, clusters_.data(), clusters_.size());
}

void FarField::find_ranges(const SphereColumns& spheres, const Vec3& centre, double extent)
{
  least_.resize(std::max(least_.size(), spheres.x.size()));
  largest_.resize(least_.size());
  find_scale_ranges(spheres, centre, extent, radii_, least_.data(), largest_.data());
}

const std::vector<BallMoments>& FarField::evaluate(const BallEvaluator& evaluator, std::uint32_t centre,
                                                   const BallMoments& rim_moments, bool is_border)
{
  const Vec3 apex = near_->point(centre);
  sort_leaves(evaluator.outermost_scales(), apex);
  sort_clusters(apex);

  // total = cones within the rim + the rest of the rim's ball, grown to r + annulus.
  const SolidMoments& cones = evaluator.rim_cones();
  const SolidMoments sector = SolidMoments{rim_moments.volume, rim_moments.first, rim_moments.second} - cones;
  FluxSums annulus;
  moments_.resize(radii_.size() - 1);
  for (std::size_t k = 1; k < radii_.size(); ++k) {
    const FluxSums::Shell shell{apex, k == 1 ? -1.0 : squared_radii_[k - 1], squared_radii_[k]};
    annulus.add_points(far_.points(), weights_.data(), points_in_[k].data(), point_count_[k], shell,
                       radii_[k - 1] < detail_.shape ? FluxSums::Shape::own : FluxSums::Shape::none);
    annulus.add_clusters(far_.clusters(), clusters_in_[k].data(), cluster_count_[k], shell);
    const double r = radii_[k], r3 = r * r * r, grown = r / radii_[0], grown3 = grown * grown * grown;
    SolidMoments total = cones + scaled(sector, grown3, grown3 * grown, grown3 * grown * grown) +
                         scaled(annulus.up_to(r), 1.0 / 3, 0.25, 0.2);
    if (r < detail_.kink)
      total += kink_at(r, apex, far_.points(), weights_.data(), points_at_[k].data(), kink_count_[k]);
    moments_[k - 1] = {std::clamp(total.volume, 0.0, 4 * pi / 3 * r3), total.first, total.second, 1};
  }
  find_confidence(apex, evaluator.gap_angle(), is_border);
  return moments_;
}

void FarField::sort_leaves(const std::vector<std::uint8_t>& outermost_scales, const Vec3& centre)
{
  find_ranges(point_spheres_, centre, position_rounding);
  weights_.resize(1);
  std::fill_n(weights_[0].weight, kernel_lanes, 1.0);
  weights_of_.assign(leaves_.size(), 0);
  least_side_.resize(triangle_spheres_.x.size());
  largest_side_.resize(triangle_spheres_.x.size());
  find_scale_ranges(triangle_spheres_, centre, position_rounding, rim_, least_side_.data(), largest_side_.data());
  for (std::uint32_t i = 0; i < rim_leaves_; ++i) {
    weights_of_[i] = largest_side_[i] == 0 ? none : 0;
    if (least_side_[i] < largest_side_[i]) weights_of_[i] = weigh_rim_leaf(i, outermost_scales, centre);
    // The points of triangles that the rim cuts may be within it, and count in the first shell.
    least_[i] = weights_of_[i] == none ? no_shell : std::max<std::uint8_t>(least_[i], 1);
    largest_[i] = std::max<std::uint8_t>(largest_[i], 1);
  }
  // Those in shell k, and of them those that the sphere at its end may cut.
  for (std::size_t k = 1; k < radii_.size(); ++k) {
    point_count_[k] = list_leaves(k, k, points_in_[k]);
    if (radii_[k] < detail_.kink) kink_count_[k] = list_leaves(k, k + 1, points_at_[k]);
  }
}

/// Writes the leaves that begin in shell k or before and reach as far as shell `reached`; returns how many.
std::uint32_t FarField::list_leaves(std::size_t k, std::size_t reached, std::vector<WeightedPacket>& list) const
{
  if (list.size() <= leaves_.size()) list.resize(leaves_.size() + 1);
  // Written in any case and counted where it applies.
  WeightedPacket* end = list.data();
  for (std::size_t i = 0; i < leaves_.size(); ++i) {
    *end = {leaves_[i], weights_of_[i]};
    end += (least_[i] <= k) & (reached <= largest_[i]);
  }
  return std::uint32_t(end - list.data());
}

/// Which weights leave out the triangles within the rim; none where all are.
std::uint32_t FarField::weigh_rim_leaf(std::uint32_t i, const std::vector<std::uint8_t>& outermost_scales,
                                       const Vec3& centre)
{
  const std::uint32_t near_leaf = far_.near_leaf(leaves_[i]);
  if (near_leaf == FarFieldSources::no_leaf) {
    // It touches the rim to the last bits.
    const Vec3 middle{triangle_spheres_.x[i], triangle_spheres_.y[i], triangle_spheres_.z[i]};
    return squared_norm(middle - centre) < squared_radii_[0] ? none : 0;
  }
  const LocalLeaf& leaf = near_->leaves[near_leaf];
  weights_.push_back(weights_[0]);
  double* weight = weights_.back().weight;
  const std::uint8_t *outermost = outermost_scales.data(), *lane = near_->lanes.data();
  bool has_outside = leaf.end - leaf.begin < kernel_lanes;
  for (std::uint32_t t = leaf.begin; t < leaf.end; ++t) {
    const bool is_outside = outermost[t] == outside_;
    weight[lane[t]] = is_outside;
    has_outside |= is_outside;
  }
  if (has_outside) return std::uint32_t(weights_.size() - 1);
  weights_.pop_back();
  return none;
}

void FarField::sort_clusters(const Vec3& centre)
{
  find_ranges(cluster_spheres_, centre, position_rounding);
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
  if (near_->boundary_edges.empty()) return;
  missing_.assign(radii_.size(), {gap_angle, 0});
  for (const LocalBoundaryEdge& edge : near_->boundary_edges) {
    if (edge.stands_for == 0) continue;
    Vec3 a = near_->point(edge.from) - centre, b = near_->point(edge.to) - centre;
    double nearer = squared_norm(a), farther = squared_norm(b);
    if (std::min(nearer, farther) > squared_radii_.back()) continue;
    if (nearer == 0 || farther == 0 || (is_border && passes_origin(a, b))) continue;
    const double sign = boundary_side(edge.surplus, a, b, near_->point(edge.opposite) - centre) * edge.stands_for;
    if (nearer > farther) {
      std::swap(a, b);
      std::swap(nearer, farther);
    }
    MissingArea whole;
    bool has_whole = false;
    for (std::size_t k = 1; k < radii_.size(); ++k) {
      if (nearer > squared_radii_[k]) continue;
      if (farther > squared_radii_[k]) {
        missing_[k].add(a, a + (b - a) * edge_crossing(a, b, radii_[k]), sign);
        continue;
      }
      if (!has_whole) whole.add(a, b, sign);  // the same for all larger balls
      has_whole = true;
      missing_[k] += whole;
    }
  }
  for (std::size_t k = 1; k < radii_.size(); ++k)
    moments_[k - 1].confidence = confidence(missing_[k], squared_radii_[k]);
}

}  // namespace integral_invariant
