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

/// Where the tensor of a (vertex, scale) comes from. Doubted: from the ball, which another sheet may cut;
/// find_whole_balls leaves none.
enum class Origin : unsigned char { none, vertices, own, doubted };

/// Share of its disc that a whole ball sees at least.
constexpr double least_confidence = 0.95;

struct WholeBalls {
  std::vector<Origin> origin;  ///< n × scales
  std::vector<int> largest;    ///< n: the largest scale to be used
  /// n × scales, or empty where every ball is whole: of a tensor from vertices, the variances of VertexFit over σ²
  /// (mean, deviator, normal).
  std::vector<std::array<float, 3>> variance;
};

/// A ball that misses more than a twentieth of its disc (the surface ends there), meets another sheet, or reaches over
/// a crease gives way to a fit to vertices of what is left of the disc, which ends at creases. So does a ball that is
/// somewhat smaller than one that meets another sheet, where it contradicts the disc: what it misses of the solid hides
/// in the noise. What a quadric does not fit, and larger discs, say nothing. `offsets` are those of
/// offset_free_measure(), scale by scale for each vertex. A vertex's largest scale is the one before balls stop being
/// nearly a half: where |κ| r passes 1.3 or the normal turns away, because the ball meets another sheet or the whole of
/// a small part; on a crease it is the smallest that noise leaves. Changes `tensors` where the origin is vertices. Cost
/// O(n · scales), and 15 µs a vertex whose largest balls give way.
WholeBalls find_whole_balls(const Surface& surface, const std::vector<float>& offsets,
                            const std::vector<VertexFit>& fits, const Noise& noise, bool removes_bias,
                            TensorField& tensors, Execution& execution);

}  // namespace integral_invariant
