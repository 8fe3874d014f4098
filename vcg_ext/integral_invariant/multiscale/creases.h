// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 3: where the surface is folded rather than curved, and how far the other vertices are from there.
#pragma once

#include <vector>

#include "integral_invariant/ball_curvature/tensor_field.h"
#include "integral_invariant/mesh/surface.h"
#include "integral_invariant/multiscale/noise_level.h"
#include "integral_invariant/support/execution.h"

namespace integral_invariant {

/// Empty where the surface has no crease that shows.
struct Creases {
  int scale = 0;                ///< the one that shows them best
  std::vector<char> is_crease;  ///< n: on a crease, or within about an edge of it
  std::vector<float> distance;  ///< n: along the edges to the nearest crease; at least the largest radius means far
};

/// Across a fold the curvature of a ball falls as 1/r, over a smooth part it hardly depends on r: a crease is where
/// |κ|r stands out of the noise in the smallest ball beyond two edges, or under strong noise in the next, and |κ| falls
/// to the scale after it. Tensors of balls that a boundary cuts do not count, nor vertices through whose neighbours a
/// polynomial runs: `fits` tells a sharp ridge without noise from a fold, `is_smooth` (n flags, or nothing) another
/// sheet beside a smooth one. Creases are lines: what looks like one nearly everywhere or almost nowhere around, as
/// thin rods do under noise, is none. Cost O(n), and O(n log n) where there are creases.
Creases find_creases(const Surface& surface, const TensorField& tensors, const std::vector<Jet>& fits,
                     const NoiseLevel& noise, const std::vector<char>& is_smooth, Execution& execution);

}  // namespace integral_invariant
