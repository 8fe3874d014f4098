// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 3: which scales of a vertex can be trusted, and substitutes for those that reach over a boundary.
#pragma once

#include <array>
#include <vector>

#include "integral_invariant/curvature/scale_blend.h"
#include "integral_invariant/radius/noise.h"
#include "integral_invariant/support/execution.h"
#include "integral_invariant/surface.h"

namespace integral_invariant {

/// Where the tensor of a (vertex, scale) comes from.
enum class Origin : unsigned char { none, vertices, own };

/// Smaller balls, over σ, are not linear in the noise and say nothing.
inline constexpr double least_radius_over_sigma = 6;

struct WholeBalls {
  std::vector<Origin> origin;  ///< n × scales
  std::vector<int> largest;    ///< n: the largest scale to be used
  /// n × scales, or empty where every ball is whole: of a tensor from vertices, the variances of VertexFit over σ²
  /// (mean, deviator, normal).
  std::vector<std::array<float, 3>> variance;
};

/// A ball that misses more than a twentieth of its disc (the surface ends there) gives way to a fit to the vertices of
/// what is left of the disc (VertexFitter::discs). A vertex's largest scale is the one before balls stop being nearly a
/// half: where |κ| r passes 1.3 or the normal turns away, because the ball meets a crease, another sheet, or the whole
/// of a small part. Changes `tensors` where the origin is vertices. Cost O(n · scales), and 50 µs a vertex whose
/// largest balls are cut.
WholeBalls find_whole_balls(const Surface& surface, const Noise& noise, bool removes_bias, TensorField& tensors,
                            Execution& execution);

}  // namespace integral_invariant
