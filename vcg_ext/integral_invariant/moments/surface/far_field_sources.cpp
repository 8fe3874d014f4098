// SPDX-License-Identifier: GPL-3.0-or-later
// Surface engine: the points that stand for the surface beyond the rim of a block's balls, gathered once for the block.
#include "integral_invariant/moments/surface/far_field_sources.h"

#include <algorithm>
#include <cmath>

namespace integral_invariant {

namespace {

constexpr std::size_t lanes = kernel_lanes;
static_assert(BoundingTree::leaf_size == lanes, "a leaf's triangles are the lanes of one group");

/// Largest radius of a node, in distances, that counts by one point (measured: docs/surface_engine.md).
constexpr double cluster_ratio = 0.12;
/// Largest edge of a triangle, in distances, that does.
constexpr double triangle_ratio = 0.6;

double longest_edge(const std::array<Vec3, 3>& v)
{
  return std::sqrt(std::max({squared_norm(v[1] - v[0]), squared_norm(v[2] - v[1]), squared_norm(v[0] - v[2])}));
}

}  // namespace

void FarFieldSources::gather(const InteractionList& near)
{
  centre_ = near.centre;
  radius_ = near.radius;
  points_.clear();
  clusters_.clear();
  cluster_spheres_.clear();
  cluster_lane_ = 0;
  point_spheres_.clear();
  triangle_spheres_.clear();
  near_leaf_.clear();
  loose_parts_.clear();
  std::size_t next_near = 0;
  tree_.triangles().visit(
      [&](std::size_t level, std::size_t index, const Sphere& sphere) {
        const double distance = norm(sphere.centre - centre_) - radius_;
        if (distance - sphere.radius > reach_) return false;
        if (sphere.radius > cluster_ratio * distance || distance - sphere.radius < near.reach) return true;
        add_cluster(level, index, sphere);
        return false;
      },
      [&](std::size_t leaf) {
        const bool is_near = next_near < near.leaves.size() && near.leaves[next_near].tree_leaf == leaf;
        near_leaf_.push_back(is_near ? std::uint32_t(next_near++) : no_leaf);
        add_leaf(leaf);
      });
  add_loose_parts();
  point_spheres_.pad();
  triangle_spheres_.pad();
  end_cluster_group();
  cluster_spheres_.pad();
}

void FarFieldSources::add_cluster(std::size_t level, std::size_t index, const Sphere& sphere)
{
  // About the centre of its flux, as far as the surface is flat enough to have one: the integrand varies least from
  // there.
  const SurfaceMultipoles& m = tree_.moments(level, index);
  const Vec3& n = m.normal;
  const double area2 = squared_norm(n), radius2 = sphere.radius * sphere.radius;
  Vec3 shift;
  double variance = 0;
  if (area2 > 0) {
    shift = (m.first[0] * n.x + m.first[1] * n.y + m.first[2] * n.z) * (1 / area2);
    variance = 0.5 * ((m.second[0].trace() * n.x + m.second[1].trace() * n.y + m.second[2].trace() * n.z) / area2 -
                      squared_norm(shift));
  }
  const bool is_flat = squared_norm(shift) < 0.5 * radius2 && variance > 0 && variance < radius2;
  if (!is_flat) shift = {}, variance = 0;
  const Vec3 spread[3] = {m.first[0] - shift * n.x, m.first[1] - shift * n.y, m.first[2] - shift * n.z};
  if (cluster_lane_ == 0) clusters_.emplace_back();
  cluster_points_[cluster_lane_].centre = sphere.centre + shift - centre_;
  clusters_.back().set(cluster_lane_, cluster_points_[cluster_lane_].centre, n, spread, variance);
  if (++cluster_lane_ == lanes) end_cluster_group();
}

void FarFieldSources::add_leaf(std::size_t leaf)
{
  const Sphere& sphere = tree_.triangles().levels()[0][leaf];
  const Vec3 middle = sphere.centre - centre_;
  const double nearest = norm(middle) - radius_ - sphere.radius;
  const bool may_be_large = 2 * sphere.radius > std::max(longest_near_edge, triangle_ratio * nearest);
  points_.emplace_back();
  std::array<Sphere, lanes> centroids;
  std::size_t lane = 0;
  for (std::size_t i = tree_.triangles().item_begin(leaf); i < tree_.triangles().item_end(leaf); ++i, ++lane) {
    const Triangle& t = tree_.order().triangles[i];
    std::array<Vec3, 3> v;
    for (int k = 0; k < 3; ++k) v[k] = tree_.order().points[std::size_t(t[k])] - centre_;
    if (may_be_large && longest_edge(v) > largest_piece(v)) {
      add_parts(v, 0);
      v = {middle, middle, middle};
    }
    points_.back().set(lane, v);
    centroids[lane].centre = (v[0] + v[1] + v[2]) * (1.0 / 3);
  }
  const Sphere points = bounding_sphere(centroids.data(), lane);
  for (; lane < lanes; ++lane) points_.back().set(lane, {middle, middle, middle});
  point_spheres_.push(points.centre, points.radius);
  triangle_spheres_.push(middle, sphere.radius);
}

double FarFieldSources::largest_piece(const std::array<Vec3, 3>& v) const
{
  return std::max(longest_near_edge, triangle_ratio * (norm((v[0] + v[1] + v[2]) * (1.0 / 3)) - radius_));
}

void FarFieldSources::add_parts(const std::array<Vec3, 3>& v, int depth)
{
  constexpr int most_halvings = 16;
  if (depth == most_halvings || longest_edge(v) <= largest_piece(v)) {
    loose_parts_.push_back(v);
    return;
  }
  std::size_t i = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if (squared_norm(v[(k + 1) % 3] - v[k]) > squared_norm(v[(i + 1) % 3] - v[i])) i = k;
  const Vec3 middle = (v[i] + v[(i + 1) % 3]) * 0.5;
  add_parts({v[i], middle, v[(i + 2) % 3]}, depth + 1);
  add_parts({middle, v[(i + 1) % 3], v[(i + 2) % 3]}, depth + 1);
}

void FarFieldSources::add_loose_parts()
{
  std::array<Sphere, lanes> members;
  for (std::size_t begin = 0; begin < loose_parts_.size(); begin += lanes) {
    const std::size_t count = std::min(lanes, loose_parts_.size() - begin);
    for (std::size_t i = 0; i < count; ++i) {
      const std::array<Vec3, 3>& v = loose_parts_[begin + i];
      members[i].centre = (v[0] + v[1] + v[2]) * (1.0 / 3);
    }
    const Sphere sphere = bounding_sphere(members.data(), count);
    const Vec3& c = sphere.centre;
    points_.emplace_back();
    for (std::size_t i = 0; i < lanes; ++i)
      points_.back().set(i, i < count ? loose_parts_[begin + i] : std::array<Vec3, 3>{c, c, c});
    point_spheres_.push(c, sphere.radius);
    triangle_spheres_.push(c, sphere.radius);
    near_leaf_.push_back(no_leaf);
  }
}

void FarFieldSources::end_cluster_group()
{
  if (cluster_lane_ == 0) return;
  const Sphere sphere = bounding_sphere(cluster_points_.data(), cluster_lane_);
  for (; cluster_lane_ < lanes; ++cluster_lane_)
    clusters_.back().set(cluster_lane_, sphere.centre, {}, {{}, {}, {}}, 0);
  cluster_spheres_.push(sphere.centre, sphere.radius);
  cluster_lane_ = 0;
}

}  // namespace integral_invariant
