// SPDX-License-Identifier: GPL-3.0-or-later
// Surface engine: what a block of nearby vertices needs of the mesh, gathered once for all of them.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "integral_invariant/moments/surface/bounding_tree.h"
#include "integral_invariant/moments/surface/kernels/clip.h"
#include "integral_invariant/moments/surface/prepared_mesh.h"
#include "integral_invariant/moments/surface/surface_multipoles.h"

namespace integral_invariant {

/// The mesh in spatial order with hierarchies over its triangles and boundary edges, and the moments of every node.
class SurfaceTree {
 public:
  SurfaceTree(const Surface& surface, bool merge_dense, Execution& execution);

  const PreparedMesh& order() const { return order_; }
  const BoundingTree& triangles() const { return triangles_; }
  const BoundingTree& boundary_edges() const { return boundary_edges_; }
  /// Of the triangles below a node, about the centre of its sphere.
  const SurfaceMultipoles& moments(std::size_t level, std::size_t index) const { return moments_[level][index]; }
  /// Whether a boundary edge ends at the point.
  bool is_border(std::uint32_t point) const { return is_border_[point]; }

 private:
  void sum_moments(Execution& execution);
  SurfaceMultipoles moments_of_leaf(std::size_t leaf) const;
  SurfaceMultipoles moments_of_children(std::size_t level, std::size_t node) const;

  PreparedMesh order_;
  BoundingTree triangles_, boundary_edges_;
  std::vector<std::vector<SurfaceMultipoles>> moments_;
  std::vector<bool> is_border_;
};

/// Of positions in normalised coordinates, with room: what touches a sphere counts as cut.
inline constexpr double position_rounding = 1e-9;

/// Corners of a triangle of a neighbourhood, by local points; the first two again at the end, so that the three from
/// any corner on lie side by side.
struct LocalCorners {
  std::array<std::uint32_t, 5> ring;
  std::uint32_t first_small_scale;  ///< from this scale on the triangle's circular segments are left out
};

/// Consecutive triangles of a neighbourhood, those of a leaf of the tree.
struct LocalLeaf {
  std::uint32_t begin, end, tree_leaf;
};

struct LocalBoundaryEdge {
  std::uint32_t from, to, opposite;
  std::int32_t surplus;
  std::uint32_t stands_for;  ///< edges, itself among them: 1 but in a crowd; 0: counts about its own ends alone
};

/// Triangles and boundary edges that a ball about any point of the block can cut, in coordinates relative to `centre`;
/// the triangles that lie between the same two radii for all of the block's points are summed in `far`.
struct InteractionList {
  Vec3 centre;
  double radius = 0;                     ///< of the block's points about it
  double reach = 0;                      ///< largest radius, of balls about the block's points, that counts here
  std::vector<std::uint32_t> point_ids;  ///< local → PreparedMesh::points
  std::vector<double> x, y, z;           ///< per local point; filled up to full lanes of the kernels
  std::vector<LocalCorners> corners;     ///< per triangle
  std::vector<LocalTriangle> triangles;  ///< in the same order
  std::vector<double> longest_edges;     ///< of them
  std::vector<std::uint8_t> lanes;       ///< their places in their leaves
  std::uint32_t all_small_scale = 0;     ///< largest of the triangles' first scales
  double longest_edge = 0;
  std::vector<LocalLeaf> leaves;
  SphereColumns leaf_spheres;        ///< that hold the leaves' triangles
  SphereColumns point_groups;        ///< that hold kernel_lanes consecutive points each
  std::vector<std::uint32_t> large;  ///< triangles that a sphere against which they are large may cut
  std::vector<LocalBoundaryEdge> boundary_edges, close_boundary_edges;  ///< all of them; those that a ball can cut
  bool is_crowd = false;  ///< there are more of the latter than the border of a surface has
  std::vector<std::uint32_t> neighbour_start, neighbours;  ///< points along triangle edges; only where asked for
  std::vector<SurfaceMultipoles> far;                      ///< per scale from which on they are inside; about `centre`
  std::vector<char> has_far;

  Vec3 point(std::uint32_t i) const { return {x[i], y[i], z[i]}; }
  void group_points();
  void connect_points();
};

/// Gathers neighbourhoods one after the other into the same memory.
class InteractionGatherer {
 public:
  /// A triangle is small from the scale on at which its longest edge is at most `small_edge` radii; 0: never.
  /// Free edges are gathered up to `reach`, triangles up to the largest radius.
  InteractionGatherer(const SurfaceTree& tree, const std::vector<double>& radii, double reach, double small_edge,
                      bool sum_far);

  /// For the points [begin, end) of the spatial order, which are the first local ones. The reference holds until the
  /// next call.
  const InteractionList& gather(std::size_t begin, std::size_t end);

 private:
  /// Local index of a point; added where it is new.
  std::uint32_t local(std::uint32_t point);
  /// Scale from which on all balls about the block hold the sphere, or −1 where some ball can cut it.
  int common_scale(const Sphere& sphere) const;
  void add_triangle(const Triangle& triangle, std::uint8_t lane);
  /// First scale against which an edge is small.
  std::uint32_t first_small_scale(double edge) const;
  void gather_triangles();
  void gather_boundary_edges();
  void add_boundary_edges(const std::vector<std::uint32_t>& edges, std::size_t most,
                          std::vector<LocalBoundaryEdge>& local_edges);
  void forget_points();
  void grow_table();

  const SurfaceTree& tree_;
  const std::vector<double>& radii_;
  const double reach_, small_edge_;
  const bool sum_far_;
  Sphere block_;
  std::size_t block_begin_ = 0, block_end_ = 0;
  std::vector<std::uint32_t> near_edges_, close_edges_;  ///< boundary edges, by their number in the tree
  InteractionList local_;
  std::vector<std::uint32_t> table_;  ///< open addressing: local index + 1, 0 where free
};

}  // namespace integral_invariant
