// SPDX-License-Identifier: GPL-3.0-or-later
// Surface engine: the moments of all balls about one point of a neighbourhood.
#pragma once

#include <vector>

#include "integral_invariant/moments/ball_boundary.h"
#include "integral_invariant/moments/ball_kernels.h"
#include "integral_invariant/moments/neighbourhood.h"
#include "integral_invariant/moments/vertex_fan.h"

namespace integral_invariant {

/// Angles under which free edges are seen from the centre, signed: positive where the surface ends there, negative where
/// it begins again; and the same times the squared distance. The area missing from a flat disc is ½ (r² angle − moment).
struct MissingSurface {
  double angle = 0, moment = 0;
};

/// A corner that a sphere cuts off a triangle: its vertex, alone inside (sign +1) or outside (−1), and the other two.
struct LocalCorner {
  std::uint32_t lone, next, previous;
  std::int32_t sign;
  std::uint32_t triangle;
};

/// Scratch memory and method for one worker.
class BallEvaluator {
 public:
  BallEvaluator(const std::vector<double>& radii, bool same_sheet);

  /// Moments of the balls about local point `centre` at every scale; `normal` is about the surface's there (unit).
  const std::vector<BallMoments>& evaluate(const Neighbourhood& near, std::uint32_t centre, const Vec3& normal,
                                           bool is_border);

 private:
  void clear();
  void place(const Neighbourhood& near);
  void keep_own_sheet(const Neighbourhood& near, std::uint32_t centre);
  void sort_triangles(const Neighbourhood& near);
  void add_whole_triangles(const Neighbourhood& near);
  void list_corners(const Neighbourhood& near);
  void add_listed_corners(const Neighbourhood& near, std::uint32_t scale);
  void add_curved_corner(const LocalCorner& corner, std::uint32_t scale);
  void add_large(const LocalCorners& corners, const LocalTriangle& triangle);
  void add_free_edges(const Neighbourhood& near);
  void add_free_edge(const LocalFreeEdge& edge);
  void add_ray(const LocalFreeEdge& edge);
  void close_surface();
  bool touches_centre(const std::array<Vec3, 3>& triangle) const;
  void finish();
  Vec3 point(std::uint32_t i) const { return {x_[i], y_[i], z_[i]}; }

  const std::vector<double> radii_;
  std::vector<double> squared_radii_;
  const std::uint32_t scales_;
  const bool same_sheet_;
  std::vector<std::vector<std::uint32_t>> queue_;        ///< same_sheet: points found, per scale
  std::vector<std::int64_t> own_scale_, rim_scale_;      ///< same_sheet: first scale that reaches a point, or its ring
  Vec3 pole_, centre_;
  std::vector<double> x_, y_, z_;           ///< local points relative to the balls' centre
  std::vector<std::int64_t> scale_of_;      ///< per local point: the first scale whose ball holds it
  std::vector<std::vector<std::uint32_t>> whole_;        ///< per scale: triangles whose second vertex is inside from it on
  std::vector<std::uint32_t> whole_count_, cut_;         ///< and those that some sphere cuts
  std::size_t cut_count_ = 0;
  std::vector<MomentSums> shells_;          ///< whole triangles, by the first scale that holds them
  std::vector<std::vector<LocalCorner>> corners_;       ///< per scale: what its sphere cuts off
  std::vector<std::uint32_t> corner_count_;
  CornerBatch batch_;
  std::vector<CornerSums> cuts_;            ///< per scale: what belongs to that scale alone
  std::vector<ArcSums> shell_arcs_, cut_arcs_;
  bool is_border_ = false;
  Vec3 normal_;
  std::vector<std::pair<FanRay, std::uint32_t>> rays_;  ///< and the first scale at which the ray's edge is inside
  std::vector<MissingSurface> shell_missing_, cut_missing_;
  std::vector<BallMoments> moments_;
};

}  // namespace integral_invariant
