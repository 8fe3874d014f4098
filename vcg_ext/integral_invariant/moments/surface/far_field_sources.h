// SPDX-License-Identifier: GPL-3.0-or-later
// Surface engine: the points that stand for the surface beyond the rim of a block's balls, gathered once for the block.
#pragma once

#include <cstdint>
#include <vector>

#include "integral_invariant/moments/surface/interaction_list.h"
#include "integral_invariant/moments/surface/kernels/multipole.h"

namespace integral_invariant {

/// Edges longer than this make a block's near triangles too coarse for points.
inline constexpr double longest_near_edge = 3;

/// In coordinates relative to the neighbourhood's centre.
class FarFieldSources {
 public:
  static constexpr std::uint32_t no_leaf = ~0u;

  /// `reach`: largest radius of a ball about the block's points.
  FarFieldSources(const SurfaceTree& tree, double reach) : tree_(tree), reach_(reach) {}

  /// What is beyond the rims of the balls about the points of `near`, and all that can be for some of them.
  void gather(const InteractionList& near);

  /// Triangles of one leaf of the tree, or parts of large ones.
  const TrianglePacket* points() const { return points_.data(); }
  /// Bounds of the points, and of the triangles that they stand for.
  const SphereColumns& point_spheres() const { return point_spheres_; }
  const SphereColumns& triangle_spheres() const { return triangle_spheres_; }
  /// Index of the neighbourhood's leaf that points()[i] are, or no_leaf.
  std::uint32_t near_leaf(std::uint32_t i) const { return near_leaf_[i]; }
  /// Nodes of the tree.
  const MultipolePacket* clusters() const { return clusters_.data(); }
  const SphereColumns& cluster_spheres() const { return cluster_spheres_; }

 private:
  void add_cluster(std::size_t level, std::size_t index, const Sphere& sphere);
  void add_leaf(std::size_t leaf);
  void add_parts(const std::array<Vec3, 3>& triangle, int depth);
  /// Longest edge of a piece that may count by one point where the triangle is.
  double largest_piece(const std::array<Vec3, 3>& triangle) const;
  void add_loose_parts();
  void end_cluster_group();

  const SurfaceTree& tree_;
  const double reach_;
  Vec3 centre_;
  double radius_ = 0;  ///< of the block
  std::vector<TrianglePacket> points_;
  std::vector<MultipolePacket> clusters_;
  std::size_t cluster_lane_ = 0;  ///< next one of the last group
  std::array<Sphere, kernel_lanes> cluster_points_;
  SphereColumns point_spheres_, triangle_spheres_, cluster_spheres_;
  std::vector<std::uint32_t> near_leaf_;
  std::vector<std::array<Vec3, 3>> loose_parts_;
};

}  // namespace integral_invariant
