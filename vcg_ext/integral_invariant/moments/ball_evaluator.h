// SPDX-License-Identifier: GPL-3.0-or-later
// Surface engine: the moments of all balls about one point of a neighbourhood.
#pragma once

#include <vector>

#include "integral_invariant/moments/ball_boundary.h"
#include "integral_invariant/moments/ball_kernels.h"
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
  void place(const Neighbourhood& near);
  void add_triangle(const LocalCorners& corners, const LocalTriangle& triangle);
  void add_whole(const LocalTriangle& triangle, std::uint32_t scale);
  void add_corner(const LocalCorners& corners, int lone, std::uint32_t scale, bool lone_is_inside);
  void add_large(const LocalCorners& corners, const LocalTriangle& triangle);
  void add_free_edge(const LocalFreeEdge& edge);
  void flush(std::uint32_t scale);
  void finish();
  Vec3 point(std::uint32_t i) const { return {x_[i], y_[i], z_[i]}; }

  const std::vector<double> radii_;
  std::vector<double> squared_radii_;
  const std::uint32_t scales_;
  Vec3 pole_, centre_;
  std::vector<double> x_, y_, z_;           ///< local points relative to the balls' centre
  std::vector<std::int64_t> scale_of_;      ///< per local point: the first scale whose ball holds it
  std::vector<MomentSums> shells_;          ///< whole triangles, by the first scale that holds them
  std::vector<CornerBatch> batches_;        ///< per scale: corners to come
  std::vector<char> is_wide_;               ///< per scale: some corner of the batch may have a long chord
  std::vector<CornerSums> cuts_;            ///< per scale: what belongs to that scale alone
  std::vector<ArcSums> shell_arcs_, cut_arcs_;
  std::vector<BallMoments> moments_;
};

}  // namespace integral_invariant
