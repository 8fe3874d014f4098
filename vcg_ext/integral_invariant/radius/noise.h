// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 3: how noisy the surface is, from the surface itself.
#pragma once

#include <vector>

#include "integral_invariant/curvature/scale_blend.h"
#include "integral_invariant/support/execution.h"
#include "integral_invariant/surface.h"

namespace integral_invariant {

/// Noise along the normal, one entry a vertex; normalised units.
struct Noise {
  std::vector<double> offset;   ///< δ: height of the smooth surface over the vertex
  std::vector<double> sigma;    ///< local standard deviation of δ
  std::vector<double> density;  ///< s² = σ² · (area a vertex); see disc_variance
  std::vector<double> flatness; ///< what the triangles' flatness costs: an error of the curvature of flatness / r⁴
  double mean_sigma = 0;        ///< root mean square of sigma
};

/// The offsets of two small balls, extrapolated to radius 0 (shape enters an offset with r⁴), are the vertex's own noise but
/// for a known share. Their mean square over the neighbourhood gives σ; vertices near a crease or a boundary are left out.
/// `offsets` are those of offset_free_measure(), scale by scale for each vertex. A `known_sigma` above 0 is taken instead of σ.
/// \pre at least two scales. Cost O(n).
Noise estimate_noise(const Surface& surface, const TensorField& tensors, const std::vector<float>& offsets,
                     double known_sigma, Execution& execution);

}  // namespace integral_invariant
