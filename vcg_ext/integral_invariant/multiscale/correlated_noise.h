// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 3: noise that is correlated from vertex to vertex, told from shape by its spectrum over the scales.
#pragma once

#include <vector>

#include "integral_invariant/ball_curvature/tensor_field.h"
#include "integral_invariant/mesh/surface.h"
#include "integral_invariant/multiscale/coordinate_lattice.h"
#include "integral_invariant/multiscale/noise_level.h"
#include "integral_invariant/support/execution.h"

namespace integral_invariant {

/// Noise as pipelines leave it (smoothed, reconstructed, voxelised, rounded); normalised units.
struct CorrelatedNoise {
  double correlation = 0;      ///< ℓ of NoiseTransfer, ē
  std::vector<double> sigma;   ///< n: standard deviation along the normal; 0 where the scales show none
  bool is_of_lattice = false;  ///< steps or ripples of a grid, which vertices follow smoothly for several edges
};

/// The mean squares of the differences between neighbouring scales (ScaleSpectrum) are explained as noise with one
/// correlation length all over the mesh plus shape, which is free at each place but smooth, so that it falls towards
/// small scales faster than independent noise, by the fourth or fifth power of the radius:
///     C_i(place) ~ (σ² N_i(ℓ) + a S_i(p)) χ²_ν / ν,
/// and ℓ and σ are where the sum of the places' best log likelihoods is largest. Real relief falls less fast as well,
/// but its differences are not Gaussian: they have another kurtosis than noise, within a neighbourhood or over a wide
/// one, and then none is found. Of coordinates in steps and of surfaces out of a grid (CoordinateLattice) no kurtosis
/// is asked: there the steps are noise, whatever their distribution. `tensors` are offset-free. Cost O(n · scales),
/// about 4 µs a vertex, and 0.1 s once.
CorrelatedNoise find_correlated_noise(const Surface& surface, const CoordinateLattice& lattice,
                                      const TensorField& tensors, Execution& execution);

/// Makes `noise` that of both: what the polynomials see, and what the scales show beyond it, a little more rather than
/// less, because noise that is taken for shape costs much and shape that is taken for noise little.
void add_correlated_noise(const CorrelatedNoise& correlated, NoiseLevel& noise, Execution& execution);

}  // namespace integral_invariant
