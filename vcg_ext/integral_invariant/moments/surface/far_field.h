// SPDX-License-Identifier: GPL-3.0-or-later
// Surface engine: moments of large balls from what is known up to their rim and points beyond it.
#pragma once

#include <cstdint>
#include <vector>

#include "integral_invariant/moments/surface/ball_evaluator.h"
#include "integral_invariant/moments/surface/coverage.h"
#include "integral_invariant/moments/surface/far_field_sources.h"

namespace integral_invariant {

/// Which radii are treated in closed form, and which ones by points beyond the rim.
struct ScaleSplit {
  std::vector<double> near;  ///< with the rim as the last one, unless `far` is empty
  std::vector<double> far;

  /// Of increasing radii, in edges; all in closed form where what is beyond is not worth it.
  static ScaleSplit of(const std::vector<double>& radii);
  /// All in closed form.
  static ScaleSplit none(const std::vector<double>& radii) { return {radii, {}}; }
};

/// Up to which distances, in edges, triangles beyond the rim count by more than a point.
struct FarDetail {
  double shape;  ///< shells that begin nearer: by their shape
  double kink;   ///< balls that are smaller: by how their sphere cuts them
};

/// Beyond the rim the field f x/(d+3) (1 − (r/|x|)^{d+3}) has no flux through the sphere r, so that triangles need not
/// be clipped there. For one worker.
class FarField {
 public:
  FarField(const SurfaceTree& tree, const ScaleSplit& split, const FarDetail& detail);

  /// To another block.
  void enter(const InteractionList& near);
  /// To its points [begin, end), which should lie close together.
  void narrow(std::uint32_t begin, std::uint32_t end);
  /// Moments at the far radii about `centre`, one of these points, for which `evaluator` has just been run with
  /// `rim_moments` as the last outcome.
  const std::vector<BallMoments>& evaluate(const BallEvaluator& evaluator, std::uint32_t centre,
                                           const BallMoments& rim_moments, bool is_border);
  /// The last outcome.
  const std::vector<BallMoments>& moments() const { return moments_; }

 private:
  /// Fills least_ and largest_.
  void find_ranges(const SphereColumns& spheres, const Vec3& centre, double extent);
  void sort_leaves(const std::vector<std::uint8_t>& outermost_scales, const Vec3& centre);
  std::uint32_t list_leaves(std::size_t k, std::size_t reached, std::vector<WeightedPacket>& list) const;
  std::uint32_t weigh_rim_leaf(std::uint32_t i, const std::vector<std::uint8_t>& outermost_scales, const Vec3& centre);
  void sort_clusters(const Vec3& centre);
  void find_confidence(const Vec3& centre, double gap_angle, bool is_border);

  const std::vector<double> radii_, rim_;  ///< rim, then the far ones; the rim alone
  const FarDetail detail_;
  std::vector<double> squared_radii_;
  const std::uint8_t outside_;  ///< first scale of points beyond the rim
  const InteractionList* near_ = nullptr;
  FarFieldSources far_;
  std::vector<std::uint32_t> leaves_, clusters_;  ///< of the block, that the narrowed points' balls need
  std::size_t rim_leaves_ = 0;                    ///< how many of these leaves, the first ones, a rim may cut
  SphereColumns point_spheres_, triangle_spheres_, cluster_spheres_;  ///< of these; of the first ones' triangles
  std::vector<LaneWeights> weights_;       ///< ones, then those of the leaves that the rim cuts
  std::vector<std::uint32_t> weights_of_;  ///< of each leaf
  std::vector<std::uint8_t> least_, largest_, least_side_, largest_side_;  ///< scales; sides of the rim
  std::vector<std::vector<WeightedPacket>> points_in_, points_at_;         ///< per shell; per sphere that ends one
  std::vector<std::vector<std::uint32_t>> clusters_in_;
  std::vector<std::uint32_t> point_count_, kink_count_, cluster_count_;  ///< of them that are valid
  std::vector<MissingArea> missing_;
  std::vector<BallMoments> moments_;
};

}  // namespace integral_invariant
