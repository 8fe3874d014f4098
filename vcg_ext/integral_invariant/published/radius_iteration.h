// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 3: the radius of every vertex, adapted to the size of its feature [Lai09 4.2].
#pragma once

#include <cstddef>
#include <vector>

#include "integral_invariant/ball_curvature/tensor_field.h"
#include "integral_invariant/parameters.h"
#include "integral_invariant/support/execution.h"

namespace integral_invariant {

/// Start of the iteration per vertex: the median over the scales of the smallest principal radius 1/max|κ|, clamped to
/// the range of the scales; or the middle of that range.
std::vector<double> start_radii(const TensorField& tensors, StartRadius rule, Execution& execution);

struct AdaptedRadii {
  std::vector<double> radius;  ///< n, normalised unit, within the range of the scales
  std::size_t converged = 0;   ///< vertices whose last relative change fell under the tolerance
  double mean_iterations = 0;  ///< over all vertices
  int largest_iterations = 0;
};

/// r ← r + λ (r′ − r), r′ = α / max(|κ_max|, |κ_min|) clamped to the range of the scales, per vertex until the relative
/// change is under the tolerance or max_iterations is reached [Lai09 eq. 7, 8]. Cost O(iterations) a vertex.
AdaptedRadii adapt_radii(const TensorField& tensors, std::vector<double> start, const Parameters& parameters,
                         Execution& execution);

}  // namespace integral_invariant
