// SPDX-License-Identifier: GPL-3.0-or-later
// Surface engine: what of a block's neighbourhood the spheres about few of its points, and about one of them, can cut.
#include "integral_invariant/moments/surface/interaction_culling.h"

#include <algorithm>

namespace integral_invariant {

CulledInteractions::CulledInteractions(const SurfaceTree& tree, const std::vector<double>& radii, bool sum_far)
    : tree_(tree), radii_(radii), sum_far_(sum_far)
{
  for (const double r : radii) squared_radii_.push_back(r * r);
}

void CulledInteractions::enter(const InteractionList& near)
{
  near_ = &near;
  leaf_moments_.resize(near.leaves.size());
  has_leaf_moments_.assign(near.leaves.size(), 0);
}

void CulledInteractions::add_far(std::uint32_t leaf, std::uint8_t scale, Far& far)
{
  if (!has_leaf_moments_[leaf]) {
    const SphereColumns& spheres = near_->leaf_spheres;
    const Vec3 centre{spheres.x[leaf], spheres.y[leaf], spheres.z[leaf]};
    leaf_moments_[leaf] = translated(tree_.moments(0, near_->leaves[leaf].tree_leaf), centre);
    has_leaf_moments_[leaf] = 1;
  }
  far.moments[scale] += leaf_moments_[leaf];
  far.has[scale] = 1;
}

void CulledInteractions::narrow(std::uint32_t begin, std::uint32_t end)
{
  std::vector<Sphere> points;
  for (std::uint32_t i = begin; i < end; ++i) points.push_back({near_->point(i), 0});
  const Sphere around = bounding_sphere(points.data(), points.size());
  close_far_.moments = near_->far;
  close_far_.has = near_->has_far;
  close_leaves_.clear();
  close_spheres_.clear();
  const SphereColumns& spheres = near_->leaf_spheres;
  least_.resize(spheres.x.size());
  largest_.resize(spheres.x.size());
  find_scale_ranges(spheres, around.centre, around.radius + position_rounding, radii_, least_.data(), largest_.data());
  for (std::uint32_t leaf = 0; leaf < near_->leaves.size(); ++leaf) {
    if (least_[leaf] == radii_.size()) continue;
    if (sum_far_ && least_[leaf] == largest_[leaf]) {
      add_far(leaf, least_[leaf], close_far_);
      continue;
    }
    close_leaves_.push_back(leaf);
    close_spheres_.push({spheres.x[leaf], spheres.y[leaf], spheres.z[leaf]}, spheres.radius[leaf]);
  }
  close_spheres_.pad();
  sort_points(around);
  choose_large(around);
}

void CulledInteractions::choose_large(const Sphere& around)
{
  close_large_.clear();
  for (const std::uint32_t i : near_->large) {
    const double* centroid = near_->triangles[i].centroid;
    // No point of a triangle is farther from its centroid than two thirds of the longest edge.
    const double reach = radii_[near_->corners[i].first_small_scale - 1] + near_->longest_edges[i] * (2.0 / 3);
    const double distance = norm(Vec3{centroid[0], centroid[1], centroid[2]} - around.centre);
    if (distance < reach + around.radius + position_rounding) close_large_.push_back(i);
  }
}

void CulledInteractions::sort_points(const Sphere& around)
{
  const SphereColumns& groups = near_->point_groups;
  least_.resize(std::max(least_.size(), groups.x.size()));
  largest_.resize(std::max(largest_.size(), groups.x.size()));
  find_scale_ranges(groups, around.centre, around.radius + position_rounding, radii_, least_.data(), largest_.data());
  common_scale_.resize(near_->x.size());
  cut_groups_.clear();
  for (std::uint32_t g = 0; g < groups.size(); ++g) {
    if (least_[g] == largest_[g])
      std::fill_n(common_scale_.begin() + std::ptrdiff_t(g * kernel_lanes), kernel_lanes, least_[g]);
    else
      cut_groups_.push_back(g);
  }
}

void CulledInteractions::centre_on(std::uint32_t point, std::vector<std::uint8_t>& scale_of)
{
  const Vec3 centre = near_->point(point);
  scale_of = common_scale_;
  find_scales(near_->x.data(), near_->y.data(), near_->z.data(), cut_groups_, centre, squared_radii_, scale_of.data());
  far_ = close_far_;
  least_.resize(std::max(least_.size(), close_spheres_.x.size()));
  largest_.resize(std::max(largest_.size(), close_spheres_.x.size()));
  find_scale_ranges(close_spheres_, centre, position_rounding, radii_, least_.data(), largest_.data());
  leaves_.clear();
  for (std::size_t i = 0; i < close_leaves_.size(); ++i) {
    if (least_[i] == radii_.size()) continue;
    if (sum_far_ && least_[i] == largest_[i])
      add_far(close_leaves_[i], least_[i], far_);
    else
      leaves_.push_back(close_leaves_[i]);
  }
}

}  // namespace integral_invariant
