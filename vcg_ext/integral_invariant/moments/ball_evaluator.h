// SPDX-License-Identifier: GPL-3.0-or-later
// Surface engine: the moments of all balls about one point of a neighbourhood.
#pragma once

#include <vector>

#include "integral_invariant/moments/ball_boundary.h"
#include "integral_invariant/moments/neighbourhood.h"

namespace integral_invariant {

/// Scratch memory and method for one worker.
class BallEvaluator {
 public:
  explicit BallEvaluator(const std::vector<double>& radii);

  /// Moments of the balls about local point `centre` at every scale; `normal` is about the surface's there (unit).
  const std::vector<BallMoments>& evaluate(const Neighbourhood& near, std::uint32_t centre, const Vec3& normal,
                                           bool is_border);

 private:
  void clear();
  void place_points(const Neighbourhood& near);
  void add_triangle(const LocalTriangle& triangle);
  void add_corner(const LocalTriangle& triangle, int lone, std::uint32_t scale, bool lone_is_inside);
  void add_large(const LocalTriangle& triangle, std::uint32_t first_scale, std::uint32_t end_scale);
  void add_free_edge(const LocalFreeEdge& edge);
  void finish();

  const std::vector<double> radii_;
  const std::uint32_t scales_;
  Vec3 pole_, centre_;
  std::vector<Vec3> points_;                ///< local points relative to the balls' centre
  std::vector<std::uint8_t> scale_of_;      ///< per local point: the first scale whose ball holds it
  std::vector<MomentSums> shells_, cuts_;   ///< whole triangles by their first scale; pieces of one scale
  std::vector<ArcSums> shell_arcs_, cut_arcs_;
  std::vector<BallMoments> moments_;
};

}  // namespace integral_invariant
