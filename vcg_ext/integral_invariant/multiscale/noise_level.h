// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 3: how noisy the surface is, from the surface itself.
#pragma once

#include <vector>

#include "integral_invariant/ball_curvature/tensor_field.h"
#include "integral_invariant/jets/jet_fit.h"
#include "integral_invariant/mesh/surface.h"
#include "integral_invariant/multiscale/noise_transfer.h"

namespace integral_invariant {

/// Smaller balls, over σ, are not linear in the noise and say nothing.
inline constexpr double least_radius_over_sigma = 6;

inline constexpr double usual_area = 0.87;  ///< of a vertex of an even mesh, ē²
/// Measured on a sphere: the curvature of its triangulation is off by 0.11 e⁴/r⁴, e the edge length.
inline constexpr double flatness_error = 0.11;

/// Noise along the normal, one entry a vertex; normalised units.
struct NoiseLevel {
  std::vector<double> offset;   ///< δ: height of the smooth surface over the vertex
  std::vector<double> sigma;    ///< local standard deviation of δ
  std::vector<double> density;  ///< s² = σ² · (area a vertex); see disc_variance
  std::vector<double>
      faceting_error;  ///< what the triangles' flatness costs: an error of the curvature of faceting_error / r⁴
  std::vector<double> lack_of_fit;  ///< of σ², 0 to 1: how much of it is shape beyond polynomials instead
  std::vector<char> defies_jets;    ///< whether the noise is too smooth there for polynomials to tell it from shape
  NoiseTransfer transfer;           ///< of the noise's correlation
  double mean_sigma = 0;            ///< root mean square of sigma
};

/// σ² is the mean over the neighbourhood of what the polynomials through the nearest vertices leave over
/// (Jet::residual_variance), without those that stand far out of it, as on creases; it knows no flat triangles, and δ/r
/// does not enter. The offset is extrapolated from two small balls to radius 0 (shape enters an offset with r⁴).
/// `offsets` are those of offset_free_measure(), scale by scale for each vertex. A `known_sigma` above 0 is taken
/// instead of σ, and for noise alone. Noise stands in the polynomials' terms of the highest degree as much as in what
/// is beyond them, shape falls from degree to degree: that tells lack_of_fit. \pre at least two scales. Cost O(n).
NoiseLevel estimate_noise_level(const Surface& surface, const TensorField& tensors, const std::vector<float>& offsets,
                                const std::vector<Jet>& fits, double known_sigma, Execution& execution);

}  // namespace integral_invariant
