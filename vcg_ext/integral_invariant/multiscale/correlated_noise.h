// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 3: noise that is correlated from vertex to vertex, told from shape by its spectrum over the scales.
#pragma once

#include <vector>

#include "integral_invariant/ball_curvature/tensor_field.h"
#include "integral_invariant/mesh/surface.h"
#include "integral_invariant/multiscale/noise_level.h"
#include "integral_invariant/support/execution.h"

namespace integral_invariant {

/// Noise as pipelines leave it (smoothed, reconstructed, voxelised, rounded); normalised units.
struct CorrelatedNoise {
  double correlation = 0;     ///< ℓ of NoiseTransfer, ē
  std::vector<double> sigma;  ///< n: standard deviation along the normal; 0 where the scales show none
};

/// The mean squares of the differences between neighbouring scales, averaged over places of about twice the radius, are
/// explained as noise with one correlation length all over the mesh plus shape, which is free at each place but falls
/// towards small scales faster than noise does:
///     C_i(place) ~ (σ² N_i(ℓ) + a S_i(p)) χ²_ν / ν,
/// and ℓ and σ are where the sum of the places' best log likelihoods is largest. What polynomials leave over at the
/// vertices (`white.sigma`) is one more, finest scale, which bounds noise of short correlation. Noise has to be
/// Gaussian as well: where the differences have another kurtosis it is taken for shape. `tensors` are offset-free. Cost
/// O(n · scales), about 3 µs a vertex, and 0.2 s once.
CorrelatedNoise find_correlated_noise(const Surface& surface, const TensorField& tensors, const NoiseLevel& white,
                                      Execution& execution);

/// Makes `noise` that of both: what the polynomials see, and what the scales show beyond it, a little more rather than
/// less, because noise that is taken for shape costs much and shape that is taken for noise little.
void add_correlated_noise(const CorrelatedNoise& correlated, NoiseLevel& noise, Execution& execution);

}  // namespace integral_invariant
