// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 2: what a ball of finite radius reads wrongly, and its removal.
#pragma once

#include "integral_invariant/ball_curvature/offset_free.h"
#include "integral_invariant/ball_curvature/tensor_field.h"

namespace integral_invariant {

/// The offset-free tensor without the errors that follow from the curvature and the offset themselves:
/// - of third order in κr: a surface whose curvature does not change has the height −(k/2)ρ² − (k k₂/8)ρ⁴ along the
///   direction with normal curvature k (k₂ that of K²), which shifts 2H by −(r²/π) ∫ (k³/2 − k k₂/4) dφ; on a sphere
///   −κ³ r²/2, on a cylinder −κ³ r²/8;
/// - of the parallel surface: the ball sees the surface at the distance of its centre, K (1 + K δ)⁻¹ from K;
/// - of second and third order in δ/r and in the noise σ of the surface around.
/// \param noise_variance σ², L²
CurvatureTensor correct_ball_bias(const CurvatureTensor& measured, double radius, double offset, double noise_variance);

/// The same for a fit of heights over a disc of radius r (JetFitter::extend_disc), which has the third order alone: the
/// height's −(k k₂/8)ρ⁴ reads as (r²/4) k k₂ in the mean curvature and as 3/4 of its share in the deviator.
CurvatureTensor correct_jet_bias(const CurvatureTensor& measured, double radius);

/// Replaces the tensor of each scale by K₀ of the fit K(r) = K₀ + c r² to all scales up to it, weighted by the
/// variances of disc_variance: the term of fourth order in the surface's height, which no single ball can tell from
/// curvature.
void extrapolate_to_zero_radius(TensorField& tensors, Execution& execution);

}  // namespace integral_invariant
