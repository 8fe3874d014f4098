// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 2: curvature tensor of one vertex at one scale that does not mind the vertex's own noise.
#pragma once

#include "integral_invariant/ball_curvature/curvature_tensor.h"
#include "integral_invariant/support/pi.h"

namespace integral_invariant {

/// What one ball says once the offset of its centre is taken for an unknown.
struct OffsetFreeMeasure {
  CurvatureTensor tensor;
  double offset = 0;  ///< δ: height of the smooth surface over the ball's centre along the normal, L
};

/// With V and the tangential part J_T of the covariance, to first order in δ and κ (docs/method.md §3):
/// 2H = −(48/(π r⁶)) (tr J_T − r² V/2 + (π/15) r⁵), K = H I − (24/(π r⁶)) (J_T − tr(J_T)/2 I) on the tangent plane,
/// δ = (V − (2π/3) r³ + (π/8) r⁴ 2H) / (π r²). This is the least squares fit of a paraboloid to the disc of radius r.
///
/// A ball without solid or without direction has K = 0, an arbitrary normal and confidence 0.
OffsetFreeMeasure offset_free_measure(const BallMoments& moments, double radius);

/// Variance of what offset_free_measure() finds under independent noise along the normal: these coefficients times the
/// noise density s² = σ² · (area a vertex) and a power of 1/r. The discs of the scales are nested and each fit is the
/// best on its disc, so that the difference between two scales is independent of the larger one: its variance is the
/// difference of theirs.
namespace disc_variance {
inline constexpr double mean_curvature = 48 / pi;  ///< of H: × s²/r⁶
inline constexpr double deviator = 24 / pi;        ///< of either component of K − H I: × s²/r⁶
inline constexpr double normal = 4 / pi;           ///< of either tangential component of the normal: × s²/r⁴
inline constexpr double height = 4 / pi;           ///< of the height of the fit over the centre: × s²/r²
}  // namespace disc_variance

}  // namespace integral_invariant
