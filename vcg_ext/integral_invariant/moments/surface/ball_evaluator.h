// SPDX-License-Identifier: GPL-3.0-or-later
// Surface engine: the moments of all balls about one point of a neighbourhood.
#pragma once

#include <vector>

#include "integral_invariant/moments/surface/coverage.h"
#include "integral_invariant/moments/surface/fan_closure.h"
#include "integral_invariant/moments/surface/interaction_culling.h"
#include "integral_invariant/moments/surface/interaction_list.h"
#include "integral_invariant/moments/surface/kernels/arcs.h"
#include "integral_invariant/moments/surface/kernels/clip.h"
#include "integral_invariant/moments/surface/spherical_region.h"

namespace integral_invariant {

/// A corner that a sphere cuts off a triangle: the triangle, which of its vertices is alone, and whether that one is
/// outside.
class LocalCorner {
 public:
  LocalCorner() = default;
  /// \param vertex_and_side twice the vertex, one more where that is outside
  LocalCorner(std::uint32_t triangle, std::uint32_t vertex_and_side) : code_(triangle << 3 | vertex_and_side) {}

  std::uint32_t triangle() const { return code_ >> 3; }
  std::uint32_t vertex() const { return code_ >> 1 & 3; }
  bool is_outside() const { return code_ & 1; }
  /// Without a branch: sides are as good as random.
  double sign() const { return 1 - 2 * double(code_ & 1); }

 private:
  std::uint32_t code_;
};

/// What follows from the first scales of a triangle's three vertices: from its second one on the triangle is whole, and
/// from its least to before its largest one spheres cut a corner off. Corners as LocalCorner takes them.
struct TriangleScales {
  std::uint8_t least, median, most;
  std::uint8_t corner_at_least, corner_after;  ///< that is cut off at the least scale, and at the next one
  std::uint8_t is_cut, is_cut_again;           ///< whether there are such corners
  std::uint8_t last_corner;                    ///< that is cut off at the scales before the largest
};

struct TouchedTriangle {
  std::uint32_t triangle;
  TriangleScales scales;
};

/// What the last radius stands for: a ball like the others, or the rim, up to which the surface's whole triangles
/// belong to the near part; what leads on from there is FarField's.
enum class LastRadius { ball, rim };

/// Scratch memory and method for one worker.
class BallEvaluator {
 public:
  BallEvaluator(const std::vector<double>& radii, bool same_sheet, LastRadius last_radius = LastRadius::ball);

  /// Moments of the balls about local point `centre` at every scale; `normal` is about the surface's there (unit).
  /// `vicinity` has been narrowed to points that `centre` is one of.
  const std::vector<BallMoments>& evaluate(const InteractionList& near, CulledInteractions& vicinity,
                                           std::uint32_t centre, const Vec3& normal, bool is_border);

  /// Of the last evaluation: its outcome.
  const std::vector<BallMoments>& moments() const { return moments_; }
  /// Of the last evaluation, for the triangles of the vicinity's leaves: how far out they reach, as the first scale of
  /// their farthest vertex; the number of radii where that is beyond them all.
  const std::vector<std::uint8_t>& outermost_scales() const { return outermost_; }
  /// With a rim: moments of the cones from the centre to the triangles whose vertices are all within it. The last
  /// moments of evaluate() are those of the ball if the surface went on from there by rays away from the centre.
  const SolidMoments& rim_cones() const { return rim_cones_; }
  /// Angle of the gaps in the fan at the centre, for the largest radius.
  double gap_angle() const { return gap_angle_; }

 private:
  void clear();
  void add_rim(const InteractionList& near);
  void keep_own_sheet(const InteractionList& near, std::uint32_t centre);
  void tabulate_scales();
  void find_triangle_scales(const InteractionList& near, const CulledInteractions& vicinity);
  void sort_triangles();
  void add_whole_triangles(const InteractionList& near);
  void add_listed_corners(const InteractionList& near, std::uint32_t scale);
  void add_curved_corner(const LocalCorners& corners, LocalCorner corner, std::uint32_t scale);
  void add_large(const LocalCorners& corners, double longest_edge);
  void add_boundary_edges(const InteractionList& near);
  void add_boundary_edge(const LocalBoundaryEdge& edge);
  void add_ray(const LocalBoundaryEdge& edge);
  void close_surface();
  bool touches_centre(const std::array<Vec3, 3>& triangle) const;
  void finish();
  /// Relative to the balls' centre.
  Vec3 point(std::uint32_t i) const { return near_->point(i) - centre_; }

  const std::vector<double> radii_;
  std::vector<double> squared_radii_;
  const std::uint32_t scales_;
  const std::uint32_t cut_scales_;  ///< those whose spheres cut triangles: all but the rim
  const bool same_sheet_;
  std::vector<std::vector<std::uint32_t>> queue_;    ///< same_sheet: points found, per scale
  std::vector<std::uint8_t> own_scale_, rim_scale_;  ///< same_sheet: first scale that reaches a point, or its ring
  const InteractionList* near_ = nullptr;
  Vec3 pole_, centre_;
  std::vector<std::uint8_t> scale_of_;        ///< per local point: the first scale whose ball holds it
  std::vector<std::uint8_t> outermost_;       ///< per triangle
  std::vector<TriangleScales> scales_table_;  ///< by the first scales of three vertices
  std::vector<TouchedTriangle> touched_;
  std::size_t touched_count_ = 0;
  std::vector<std::vector<std::uint32_t>> whole_;  ///< per scale: triangles whose second vertex is inside from it on
  std::vector<std::uint32_t> whole_count_;
  std::vector<SolidMoments> shells_;               ///< whole triangles, by the first scale that holds them
  std::vector<std::vector<LocalCorner>> corners_;  ///< per scale: what its sphere cuts off
  std::vector<std::uint32_t> corner_count_;
  CornerBatch batch_;
  std::vector<CornerSums> cuts_;  ///< per scale: what belongs to that scale alone
  std::vector<ArcSums> shell_arcs_, cut_arcs_;
  ArcBatch arc_batch_;
  std::vector<std::uint32_t> rim_list_;
  SolidMoments rim_cones_;
  double gap_angle_ = 0;
  bool is_border_ = false;
  Vec3 normal_;
  std::vector<std::pair<FanRay, std::uint32_t>> rays_;  ///< and the first scale at which the ray's edge is inside
  std::vector<MissingArea> shell_missing_, cut_missing_;
  std::vector<BallMoments> moments_;
};

}  // namespace integral_invariant
